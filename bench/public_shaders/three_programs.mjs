// Writes the shaders that three.js hands to WebGL: its own WebGLProgram puts them together, from the
// chunks of its ShaderLib, for a WebGL that only takes notes.
//
//     node three_programs.mjs FOLDER-OF-THE-PACKAGE FOLDER-FOR-SHADERS

import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [ root, out ] = process.argv.slice( 2 );
const load = ( ...parts ) => import( pathToFileURL( join( root, ...parts ) ) );

// three.js says what it thinks of fake materials.
console.warn = console.error = console.log = () => {};

const { ShaderLib } = await load( 'src', 'renderers', 'shaders', 'ShaderLib.js' );
const { WebGLProgram } = await load( 'src', 'renderers', 'webgl', 'WebGLProgram.js' );
const constants = await load( 'src', 'constants.js' );

const noted = [];
const gl = new Proxy( { VERTEX_SHADER: 'vert', FRAGMENT_SHADER: 'frag', createShader: stage => ( { stage } ),
	shaderSource: ( shader, text ) => noted.push( { stage: shader.stage, text } ) },
{ get: ( object, key ) => object[ key ] ?? ( () => null ) } );
const renderer = { getContext: () => gl, debug: { checkShaderErrors: false } };

const counts = [ 'SunLights', 'DirLights', 'SpotLights', 'SpotLightMaps', 'RectAreaLights', 'PointLights',
	'HemiLights', 'SunLightShadows', 'DirLightShadows', 'PointLightShadows', 'SpotLightShadows',
	'SpotLightShadowsWithMaps', 'LightProbes', 'LightProbeGrids', 'ClippingPlanes', 'ClipIntersection' ];
// Some releases of glslang count `average` among the built-in functions, where three.js defines its own.
const defines = { average: 'averageOf' };
const bare = Object.fromEntries( counts.map( name => [ 'num' + name, 0 ] ) );
Object.assign( bare, { defines, precision: 'highp', vertexNormals: true, opaque: true, outputColorSpace: 'srgb',
	useDepthPacking: true, depthPacking: constants.RGBADepthPacking, toneMapping: constants.NoToneMapping, shadowMapType: constants.PCFShadowMap, envMap: false } );

const on = names => Object.fromEntries( names.split( ' ' ).map( name => [ name, true ] ) );
const maps = names => Object.assign( on( names ),
	Object.fromEntries( names.split( ' ' ).map( name => [ name + 'Uv', 'uv' ] ) ) );

const lights = { numDirLights: 2, numPointLights: 2, numSpotLights: 2, numHemiLights: 1, numRectAreaLights: 1 };
const shadows = { shadowMapEnabled: true, numDirLightShadows: 1, numPointLightShadows: 1, numSpotLightShadows: 1,
	numSpotLightMaps: 1, numSpotLightShadowsWithMaps: 1 };
const textured = Object.assign( on( 'vertexUv1s vertexColors normalMapTangentSpace' ), maps(
	'map alphaMap aoMap lightMap emissiveMap normalMap specularMap roughnessMap metalnessMap displacementMap' ) );
const moving = Object.assign( on( 'skinning morphTargets morphNormals instancing instancingColor batching' ),
	{ morphTargetsCount: 2, morphTextureStride: 2 } );
const layered = Object.assign( on( 'clearcoat sheen transmission iridescence anisotropy dispersion vertexTangents' ),
	maps( 'map clearcoatMap clearcoatNormalMap clearcoatRoughnessMap sheenColorMap sheenRoughnessMap iridescenceMap '
		+ 'transmissionMap thicknessMap anisotropyMap specularIntensityMap specularColorMap' ) );
const reflecting = { envMap: true, envMapPMREM: true, envMapMode: constants.CubeReflectionMapping, envMapMaxLod: 8,
	envMapSize: 256, combine: constants.MixOperation, toneMapping: constants.ACESFilmicToneMapping };
const mirroring = { ...reflecting, envMapPMREM: false };
const cut = Object.assign( on( 'alphaTest alphaHash dithering doubleSided flatShading logarithmicDepthBuffer' ),
	{ numClippingPlanes: 3, numClipIntersection: 1, useFog: true, fog: true, fogExp2: true, opaque: false } );

const settings = { bare: {}, lit: lights, shadowed: { ...lights, ...shadows }, textured: { ...textured, ...lights },
	moving: { ...moving, ...lights }, layered: { ...layered, ...lights }, reflecting: { ...reflecting, ...textured },
	mirroring: { ...mirroring, ...textured, ...lights },
	cut: { ...cut, map: true, mapUv: 'uv' },
	everything: { ...lights, ...shadows, ...textured, ...layered, ...reflecting, ...cut } };

const assemble = ( name, material, parameters ) => {

	noted.length = 0;
	new WebGLProgram( renderer, '', { ...bare, shaderName: name, shaderType: 'Material', ...parameters,
		vertexShader: material.vertexShader, fragmentShader: material.fragmentShader }, {} );
	for ( const { stage, text } of noted ) {

		const file = join( out, `${ name }.${ stage }` );
		mkdirSync( dirname( file ), { recursive: true } );
		writeFileSync( file, text );

	}

};

for ( const [ id, material ] of Object.entries( ShaderLib ) )
	for ( const [ name, parameters ] of Object.entries( settings ) )
		assemble( `ShaderLib/${ id }.${ name }`, material, parameters );

const isMaterial = value => typeof value?.fragmentShader === 'string' && typeof value.vertexShader === 'string';
const folder = join( 'examples', 'jsm', 'shaders' );

for ( const file of readdirSync( join( root, folder ) ).sort() )
	for ( const [ name, material ] of Object.entries( await load( folder, file ) ).filter( ( [ , v ] ) => isMaterial( v ) ) )
		assemble( `examples/${ file }/${ name }`, material, { defines: { ...defines, ...material.defines }, glslVersion: material.glslVersion } );

// Writes each transition inside the prelude of each host: transitions.mjs PACKAGE HOSTS FOLDER
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, parse } from 'node:path';

const [ root, hosts, out ] = process.argv.slice( 2 );
const transitions = JSON.parse( readFileSync( join( root, 'gl-transitions.json' ), 'utf8' ) );

for ( const host of readdirSync( hosts ) ) {

	const prelude = readFileSync( join( hosts, host ), 'utf8' );
	mkdirSync( join( out, parse( host ).name ), { recursive: true } );
	for ( const { name, glsl } of transitions )
		writeFileSync( join( out, parse( host ).name, name + '.frag' ), prelude.replace( 'TRANSITION', () => glsl ) );

}

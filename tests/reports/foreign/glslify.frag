precision mediump float;

#pragma glslify: snoise3 = require(glsl-noise/simplex/3d)
#pragma glslify: hsl2rgb = require('glsl-hsl2rgb')

uniform float time;
varying vec2 vUv;

void main() {
  float n = snoise3(vec3(vUv * 3.0, time * 0.25));
  vec3 color = hsl2rgb(vec3(n * 0.1 + 0.6, 0.5, 0.5));
  gl_FragColor = vec4(color, 1.0);
}

/* The same for WebGL 2:
#version 300 es
*/
// #version 330
precision highp float;
uniform sampler2D u_map;
uniform vec2 u_size;

void main() {
    vec2 uv = gl_FragCoord.xy / u_size;
    gl_FragColor = texture2D(u_map, uv) * sin(exp(uv.x) * 30.0) * cos(exp(uv.y) * 20.0);
}

#version 120
varying vec3 v_position;
varying vec3 v_normal;
uniform sampler2D u_mipmapped;
void main() {
    vec4 a = texture2D(u_mipmapped, v_position.xy * 2.0, 1.5);
    gl_FragColor = a * v_normal.x;
}

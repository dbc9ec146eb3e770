precision highp float;
attribute vec3 a_position;
uniform mat4 u_modelViewProjection;
varying vec3 v_position;

void main() {
    v_position = a_position;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

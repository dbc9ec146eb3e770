attribute vec3 a_position;
attribute vec2 a_uv;
uniform mat4 u_modelViewProjection;
varying vec2 v_uv;
varying vec3 v_position;

void main() {
    v_uv = a_uv;
    v_position = a_position;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

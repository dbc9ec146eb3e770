#version 330
// shadercache: payload-alone, node stone.1-ae098caa

invariant gl_Position;
in vec3 a_position;
uniform mat4 u_modelViewProjection;
out vec3 v_position;

void main() {
    v_position = a_position;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

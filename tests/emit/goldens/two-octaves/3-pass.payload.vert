#version 330
// shadercache: 3-pass.payload, node stone.1-ae098caa

invariant gl_Position;
out vec4 sc_current;
in vec3 a_position;
uniform mat4 u_modelViewProjection;
out vec3 v_position;

void sc_vertex() {
    v_position = a_position;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
}

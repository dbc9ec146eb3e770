#version 330
// shadercache: 3-pass.payload, node stone.1-ae098caa

invariant gl_Position;
out vec4 sc_current;
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_modelViewProjection;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;

void sc_vertex() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_position.xy;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
}

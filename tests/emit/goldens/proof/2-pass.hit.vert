#version 400
// shadercache: 2-pass.hit, node stone.1-ae098caa

invariant gl_Position;
precise invariant out vec4 sc_current;
precise invariant out vec4 sc_previous;
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_modelViewProjection;
precise invariant out vec3 v_position;
precise invariant out vec3 v_normal;
precise invariant out vec2 v_uv;

void sc_vertex() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_position.xy;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

uniform mat4 sc_previous_u_modelViewProjection;

void sc_vertex_previous() {
    sc_previous = sc_previous_u_modelViewProjection * vec4(a_position, 1.0);
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}

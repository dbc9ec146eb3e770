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

vec4 sc_mat4_times_vec4(mat4 a, vec4 b) {
    precise vec4 sc_exact_1 = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    return sc_exact_1;
}

void sc_vertex() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_position.xy;
    precise vec4 sc_exact_1 = vec4(a_position, 1.0);
    gl_Position = sc_mat4_times_vec4(u_modelViewProjection, sc_exact_1);
}

uniform mat4 sc_previous_u_modelViewProjection;

void sc_vertex_previous() {
    precise vec4 sc_exact_1 = vec4(a_position, 1.0);
    sc_previous = sc_mat4_times_vec4(sc_previous_u_modelViewProjection, sc_exact_1);
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}

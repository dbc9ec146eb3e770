#version 330 core
// Struct varyings, filled by a constructor and member by member, and an array.
struct Surface { vec3 at; vec4 clip; vec2 uv; };
in vec3 a_position; in vec2 a_uv;
uniform mat4 u_mvp;
out Surface v_s; out Surface v_t; out vec4 v_rows[3];
void main() {
    gl_Position = u_mvp * vec4(a_position, 1.0);
    v_s = Surface(a_position, gl_Position, a_uv);
    v_t.at = a_position; v_t.clip = gl_Position; v_t.uv = a_uv;
    v_rows = vec4[3](vec4(a_uv, a_uv), gl_Position, vec4(1.0));
    v_rows[2] = vec4(a_position, 0.0);
}

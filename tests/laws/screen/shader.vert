#version 400
in vec3 a_position;
in vec3 a_normal;
in vec2 a_uv;
uniform mat4 u_mvp;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
out vec4 v_clip;
noperspective out vec2 v_linear;
out Seen { vec2 place; float far; } seen;

void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_uv;
    gl_Position = u_mvp * vec4(a_position, 1.0);
    v_clip = gl_Position;
    v_linear = a_uv;
    seen.place = gl_Position.xy / gl_Position.w;
    seen.far = gl_Position.w;
}

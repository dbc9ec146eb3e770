#version 330 core
// The position read back, in parts, packed and in a block.
in vec3 a_position; in vec2 a_uv;
uniform mat4 u_mvp; uniform vec2 u_size;
out vec2 v_screen; out vec4 v_packed; out vec3 v_half; out float v_depth; out vec2 v_near;
out Surface { vec3 at; vec4 clip; vec2 uv; } surface;
vec2 toScreen(vec4 p) { return (p.xy / p.w * 0.5 + 0.5) * u_size; }
void main() {
    gl_Position = u_mvp * vec4(a_position, 1.0);
    v_screen = toScreen(gl_Position);
    v_packed = vec4(a_uv, gl_Position.yx);
    v_half.xz = a_uv; v_half.y = gl_Position[1];
    v_depth = 1.0 + gl_Position.w;
    v_near = gl_Position.zw;
    surface.at = a_position; surface.uv = a_uv; surface.clip = gl_Position;
}

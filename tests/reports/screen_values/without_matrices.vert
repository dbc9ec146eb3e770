#version 330 core
// A plane that is moved and scaled on the screen.
in vec2 a_position; in vec2 a_uv;
uniform vec2 u_offset; uniform float u_zoom;
out vec2 v_screen; out vec2 v_tile; out vec2 v_uv;
void main() {
    vec2 tile = a_position * 3.0;
    vec2 screen = tile * u_zoom + u_offset;
    v_screen = screen * 0.5 + 0.5; v_tile = tile; v_uv = a_uv;
    gl_Position = vec4(screen, 0.0, 1.0);
}

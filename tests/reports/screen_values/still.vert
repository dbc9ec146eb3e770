#version 330 core
// No uniform moves the position: what is on the screen is on the surface.
in vec2 a_position;
out vec2 v_uv; out vec4 v_clip;
void main() {
    gl_Position = vec4(a_position, 0.0, 1.0);
    v_uv = gl_Position.xy * 0.5 + 0.5; v_clip = gl_Position;
}

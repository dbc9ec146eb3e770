#version 330 core
// A projection that is written out.
in vec3 a_position; in vec2 a_uv;
uniform mat4 u_view; uniform vec2 u_scale; uniform vec2 u_depth;
out vec2 v_screen; out vec2 v_parts; out vec3 v_eye; out float v_distance; out vec2 v_uv;
void main() {
    vec4 eye = u_view * vec4(a_position, 1.0);
    gl_Position = vec4(eye.x * u_scale.x, eye.y * u_scale.y, eye.z * u_depth.x + u_depth.y, -eye.z);
    v_screen = vec2(eye.x * u_scale.x, eye.y * u_scale.y) / -eye.z;
    v_parts = vec2(a_uv.x, gl_Position.y); v_eye = eye.xyz; v_distance = -eye.z; v_uv = a_uv;
}

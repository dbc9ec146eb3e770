#version 330
// The surface heaves with time, and a function computes where to.
in vec3 a_position;
uniform mat4 u_mvp;
uniform float u_time;
out vec3 v_position;
vec4 place(vec3 p) {
    p.y += 0.15 * sin(12.0 * u_time + 2.0 * p.x);
    return u_mvp * vec4(p, 1.0);
}
void main() {
    v_position = a_position;
    gl_Position = place(a_position);
}

#version 330
// A shader that writes its depth cannot be cached.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

void main() {
    gl_FragDepth = 0.5 + 0.1 * sin(v_uv.x);
    o_color = vec4(sin(v_position * 3.0) * u_time, 1.0);
}

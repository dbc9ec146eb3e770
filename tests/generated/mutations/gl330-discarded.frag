#version 330
in vec3 v_position;
in vec3 v_normal;
uniform sampler2D u_mipmapped;
out vec4 o_color;
void main() {
    vec4 a = texture(u_mipmapped, v_position.xy * 2.0);
    if (a.x > 0.6) discard;
    o_color = vec4(sin(v_normal * 3.0), 1.0);
}

#version 330
in vec3 v_position;
in vec3 v_normal;
uniform float u_a;
uniform sampler2D u_mipmapped;
out vec4 o_color;
void main() {
    vec2 at = v_position.xy * 2.0;
    o_color = vec4(v_normal, 1.0);
    for (int i = 0; i < 2; i++) {
        at += 0.3 * texture(u_mipmapped, at).xy;
    }
    float n = sin(exp(at.x) * 3.0);
    o_color.x = n;
}

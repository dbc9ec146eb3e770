#version 330
in vec3 v_position;
in vec3 v_normal;
uniform sampler2D u_mipmapped;
out vec4 o_color;
float shade(vec2 uv) {
    return texture(u_mipmapped, uv).x + sin(uv.x);
}
void main() {
    float a = shade(v_position.xy * 2.0);
    o_color = vec4(a, dFdx(sin(v_normal.y * 3.0)), v_normal.x, 1.0);
}

layout(location = 0) out vec4 o_color;

void main() {
    float rock = pitted(p);
    o_color = vec4(rock * 0.5, 0.5 + 0.5 * n.y, 0.25, 1.0);
}

#version 300 es
precision highp float;
in highp vec3 v_position;
in highp vec3 v_normal;
in highp vec2 v_uv;
uniform vec3 u_b;
out highp vec4 o_color;
struct Pair { float first; vec3 second; };
Pair g2 = Pair(0.5, vec3(0.25));
void main() {
    o_color = vec4(0.0);
    bool g1 = v_uv.y >= u_b.r;
    float a = sin(0.25 + 3.0 * v_position.y);
    g2 = Pair(a, v_normal);
    int m = 0;
    do {
        m++;
        if (v_position.x > 0.0) {
            g2 = Pair(0.7, vec3(0.3, -0.75, 0.3));
        } else {
            g2 = Pair(0.5, vec3(g2.first, 0.3, 1.7));
        }
        if (v_position.x > 0.3) continue;
    } while (m < 2 && ((v_normal.z < 0.1) && g1));
    o_color.w = 0.2 * fract(g2.second.x);
    o_color.y = 0.1 * float(m);
}

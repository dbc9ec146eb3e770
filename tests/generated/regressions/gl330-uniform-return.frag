#version 330
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_b;
uniform int u_n;
uniform samplerCube u_cube;
out vec4 o_color;

void main() {
    o_color = vec4(v_normal, 1.0);
    vec2 t = v_normal.xy;
    if (u_n > 5) {
        float a = sin(v_uv.y + 3.0 * v_position.x);
        for (int q = 0; q < 2; q++) {
            t += 0.25 * (a * vec2(2.0, -0.75) + v_position.xy);
        }
        if (u_b.x > 2.0) return;
        o_color.x += t.x;
    }
    o_color += texture(u_cube, v_normal);
}

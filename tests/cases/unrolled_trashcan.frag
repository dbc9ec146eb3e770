#version 330
// 25 samples of an environment in two loops; with --unroll their partial sums are values.
uniform sampler2D u_map;
uniform sampler2D u_other;

in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;

out vec4 o_color;

const float SPREAD = 1.25 / 256.0;
const int REACH = 2;

vec3 sampled(float dx, float dy) {
    vec3 bump = texture(u_map, v_uv + SPREAD * vec2(dx, dy)).xyz * 2.0 - 1.0;
    vec3 normal = normalize(v_normal + 0.3 * bump);
    vec3 ray = reflect(normalize(v_position - vec3(0.0, 0.4, 3.0)), normal);
    return exp(-0.4 * (dx * dx + dy * dy)) * textureLod(u_other, ray.xy, 0.0).rgb;
}

void main() {
    vec3 light = vec3(0.0);
    for (int y = -REACH; y <= REACH; y++) {
        for (int x = -REACH; x <= REACH; x++) {
            light += sampled(float(x), float(y));
        }
    }
    o_color = vec4(pow(1.0 - exp(-0.14 * light), vec3(1.0 / 2.2)), 1.0);
}

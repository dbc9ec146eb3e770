#version 330
// Accumulators behind nested loops, of constant and of varying length.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


float octaves(vec3 p, int count) {
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < count; i++, weight *= 0.5)
        sum += weight * wave(p * exp2(float(i)));
    return sum;
}

void main() {
    vec3 sum = vec3(0.0);
    for (float i = -1.0; i <= 1.0; i += 1.0)
        for (float j = -1.0; j <= 1.0; j += 1.0)
            sum += octaves(v_position + vec3(i, j, 0.0), 2);
    vec3 mean = sum / 9.0;
    float few = octaves(v_normal, 1 + int(v_uv.x * 3.0));
    o_color = vec4(mean * few, octaves(v_normal * 2.0, 3));
}

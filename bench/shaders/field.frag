#version 330
// A distance field of many parts, which is asked on many paths: bench/nodes_speed.py repeats what
// has the number 0.
in vec3 v_position;
uniform float u_scale;
uniform vec3 u_light;
out vec4 f_color;

float part_0(vec3 p) {
    vec3 q = abs(p - vec3(0.5, 1.5, 2.0 * u_scale)) - vec3(0.3, 0.01, 0.4);
    float outside = length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
    float bent = sin(p.x * 3.0 + p.y) * cos(p.z - 0.5 * p.x);
    return outside + bent * bent * 0.1;
}

float field(vec3 p) {
    float d = 1e3;
    d = min(d, part_0(p));
    return d;
}

vec3 slope(vec3 p) {
    vec2 e = vec2(0.001, 0.0);
    float here = field(p);
    return normalize(vec3(field(p + e.xyy), field(p + e.yxy), field(p + e.yyx)) - here);
}

float open_to(vec3 p, vec3 way) {
    float near = min(field(p + way * 0.1), field(p + way * 0.2));
    near = min(near, min(field(p + way * 0.4), field(p + way * 0.8)));
    return clamp(near * 8.0, 0.0, 1.0);
}

void main() {
    vec3 n = slope(v_position);
    float light = max(dot(n, u_light), 0.0) * open_to(v_position, u_light);
    float sky = open_to(v_position, n) * open_to(v_position, vec3(0.0, 1.0, 0.0));
    vec3 second = slope(v_position + reflect(u_light, n));
    f_color = vec4(light + sky + second, 1.0);
}

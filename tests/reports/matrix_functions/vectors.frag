#version 330
// Functions of vectors that a driver takes apart, with known parts, between products.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

void main() {
    vec3 n = normalize(v_normal * 1.3);
    vec3 a = reflect(v_position * 1.7, n) * 0.3;
    vec3 b = cross(n, vec3(0.3, 0.9, 0.1)) * 0.7;
    vec3 c = mix(a, b * 2.1, 0.3) * 1.1;
    vec3 d = refract(normalize(v_position), n, 0.7) * 0.9;
    float e = dot(c * 1.3, vec3(0.7, 0.2, 0.1)) * 1.7;
    float f = distance(a * 0.7, b * 1.3) * 0.3 + length(d * 1.9) * 0.7;
    vec2 g = smoothstep(vec2(0.1), vec2(0.9, 0.7), v_uv * 1.3) * 0.7;
    vec3 h = faceforward(n * 0.7, v_position, n) * 1.3 + mod(v_position * 1.9, 0.7) * 0.3;
    o_color = vec4(e, f, g + h.xy * d.z);
}

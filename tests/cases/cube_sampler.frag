#version 330
// Cube maps, looked up along varyings and along values.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


uniform samplerCube u_sky;

void main() {
    vec3 n = normalize(v_normal);
    vec3 a = texture(u_sky, n).rgb;
    vec3 b = textureLod(u_sky, reflect(v_position, n), 0.0).rgb;
    float c = wave(v_position);
    vec3 d = textureLod(u_sky, n + c * 0.1, 0.0).rgb * c;
    vec3 e = texture(u_sky, n.yzx, 0.5).rgb * wave(n);
    o_color = vec4(a + b * 0.5 + d + e, 1.0);
}

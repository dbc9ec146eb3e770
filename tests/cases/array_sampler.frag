#version 330
// Layers of an array texture, chosen by a varying and by a value.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


uniform sampler2DArray u_layers;

void main() {
    vec3 a = texture(u_layers, vec3(v_uv, 1.0)).rgb;
    float c = wave(v_position);
    vec3 b = textureLod(u_layers, vec3(v_uv, c + 1.0), 0.0).rgb;
    vec3 d = textureLod(u_layers, vec3(v_uv.yx, floor(v_uv.x * 2.999)), 0.0).rgb * c;
    vec3 e = texelFetch(u_layers, ivec3(v_uv * 3.0, 2), 0).rgb * wave(v_normal);
    o_color = vec4(a * 0.5 + b + d + e, 1.0);
}

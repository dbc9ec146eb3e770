#version 450
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
// A mobile renderer's lobe: half floats wherever eight bits of colour come out.
layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_normal;
layout(location = 2) in vec2 v_uv;
layout(location = 0) out vec4 o_color;
uniform sampler2D u_albedo;
uniform vec3 u_light;
uniform vec3 u_eye;

const float16_t PI = 3.14159265hf;

float16_t distribution(float16_t nh, float16_t roughness) {
    float16_t a = roughness * roughness;
    float16_t d = nh * nh * (a * a - 1.0hf) + 1.0hf;
    return a * a / (PI * d * d);
}

f16vec3 fresnel(float16_t vh, f16vec3 f0) {
    return mix(f0, f16vec3(1.0hf), pow(1.0hf - vh, 5.0hf));
}

void main() {
    f16vec3 n = f16vec3(normalize(v_normal));
    f16vec3 l = f16vec3(normalize(u_light - v_position));
    f16vec3 v = f16vec3(normalize(u_eye - v_position));
    f16vec3 h = normalize(l + v);
    f16vec4 albedo = f16vec4(texture(u_albedo, v_uv));
    float16_t lit = max(dot(n, l), 0.0hf);
    f16mat3 turn = f16mat3(n, l, cross(n, l));
    float16_t lobe = distribution(clamp(dot(n, h), 0.0hf, 1.0hf), 0.4hf) * lit;
    f16vec3 tinted = (turn * fresnel(max(dot(v, h), 0.0hf), albedo.rgb)) * lobe;
    float veins = exp(sin(v_position.x * 7.0) * sin(v_position.y * 5.0) * cos(v_position.z * 9.0));
    o_color = vec4(vec3(tinted + albedo.rgb * lit) * veins, 1.0);
}

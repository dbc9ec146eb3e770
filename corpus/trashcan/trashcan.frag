#version 330
// A battered trash can of galvanised steel: the yard around it, blurred over 25 bent normals.

uniform sampler2D u_normals;        // tangent-space normals, 0.5 + 0.5 n
uniform samplerCube u_environment;  // radiance of the yard
uniform vec3 u_eye;                 // world space

in vec3 v_world;      // world space, like the three axes below
in vec3 v_tangent;
in vec3 v_bitangent;
in vec3 v_normal;
in vec2 v_uv;

layout(location = 0) out vec4 o_color;

const float SPREAD = 1.25 / 256.0;          // between neighbouring samples, in v_uv
const float WEIGHT = 0.1327;                // one over the sum of the 25 weights
const vec3 STEEL = vec3(0.86, 0.88, 0.90);  // what steel reflects

// What the yard sends by way of the normal (dx, dy) samples away, with its Gaussian weight.
vec3 sample_environment(float dx, float dy) {
    vec3 bump = texture(u_normals, v_uv + SPREAD * vec2(dx, dy)).xyz * 2.0 - 1.0;
    vec3 normal = normalize(mat3(v_tangent, v_bitangent, v_normal) * bump);
    vec3 ray = reflect(v_world - u_eye, normal);
    return exp(-0.4 * (dx * dx + dy * dy)) * textureLod(u_environment, ray, 0.0).rgb;
}

void main() {
    // Row by row, but the middle last: it weighs most.
    vec3 light = sample_environment(-2.0, -2.0) + sample_environment(-1.0, -2.0)
        + sample_environment(0.0, -2.0) + sample_environment(1.0, -2.0)
        + sample_environment(2.0, -2.0)
        + sample_environment(-2.0, -1.0) + sample_environment(-1.0, -1.0)
        + sample_environment(0.0, -1.0) + sample_environment(1.0, -1.0)
        + sample_environment(2.0, -1.0)
        + sample_environment(-2.0, 0.0) + sample_environment(-1.0, 0.0)
        + sample_environment(1.0, 0.0) + sample_environment(2.0, 0.0)
        + sample_environment(-2.0, 1.0) + sample_environment(-1.0, 1.0)
        + sample_environment(0.0, 1.0) + sample_environment(1.0, 1.0)
        + sample_environment(2.0, 1.0)
        + sample_environment(-2.0, 2.0) + sample_environment(-1.0, 2.0)
        + sample_environment(0.0, 2.0) + sample_environment(1.0, 2.0)
        + sample_environment(2.0, 2.0)
        + sample_environment(0.0, 0.0);
    vec3 exposed = 1.0 - exp(-1.1 * STEEL * (WEIGHT * light));
    o_color = vec4(pow(exposed, vec3(1.0 / 2.2)), 1.0);
}

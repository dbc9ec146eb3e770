#version 330 core
in vec3 v_world;
in vec2 v_uv;
in mat3 v_frame;

uniform sampler2D u_albedoMap;
uniform sampler2D u_normalMap;
uniform sampler2D u_roughnessMap;
uniform samplerCube u_sky;
uniform vec3 u_eye;
uniform vec3 u_lightPosition;

out vec4 color;

void main() {
    vec3 bent = texture(u_normalMap, v_uv).xyz * 2.0 - 1.0;
    vec3 normal = normalize(v_frame * bent);
    vec3 to_eye = normalize(u_eye - v_world);
    vec3 to_light = normalize(u_lightPosition - v_world);
    float rough = texture(u_roughnessMap, v_uv).g;
    float gloss = pow(max(dot(reflect(-to_light, normal), to_eye), 0.0), mix(60.0, 4.0, rough));
    vec3 sky = texture(u_sky, reflect(-to_eye, normal)).rgb;
    vec3 albedo = texture(u_albedoMap, v_uv).rgb;
    color = vec4(albedo * (0.1 + max(dot(normal, to_light), 0.0)) + 0.2 * gloss * sky, 1.0);
}

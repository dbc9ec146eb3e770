#version 330 core
// A poppy of many: it stands at its place, turned, and leans with the wind the more the higher.

in vec3 a_position;
in vec3 a_normal;
in float a_part;
in vec4 i_place; // x, z, size, turn
in vec2 i_sway;

uniform mat4 u_viewProjection;

out vec3 v_position;
out vec3 v_world;
out vec3 v_normal;
out float v_part;
out float v_seed;

vec3 turned(vec3 p) {
    float c = cos(i_place.w), s = sin(i_place.w);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}

void main() {
    v_position = a_position;
    v_part = a_part;
    v_seed = i_place.w;
    vec3 standing = turned(a_position);
    float bend = a_position.y * a_position.y;
    vec3 leaning = standing + vec3(i_sway.x, -0.5 * dot(i_sway, i_sway), i_sway.y) * bend;
    v_world = vec3(i_place.x, 0.0, i_place.y) + i_place.z * leaning;
    v_normal = turned(a_normal);
    gl_Position = u_viewProjection * vec4(v_world, 1.0);
}

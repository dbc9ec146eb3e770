#version 330 core
// What is computed like the position, and what is not.
in vec3 a_position; in vec3 a_normal;
uniform mat4 u_model; uniform mat4 u_view; uniform mat4 u_projection; uniform mat4 u_lights[2];
uniform mat4 u_light; uniform mat3 u_normals; uniform vec3 u_eye;
out vec4 v_clip; out vec4 v_moved; out vec3 v_ndc; out vec4 v_through;
out vec3 v_world; out vec3 v_view; out vec3 v_normal; out vec4 v_shadow; out vec4 v_second;
out float v_distance; out vec3 v_facing; out vec3 v_along;
vec4 project(vec4 world) { return u_projection * (u_view * world); }
void main() {
    vec4 world = u_model * vec4(a_position, 1.0);
    mat4 both = u_projection * u_view;
    gl_Position = project(world);
    v_clip = both * u_model * vec4(a_position, 1.0);
    v_moved = both * (world + vec4(a_normal * 0.1, 0.0));
    vec4 clip = u_projection * u_view * world; clip /= clip.w;
    v_ndc = clip.xyz;
    v_through = 2.0 * project(world) - vec4(0.5);
    v_world = world.xyz;
    v_view = (u_view * world).xyz;
    v_normal = u_normals * a_normal;
    v_shadow = u_light * world;
    v_second = u_lights[1] * u_model * vec4(a_position, 1.0);
    v_distance = length(u_eye - world.xyz) + length(v_view);
    v_facing = mat3(u_view) * a_normal;
    v_along = (both * vec4(a_normal, 0.0)).xyz;
}

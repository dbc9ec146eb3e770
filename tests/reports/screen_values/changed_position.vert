#version 330 core
// The position is changed behind the projection: a mirrored axis, a jitter, a far sky.
in vec3 a_position;
uniform mat4 u_viewProjection; uniform mat4 u_model; uniform vec2 u_jitter;
const mat4 MIRROR = mat4(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
out vec4 v_clip; out vec3 v_world; out vec4 v_plain;
void main() {
    vec4 world = u_model * vec4(a_position, 1.0);
    vec4 clip = MIRROR * u_viewProjection * world;
    gl_Position = clip.xyww;
    gl_Position.xy += u_jitter * gl_Position.w;
    gl_Position.z -= 0.001;
    v_clip = clip;
    v_plain = u_viewProjection * world;
    v_world = world.xyz;
}

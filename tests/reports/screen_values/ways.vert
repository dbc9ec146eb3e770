#version 330 core
// In branches, loops and out arguments, behind early returns.
in vec3 a_position; in vec4 a_weights;
uniform mat4 u_bones[4]; uniform mat4 u_vp; uniform bool u_flat; uniform int u_count;
out vec3 v_posed; out vec4 v_clip; out vec4 v_either; out float v_side; out vec4 v_given; out vec3 v_skin;
void place(vec4 p, out vec4 clip, inout vec3 skin) { clip = u_vp * p; skin += p.xyz; }
void main() {
    vec4 posed = vec4(0.0);
    for (int i = 0; i < u_count; i++) posed += a_weights[i] * (u_bones[i] * vec4(a_position, 1.0));
    v_posed = posed.xyz; v_skin = a_position; v_either = posed; v_side = 1.0;
    place(posed, v_given, v_skin);
    if (u_flat) v_either = u_vp * posed;
    gl_Position = u_vp * posed;
    v_clip = gl_Position;
    if (gl_Position.x < 0.0) v_side = 0.5;
    if (u_flat) { gl_Position.z = 0.0; return; }
    gl_Position.z *= 0.5;
}

#version 410 core
// Written in branches, in a loop and before an early return.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
uniform bool u_turned;
out gl_PerVertex { vec4 gl_Position; };
invariant gl_Position;
void main() {
    v_p = a_position; v_n = a_normal;
    if (u_turned) gl_Position = vec4(0.0);
    else gl_Position = u_mvp[3];
    for (int i = 0; i < 3; i++) gl_Position += u_mvp[i] * a_position[i];
    if (gl_Position.w < 0.0) return;
    switch (int(u_turned)) { case 1: gl_Position.z *= 1.5; break; default: gl_Position.z *= 1.0; }
}

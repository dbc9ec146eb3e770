#version 410 core
// Written by a function that another one calls, through a global that carries the pose.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out gl_PerVertex { vec4 gl_Position; };
precise gl_Position;
vec4 pose;
vec4 clip() { return u_mvp * pose; }
void write() { gl_Position = clip(); }
void stand() { pose = vec4(a_position, 1.0); write(); }
void main() { v_p = a_position; v_n = a_normal; stand(); }

// TWINNED: Poses, Skeleton
// NOT: Colours
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(std430, binding = 0) buffer Poses { mat4 pose[]; } poses;
layout(std430, binding = 1) buffer Skeleton { int bones[]; };
layout(std430, binding = 2) buffer Colours { vec3 colour[]; };
mat4 posed(int i) { return poses.pose[bones[i]]; }
void main() {
    v_p = a_position; v_n = a_normal * colour[0];
    gl_Position = u_vp * posed(1) * vec4(a_position, 1.0);
}

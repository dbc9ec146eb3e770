#version 430 core
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
out vec3 v_p;
out vec3 v_n;
coherent readonly layout(std430, binding = 0) restrict buffer Poses { mat4 pose[]; };
volatile restrict readonly layout(binding = 1, std430) buffer Shifts { coherent vec4 at[2]; vec4 rest[]; } shifts;
readonly buffer Sizes { float size[]; };
uniform mat4 u_vp;

void main() {
    v_p = a_position;
    v_n = a_normal;
    vec4 moved = vec4(a_position * size[0], 1.0) + shifts.at[1] + shifts.rest[0];
    gl_Position = u_vp * pose[0] * moved;
}

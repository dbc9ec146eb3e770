// MOVING: table
// TWINNED: Table
// NAMED: a_position, Rest
#version 430 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
layout(std430, binding = 3) readonly buffer Table { mat4 place[]; } table; layout(std430, binding = 4) readonly buffer Rest { vec4 rest[]; };
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_vp * table.place[gl_InstanceID] * (rest[0] + vec4(a_position, 1.0));
}

#version 410 core
// The block has more members, and what is written to them is read back for the position.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out gl_PerVertex { vec4 gl_Position; float gl_PointSize; float gl_ClipDistance[2]; };
void main() {
    v_p = a_position; v_n = a_normal;
    gl_Position = u_mvp * vec4(a_position, 1.0);
    gl_PointSize = gl_Position.w * 0.5;
    gl_ClipDistance[1] = gl_PointSize + 4.0;
    gl_ClipDistance[0] = 9.0;
    gl_Position.x += 0.01 * gl_PointSize * gl_ClipDistance[1];
}

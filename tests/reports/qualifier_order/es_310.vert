#version 310 es
in highp vec3 a_position;
out highp vec3 v_p;
readonly layout(std430, binding = 0) buffer Poses { highp mat4 pose[]; };
uniform highp mat4 u_vp;

void main() {
    v_p = a_position;
    gl_Position = u_vp * pose[0] * vec4(a_position, 1.0);
}

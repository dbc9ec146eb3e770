#version 410 core
// Written as an out argument, then as an inout one; so is the size of points.
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n;
uniform mat4 u_mvp;
out gl_PerVertex { vec4 gl_Position; float gl_PointSize; };
void place(in vec3 p, out vec4 clip, out float size) { clip = u_mvp * vec4(p, 1.0); size = 3.0; }
void shift(inout vec4 clip) { clip.xy += 0.1 * clip.ww; }
void main() {
    v_p = a_position; v_n = a_normal;
    place(a_position, gl_Position, gl_PointSize);
    shift(gl_Position);
}

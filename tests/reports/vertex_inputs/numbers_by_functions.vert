// SAYS: an instance keeps its number from frame to frame (gl_InstanceID decides the position)
// SAYS: a vertex keeps its number from frame to frame (gl_VertexID decides the position)
#version 330 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform vec3 u_places[64];
vec3 place() { return u_places[gl_InstanceID]; }
void put(out vec4 clip, int corner) { clip = u_vp * vec4(a_position * float(corner) + place(), 1.0); }
void main() { v_p = a_position; v_n = a_normal; put(gl_Position, gl_VertexID & 1); }

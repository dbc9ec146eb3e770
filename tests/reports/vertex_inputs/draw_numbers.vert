// SAYS: a draw keeps its number from frame to frame (gl_DrawID decides the position)
// SAYS: a draw keeps its first instance from frame to frame (gl_BaseInstance decides the position)
// SAYS: a draw keeps its first vertex from frame to frame (gl_BaseVertex decides the position)
// SAYS: the range of depths stays the same from frame to frame (gl_DepthRange decides the position)
#version 460 core
layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;
out vec3 v_p; out vec3 v_n; uniform mat4 u_vp;
uniform mat4 u_places[64];
void main() {
    v_p = a_position; v_n = a_normal;
    int at = gl_DrawID + gl_BaseInstance + gl_BaseVertex;
    gl_Position = u_vp * u_places[at] * vec4(a_position, gl_DepthRange.far);
}

#version 120
// The fixed-function pipeline's own transformation.
varying vec3 v_p; varying vec3 v_n;
void main() { v_p = gl_Vertex.xyz; v_n = gl_Normal; gl_Position = ftransform(); }

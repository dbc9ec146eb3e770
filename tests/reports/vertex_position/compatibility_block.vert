#version 410 compatibility
// The block of the compatibility profile, with members that the core profile has not.
out vec3 v_p; out vec3 v_n;
out gl_PerVertex { vec4 gl_Position; vec4 gl_FrontColor; };
void main() {
    v_p = gl_Vertex.xyz; v_n = gl_Normal;
    gl_FrontColor = vec4(1.0);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}

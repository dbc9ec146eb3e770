// A vertex shader of a desktop: its fragment shader is one as well, guard or not.
varying vec3 v_position;

void main() {
    v_position = gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}

#version 450
struct P { vec3 at; };
in vec3 a_position;
uniform mat4 u_modelViewProjection;
out P v;

void main() {
    P p = { a_position };
    v = p;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}

#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;

//// One declarator to a declaration, except in the head of a loop.
struct S {
    float x;
} s, t[2];
void main() {
    float a = 1.0, b = a;
    for (int i = 0, j = 1; i < j; i++) {
    }
    color = vec4(a + b);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

struct S {
    float x;
};

S s;
S t[2];

void main() {
    float a = 1.0;
    float b = a;
    for (int i = 0, j = 1; i < j; i++) {
    }
    color = vec4(a + b);
}

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

//// Variables of a struct without a name are of one type.
struct { float x; } pair, other;
void main() {
    struct { float y; } here, there;
    here.y = u_a;
    there = here;
    pair.x = there.y;
    other = pair;
    color = vec4(other.x);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;

struct {
    float x;
} pair, other;

void main() {
    struct {
        float y;
    } here, there;
    here.y = u_a;
    there = here;
    pair.x = there.y;
    other = pair;
    color = vec4(other.x);
}

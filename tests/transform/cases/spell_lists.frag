#version 420
uniform float u_a;
out vec4 color;

//// Lists become constructors where their type has a name.
struct S {
    vec2 a;
    float b[2];
};
struct {
    float x;
} t = {1.0};
void main() {
    mat2 m = {{1.0, u_a}, {2.0, 3.0}};
    S s = {{u_a, 1.0}, {2.0, 3.0}};
    float f[] = {1.0, u_a};
    color = vec4(m[0], s.b[1], f[1] + t.x);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

struct S {
    vec2 a;
    float b[2];
};

struct {
    float x;
} t = {1.0};

void main() {
    mat2 m = mat2(vec2(1.0, u_a), vec2(2.0, 3.0));
    S s = S(vec2(u_a, 1.0), float[2](2.0, 3.0));
    float f[] = float[2](1.0, u_a);
    color = vec4(m[0], s.b[1], f[1] + t.x);
}

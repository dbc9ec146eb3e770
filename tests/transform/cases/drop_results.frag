#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;

//// Results that nobody uses.
//// functions: f used
float g;
float f(float x) {
    if (x > 1.0) {
        g = x;
        return x * 2.0;
    }
    return g++;
}
vec3 used(float x) {
    g = x;
    return vec3(x);
}
float kept(float x) {
    g = x;
    return x;
}
void main() {
    f(u_a);
    f(2.0);
    float y = used(u_a).x;
    kept(y);
    color = vec4(g);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float g;

void f(float x) {
    if (x > 1.0) {
        g = x;
        return;
    }
    g++;
}

vec3 used(float x) {
    g = x;
    return vec3(x);
}

float kept(float x) {
    g = x;
    return x;
}

void main() {
    f(u_a);
    f(2.0);
    float y = used(u_a).x;
    kept(y);
    color = vec4(g);
}

#version 330
out vec4 color;

//// Of a function with a body only.
float f(float, vec2 p);
float f(float, vec2 p) {
    return p.x;
}
void main() {
    color = vec4(f(1.0, vec2(2.0)));
}
//// becomes
#version 330

out vec4 color;
float f(float, vec2 p);

float f(float sc_unnamed_0, vec2 p) {
    return p.x;
}

void main() {
    color = vec4(f(1.0, vec2(2.0)));
}

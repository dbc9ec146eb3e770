#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;

//// Functions, variables and parameters.
//// f: g
//// u_a: u_b
//// x: y
float f(float x) {
    return x;
}
void main() {
    color = vec4(f(u_a));
}
//// becomes
#version 330

uniform float u_b;
in vec3 v_a;
out vec4 color;

float g(float y) {
    return y;
}

void main() {
    color = vec4(g(u_b));
}

//// Fields keep their names, but for those of a block without one.
//// scale: other
//// size: larger
uniform float scale;
struct Pair { float scale; };
uniform Named { float scale; } named;
uniform Bare { float size; };
void main() {
    Pair pair = Pair(scale);
    color = vec4(pair.scale * named.scale * size);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
uniform float other;

struct Pair {
    float scale;
};

uniform Named {
    float scale;
} named;

uniform Bare {
    float larger;
};

void main() {
    Pair pair = Pair(other);
    color = vec4(pair.scale * named.scale * larger);
}

#version 330 core
// Arguments that discard, of functions that a variant no longer gives them to.

in vec3 p;
in vec3 n;

out vec4 color;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

float seen(float x) {
    if (sin(6.0 * x) > 0.9) {
        discard;
    }
    return x;
}

bool lit(float x) {
    return seen(x) > 0.0;
}

float plain(float x) {
    return noise(p) + 0.1 * n.x;
}

float beside(float x, float y) {
    return noise(p.yzx) * y;
}

float chosen(bool side) {
    return noise(p.zxy);
}

float deep(float x) {
    return beside(seen(x), x) + plain(x);
}

void main() {
    float a = plain(seen(p.x));
    float b = beside(seen(p.y), n.y) + n.z;
    float c = chosen(lit(p.z));
    float d = n.z > 0.1 ? plain(seen(p.x + 0.3)) : n.x;
    float e = beside(plain(seen(p.y - 0.4)), deep(p.z + 0.2));
    float f = plain((seen(p.x - 0.7), n.y));
    color = vec4(a + b, c * d, e - f, 1.0);
}

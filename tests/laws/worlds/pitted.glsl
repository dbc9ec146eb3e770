in vec3 p;
in vec3 n;
uniform float zero;

// Not a number in the pits: no compiler knows what `zero` is.
float pitted(vec3 q) {
    float depth = sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
    return depth > 0.6 ? zero / zero : exp(depth);
}

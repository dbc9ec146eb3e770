// Of four texels what their weights say.

// Four texels by their weights, those without one left out: they may hold NaN, and 0 times NaN is
// NaN. What is added for those is -0, as 0 would make 0 of -0.
vec4 sc_chosen(vec4 a, vec4 b, vec4 c, vec4 d, vec4 weights) {
    vec4 sum = weights.x > 0.0 ? weights.x * a : vec4(-0.0);
    sum += weights.y > 0.0 ? weights.y * b : vec4(-0.0);
    sum += weights.z > 0.0 ? weights.z * c : vec4(-0.0);
    return sum + (weights.w > 0.0 ? weights.w * d : vec4(-0.0));
}

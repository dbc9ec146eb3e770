// Derivatives and places under conditions, in choices and loops, in front of returns and discards.
float slope(vec3 p) {
    if (u_gain < 1.0) { return 0.0; }
    return wave(fwidth(p) * 40.0);
}

void main() {
    vec3 face = normalize(cross(dFdx(v_position), dFdy(v_position)));
    o_color = vec4(0.2, 0.3, 0.4, 1.0);
    if (v_uv.x > 0.5) {
        float inner = wave(face * 2.0) * wave(v_position);
        o_color.x += inner;
    }
    if (u_gain > 1.0) { o_color.y += wave(dFdx(v_position) * 50.0); }
    float sum = 0.0;
    for (int i = 1; i < 4; i++) { sum += wave(dFdy(v_position * float(i)) * 20.0); }
    o_color.z += v_uv.x > 0.3 ? wave(face) : wave(gl_FragCoord.xyz * 0.1);
    o_color.w = slope(v_position) + sqrt(sum * sum + 0.5);
    if (v_uv.y > 0.9) { discard; }
    float last = wave(vec3(gl_FragCoord.xy * 0.2, face.x));
    if (v_uv.y > 0.4) { return; }
    o_color += last + wave(face.yzx);
}

// What an interpolated value may be off: it is the sum of terms of a plane, which cancel.
float sc_near(float v) {
    return v + SC_ULPS * (abs(v) + abs(dFdx(v)) * gl_FragCoord.x + abs(dFdy(v)) * gl_FragCoord.y);
}
vec2 sc_near(vec2 v) { return vec2(sc_near(v.x), sc_near(v.y)); }
vec3 sc_near(vec3 v) { return vec3(sc_near(v.xy), sc_near(v.z)); }
vec4 sc_near(vec4 v) { return vec4(sc_near(v.xyz), sc_near(v.w)); }

// What the last picture shows of this fragment's point; alpha 0 where it was hidden or not there.
vec4 what_was_shown() {
    vec2 place = last_place();
    vec2 slope = vec2(dFdx(gl_FragCoord.w), dFdy(gl_FragCoord.w));
    vec3 found = own_surface(place, last_nearness(), slope);
    bool known = u_begins == 0 && found.z < SAME && place == clamp(place, vec2(0.0), u_size);
    return vec4(textureLod(u_history, found.xy / u_size, 0.0).gba, known ? 1.0 : 0.0);
}

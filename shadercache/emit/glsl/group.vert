// One triangle over the whole target, at the depth that marks the misses of a group.
uniform int sc_group;  // its number, from 1

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, sc_FIRST_MARK + float(sc_group) / sc_MARKS, 1.0);
}

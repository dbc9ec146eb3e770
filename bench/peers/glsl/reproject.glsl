// Where the point of this fragment was in the last frame.
in vec4 sc_current;   // clip positions, of this frame
in vec4 sc_previous;  // and of the last one

uniform vec2 u_size;  // of the picture, in pixels

// In pixels of the picture: exactly this fragment's own place where nothing has moved.
vec2 last_place() {
    vec2 moved = sc_previous.xy / sc_previous.w - sc_current.xy / sc_current.w;
    return gl_FragCoord.xy + 0.5 * u_size * moved;
}

// 1/w in the last frame.
float last_nearness() {
    return 1.0 / sc_previous.w;
}

// The age of a payload, the mean of all that a filter took, is kept beside it: it never gets older
// than the period.

int sc_VERDICT() {
    return sc_judge(sc_AGE(sc_texel, sc_texel_2));
}

int sc_RAW_VERDICT() {
    return sc_judge(sc_AGE(sc_raw, sc_raw_2));
}

void sc_RECALL() {
}

void sc_AGING() {
    sc_stagger();
}

// After a reset all payloads are new. They start with different ages, or all would be too old in the
// same frame.
void sc_stagger() {
    if (sc_reset != 0) {
        uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
        uint hashed = (block.x * 1973u + block.y * 9277u + 26699u) * 0x9E3779B9u;
        hashed = (hashed ^ (hashed >> 15)) * 0x85EBCA6Bu;
        sc_age = float(((hashed >> 16) * uint(sc_period)) >> 16);
    }
}

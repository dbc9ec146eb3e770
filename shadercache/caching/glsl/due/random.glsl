// Blocks by a hash of their place.

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
    uvec2 block = uvec2(gl_FragCoord.xy / float(sc_block));
    return sc_residue(sc_hash(block.x * 1973u + block.y * 9277u + 26699u));
}

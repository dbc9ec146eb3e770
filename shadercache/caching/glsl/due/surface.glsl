// Triangles by a hash of their number.

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
    // Neighbouring triangles of a mesh are drawn one behind the other, so they share a turn.
    return sc_residue(sc_hash(uint(gl_PrimitiveID >> 6) * 9277u + 26699u));
}

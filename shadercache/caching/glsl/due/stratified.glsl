// Of each group of sc_period blocks one is due in every frame, in an order of the group's own.

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
    // Blocks are numbered row by row, which is less to compute than groups as high as wide, and as
    // floats: exact below 2^23 blocks, and above them a pixel still has one turn in each period.
    float shrink = 1.0 / float(sc_block);
    vec2 block = floor(gl_FragCoord.xy * shrink);
    float across = ceil((float(textureSize(sc_cache, 0).x) - 0.5) * shrink);
    float number = block.y * across + block.x;
    float group = floor((number + 0.5) / float(sc_period));
    uint key = sc_hash(uint(group) * 9277u + 26699u);
    // Turned by a number of the group's own as well: one swap in four is none, and the places that
    // keep their turn must not stand one above the other.
    int turn = int(number - group * float(sc_period)) + sc_residue(key * 0xC2B2AE35u);
    turn -= turn >= sc_period ? sc_period : 0;
    turn = sc_swap(turn, sc_residue(key), key);
    return sc_swap(turn, sc_residue(key << 16), key ^ 0x85EBCA6Bu);
}

// One round of a shuffle of [0, sc_period) by swaps, each made or not (Hoang, Morris and Rogaway
// 2012): for any period, without a table.
int sc_swap(int slot, int partner, uint key) {
    int other = partner - slot;
    other += other < 0 ? sc_period : 0;
    return ((key + uint(max(slot, other))) * 0x9E3779B9u & 0x80000000u) == 0u ? slot : other;
}

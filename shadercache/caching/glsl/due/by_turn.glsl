// Which pixels are recomputed on purpose, although the cache holds what they need: each has a turn
// in the period, and the schedule says which.

// (turn + clock) mod period == 0: no remainder is taken, since both are in [0, period).
bool sc_due() {
    int phase = sc_turn() + sc_clock;
    return phase == 0 || phase == sc_period;
}

// A well mixed 32-bit hash.
uint sc_hash(uint x) {
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    x *= 0x9E3779B9u;
    return x ^ (x >> 15);
}

// A hash made uniform in [0, sc_period).
int sc_residue(uint hashed) {
    return int(((hashed >> 16) * uint(sc_period)) >> 16);
}

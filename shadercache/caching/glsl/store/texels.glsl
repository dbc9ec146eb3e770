// What a pass writes into the cache: sc_pack makes a texel of the payload and the depth.

// What was reused. It has been guarded, and filters keep to its range.
void sc_STORE_REUSED() {
    sc_CARRY();
    sc_store = sc_pack();
}

// What was computed anew.
void sc_STORE_COMPUTED() {
    sc_AGING();
    sc_store = sc_pack();
    sc_GUARD();
}

// Either.
void sc_STORE(bool reused) {
    sc_AGING();
    sc_CARRY_IF(reused);
    sc_store = sc_pack();
    if (!reused) {
        sc_GUARD();
    }
}

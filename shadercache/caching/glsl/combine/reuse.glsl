// What was cached is the payload.

void sc_COMBINE() {
    sc_UNPACK();
}

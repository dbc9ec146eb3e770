// Payloads may get as old as they like.

int sc_VERDICT() {
    return sc_hit;
}

void sc_RECALL() {
}

void sc_AGING() {
}

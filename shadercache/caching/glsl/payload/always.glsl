// Every fragment has its payloads.

void sc_COMPUTE() {
    sc_compute();
}

void sc_PASS_THROUGH() {
}

void sc_NEED() {
    sc_outcome = 1.0;
}

void sc_FIND() {
}

// Some fragments do without payloads: passes go through the shader to know.

void sc_COMPUTE() {
    sc_shade();
}

void sc_PASS_THROUGH() {
    sc_SET_VALID(true);
    sc_shade();
}

void sc_NEED() {
    sc_outcome = sc_VALID() ? 1.0 : 2.0;
}

void sc_FIND() {
    sc_reuse = true;
    sc_SET_VALID(true);
}

// Objects are not told apart.

void sc_TEST_OBJECT_OF_ONE() {
}

void sc_TEST_OBJECT_OF_FOUR() {
}

void sc_FIT_OBJECT(vec4 fits) {
}

void sc_ONE_SURFACE(bvec4 close) {
    bool one_surface = all(close);
}

int sc_NO_FIT() {
    return sc_NONE_FITS();
}

void sc_NOTE_OBJECT() {
}

bool sc_IF_OWN(bool fits) {
    return fits;
}

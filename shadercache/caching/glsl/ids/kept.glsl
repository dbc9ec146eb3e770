// Each object reuses only what it stored itself.

ivec4 sc_IDS() {
    return ivec4(sc_ID(a, a_2), sc_ID(b, b_2), sc_ID(c, c_2), sc_ID(d, d_2));
}

void sc_TEST_OBJECT_OF_ONE() {
    if (sc_ID(sc_texel, sc_texel_2) != sc_object) {
        return sc_miss_id;
    }
}

void sc_TEST_OBJECT_OF_FOUR() {
    // A filter that takes a little of another object passes the test of depths where they touch.
    if (sc_IDS() != ivec4(sc_object)) {
        return sc_miss_id;
    }
}

void sc_FIT_OBJECT(vec4 fits) {
    fits *= vec4(equal(sc_IDS(), ivec4(sc_object)));
}

void sc_ONE_SURFACE(bvec4 close) {
    bool near_enough = all(close);
    bool one_surface = near_enough && sc_IDS() == ivec4(sc_object);
}

int sc_NO_FIT() {
    return near_enough ? sc_miss_id : sc_NONE_FITS();
}

bool sc_own = true;  // are all texels that a filter has read of this object?

void sc_NOTE_OBJECT() {
    sc_own = sc_own && sc_IDS() == ivec4(sc_object);
}

bool sc_IF_OWN(bool fits) {
    return fits && sc_own;
}

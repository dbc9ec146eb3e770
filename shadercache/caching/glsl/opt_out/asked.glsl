// A draw may ask that nobody reuses it.

sc_CHANNEL sc_KEPT_DEPTH() {
    return sc_mask == 2 ? sc_no_depth : sc_OWN_DEPTH();
}

// Whatever is drawn may be reused.

sc_CHANNEL sc_KEPT_DEPTH() {
    return sc_OWN_DEPTH();
}

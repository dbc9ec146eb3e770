// Nothing that is stored here comes from a filter that can mark it.

sc_CHANNEL sc_OWN_DEPTH() {
    return sc_OF_FLOATS(sc_DEPTH());
}

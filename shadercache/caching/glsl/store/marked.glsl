// What comes from a part of a filter is marked.

sc_CHANNEL sc_OWN_DEPTH() {
    return sc_MARKED(sc_DEPTH());
}

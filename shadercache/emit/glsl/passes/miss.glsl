// Two passes, second: the whole shader, for the pixels that the first pass left open.
void main() {
    sc_HERE();
    sc_RECALL();
    sc_shade();
    sc_STORE_COMPUTED();
}

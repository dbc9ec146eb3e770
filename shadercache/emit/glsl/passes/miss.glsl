// Two passes, second: the whole shader, for the pixels that the first pass left open.
void main() {
    sc_shade();
    SC_STORE;
}

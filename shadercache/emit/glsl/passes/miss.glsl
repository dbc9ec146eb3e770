// Two passes, second: the whole shader, for the pixels that the first pass left open.
void main() {
    SC_LOCATE
    sc_shade();
    SC_STORE;
}

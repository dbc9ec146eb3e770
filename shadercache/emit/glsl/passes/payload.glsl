// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_compute();
    SC_STORE;
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    SC_LOCATE
    sc_compute();
    SC_STORE;
}

// Three passes, second: the payload alone, for the pixels that the first pass left open.
void main() {
    sc_HERE();
    sc_RECALL();
    sc_compute();
    sc_STORE_COMPUTED();
}

// Three passes, third: the colour, from the payload that stands in the cache of this frame.
void main() {
    sc_TAKE();
    sc_shade();
}

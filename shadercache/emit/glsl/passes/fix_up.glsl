// Parked misses, third: the whole shader, for the pixels that wait; all that it needs was parked.
void main() {
    sc_HERE();
    sc_shade();
    sc_STORE_COMPUTED();
}

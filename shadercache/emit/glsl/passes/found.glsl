// Not part of any variant: the first of two passes with every pixel a hit and nothing looked up, to
// measure what looking up costs. The texel is a number that no driver knows beforehand.
void main() {
    sc_HERE();
    sc_TEXELS sc_texel = sc_OF_FLOATS(vec4(sc_epsilon));
    sc_FIND_RAW();
    sc_FIND();
    sc_COMBINE();
    sc_shade();
    sc_STORE_REUSED();
}

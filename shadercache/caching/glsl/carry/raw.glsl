// What is stored of a hit is the raw sample nearest to the pixel, as it was computed: what is shown is
// resampled once, and what is stored never.

sc_TEXELS sc_raw;             // the sample that the texel goes on to keep
vec2 sc_offset = vec2(0.0);   // where it lies, in pixels from the middle of the texel

void sc_CARRY() {
    sc_texel = sc_raw;
    sc_UNPACK();
}

void sc_CARRY_IF(bool reused) {
    if (reused) {
        sc_texel = sc_raw;
        sc_UNPACK();
    }
}

void sc_FIND_RAW() {
    sc_raw = sc_texel;
}

// Place in the cache by how far the pixel's point has moved; who uses this says what sc_MOTION is.

void sc_LOCATE(out ivec2 last, out vec2 place, out vec4 jacobian, out vec2 slope) {
    last = sc_LAST();
    sc_MOTION(last, motion);
    // Counted in texels from the middle of the first one: its whole part is the lower left of the
    // four texels around the place.
    place = sc_PIXEL() - 0.5 + 0.5 * sc_EXTENT(last) * motion;
    // How place and expected depth change from pixel to pixel. Ahead of every exit, as derivatives
    // must be.
    slope = vec2(dFdx(sc_EXPECTED()), dFdy(sc_EXPECTED())) / sc_UNIT();
    jacobian = vec4(dFdx(place), dFdy(place));
}

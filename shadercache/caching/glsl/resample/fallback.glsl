// Where the four texels do not agree, the nearest by itself.

int sc_RESAMPLE(ivec2 last, vec2 part, ivec2 near,
        sc_TEXELS a, sc_TEXELS b, sc_TEXELS c, sc_TEXELS d,
        vec4 fits, inout vec4 weights, bool agrees, inout bool marked, inout sc_TEXELS sc_texel) {
    if (!agrees) {
        bool right = part.x >= 0.5;
        bool top = part.y >= 0.5;
        if ((top ? (right ? fits.w : fits.z) : (right ? fits.y : fits.x)) == 0.0) {
            return sc_NO_FIT();
        }
        sc_texel = top ? (right ? d : c) : (right ? b : a);
        marked = true;
    }
}

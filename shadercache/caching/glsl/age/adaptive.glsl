// The period of a payload adapts: what changes when it is refreshed is refreshed more often, what does
// not ever more seldom, up to the period itself. How often the period is halved is kept in the texel.

int sc_VERDICT() {
    return sc_verdict(sc_texel);
}

int sc_RAW_VERDICT() {
    return sc_verdict(sc_texel);
}

void sc_AGING() {
    sc_adapt();
}

// The last frame's payload is needed where it was found and refreshed nevertheless.
void sc_RECALL() {
    sc_TEXELS sc_texel;
    sc_look_up(sc_texel);
}

bool sc_refreshed = false;  // is a payload that was found computed anew?

// Does the turn come of what was found? Each turn comes once in a halved period as well.
int sc_verdict(sc_TEXELS sc_texel) {
    sc_REMEMBER();
    sc_halvings = sc_HALVINGS(sc_texel, sc_texel_2);
    float span = max(1.0, floor(float(sc_period) * exp2(-ceil(sc_halvings))));
    float phase = float(sc_turn() + sc_clock);
    sc_refreshed = phase - span * floor((phase + 0.5) / span) == 0.0;
    return sc_refreshed ? sc_refresh : sc_hit;
}

// Shorter at once, longer in two steps, and only if twice as long would be within the bound. What was
// not found is refreshed four times as often as need be, until more is known.
void sc_adapt() {
    float most = log2(float(sc_period)) + 1.0;
    if (sc_refreshed) {
        float change = sc_change_of();
        float step = change <= sc_change ? (change <= 0.5 * sc_change ? -0.5 : 0.0) : 1.0;
        sc_halvings = clamp(sc_halvings + step, 0.0, most);
    } else if (sc_halvings < 0.0) {
        sc_halvings = min(2.0, most);
    }
}

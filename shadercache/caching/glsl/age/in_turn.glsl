// With a schedule: ages and turns.

// May what was `age` frames old in the last frame be reused once more? A payload that is less than
// half a period old misses its turn: it was computed out of turn, and is renewed when it gets too
// old.
int sc_judge(float age) {
    // A comparison with NaN is false, so that no such age lives on.
    if (!(age + 1.0 <= float(sc_period))) {
        return sc_miss_old;
    }
    if (2.0 * (age + 1.0) >= float(sc_period) && sc_due()) {
        return sc_refresh;
    }
    sc_age = age + 1.0;
    return sc_hit;
}

// Without a schedule: nothing but ages.

// May what was `age` frames old in the last frame be reused once more?
int sc_judge(float age) {
    // A comparison with NaN is false, so that no such age lives on.
    if (!(age + 1.0 < float(sc_period))) {
        return sc_miss_old;
    }
    sc_age = age + 1.0;
    return sc_hit;
}

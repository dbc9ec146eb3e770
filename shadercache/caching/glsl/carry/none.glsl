// What is stored of a hit is what was shown.

void sc_CARRY() {
}

void sc_CARRY_IF(bool reused) {
}

void sc_FIND_RAW() {
}

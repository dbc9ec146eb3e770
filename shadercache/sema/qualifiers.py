"""Which qualifiers go together, in which order and where (GLSL 3.30 sections 4.3, 4.5, 4.7)."""

from __future__ import annotations

INTERPOLATION = ("flat", "smooth", "noperspective")
AUXILIARY = ("centroid", "sample", "patch")
STORAGE = ("const", "in", "out", "inout", "uniform", "buffer", "shared", "attribute", "varying")
MEMORY = ("coherent", "volatile", "restrict", "readonly", "writeonly")
PRECISION = ("highp", "mediump", "lowp")

_RANKS = {
    "precise": 0,
    "invariant": 1,
    **dict.fromkeys(INTERPOLATION, 2),
    **dict.fromkeys(AUXILIARY, 3),
    **dict.fromkeys(STORAGE, 4),
}
_GROUPS = (INTERPOLATION, AUXILIARY, STORAGE, PRECISION)
_FREE_ORDER = 420


def words_problem(words: tuple[str, ...], version: int) -> str | None:
    """What is wrong with these words beside each other, wherever they stand."""
    if len(words) < 2:
        return None
    for group in _GROUPS:
        found = [word for word in words if word in group]
        if len(found) > 1 and sorted(found) != ["const", "in"]:
            return f"'{' '.join(found)}' contradict or repeat each other"
    if len(set(words)) < len(words):
        return f"'{' '.join(words)}' repeat each other"
    # Drivers and glslang take precision words anywhere, and so does this.
    ordered = sorted((word for word in words if word in _RANKS), key=_RANKS.__getitem__)
    if version < _FREE_ORDER and ordered != [word for word in words if word in _RANKS]:
        return f"before GLSL 4.20 the order of these qualifiers is '{' '.join(ordered)}'"
    return None


def global_problem(words: tuple[str, ...], stage: str, storage: str) -> str | None:
    """What is wrong with these words on a global variable that is stored as ``storage``."""
    if "inout" in words:
        return "'inout' stands only on parameters"
    passed_on = (stage == "fragment") == (storage == "in")
    if storage not in ("in", "out"):
        passed_on = False
    for word in words:
        if word in (*INTERPOLATION, *AUXILIARY) and not passed_on:
            return f"'{word}' stands only on what a vertex shader passes to a fragment shader"
        if word == "invariant" and (storage == "in" and stage == "vertex"):
            return "an attribute cannot be invariant"
        if word == "invariant" and storage not in ("in", "out"):
            return "'invariant' stands only on inputs and outputs"
    return None

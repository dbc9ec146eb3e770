"""Which qualifiers go together, in which order and where (GLSL 3.30 sections 4.3, 4.5, 4.7)."""

from __future__ import annotations

INTERPOLATION = (
    *("flat", "smooth", "noperspective"),
    *("pervertexEXT", "pervertexNV", "__explicitInterpAMD"),
)
AUXILIARY = ("centroid", "sample", "patch")
STORAGE = ("const", "in", "out", "inout", "uniform", "buffer", "shared", "attribute", "varying")
MEMORY = ("coherent", "volatile", "restrict", "readonly", "writeonly")
PRECISION = ("highp", "mediump", "lowp")

_RANKS = {
    "precise": 0,
    "invariant": 1,
    **dict.fromkeys(INTERPOLATION, 2),
    **dict.fromkeys(AUXILIARY, 3),
    **dict.fromkeys(STORAGE, 5),
    "const": 4,
    **dict.fromkeys(PRECISION, 6),
}
_ANYWHERE = (*STORAGE, *PRECISION)
_GROUPS = (INTERPOLATION, AUXILIARY, STORAGE, PRECISION)


def words_problem(words: tuple[str, ...], *, es: bool, in_any_order: bool) -> str | None:
    """What is wrong with these words beside each other, wherever they stand.

    Their order is free from 4.20 and ES 3.10 on (section 4.7 of 3.30, 4.10 of 4.20).
    """
    if len(words) < 2:
        return None
    for group in _GROUPS:
        found = [word for word in words if word in group]
        if len(found) > 1 and sorted(found) != ["const", "in"]:
            return f"'{' '.join(found)}' contradict or repeat each other"
    if len(set(words)) < len(words):
        return f"'{' '.join(words)}' repeat each other"
    ranked = [word for word in words if word in _RANKS]
    if not es and not any(word in _RANKS and word not in _ANYWHERE for word in words):
        # Compilers of desktop GLSL let go of precisions beside a storage qualifier.
        ranked = [word for word in ranked if word not in PRECISION]
    ordered = sorted(ranked, key=_RANKS.__getitem__)
    if ordered != ranked and not in_any_order:
        since = "GLSL ES 3.10" if es else "GLSL 4.20"
        return f"before {since} the order of these qualifiers is '{' '.join(ordered)}'"
    return None


def global_problem(
    words: tuple[str, ...], stage: str, storage: str, invariable: tuple[str, ...]
) -> str | None:
    """What is wrong with these words on a global variable that is stored as ``storage``;
    ``invariable`` is what may be ``invariant``."""
    if "inout" in words:
        return "'inout' stands only on parameters"
    passed_on = (stage == "fragment") == (storage == "in")
    if storage not in ("in", "out"):
        passed_on = False
    for word in words:
        if word in (*INTERPOLATION, *AUXILIARY) and not passed_on:
            return f"'{word}' stands only on what a vertex shader passes to a fragment shader"
        if word == "invariant" and storage not in invariable:
            return "'invariant' stands only on what a shader passes on"
    return None

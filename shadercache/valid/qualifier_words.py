"""Which qualifiers go together, in which order and where (GLSL 3.30 sections 4.3, 4.5, 4.7)."""

from __future__ import annotations

from shadercache.lang.words import NONUNIFORM
from shadercache.sema.language import Language

_INTERPOLATION = (
    *("flat", "smooth", "noperspective"),
    *("pervertexEXT", "pervertexNV", "__explicitInterpAMD"),
)
_AUXILIARY = ("centroid", "sample", "patch")
STORAGE = ("const", "in", "out", "inout", "uniform", "buffer", "shared", "attribute", "varying")
"""The words that say how something is stored."""
_PRECISION = ("highp", "mediump", "lowp")

_RANKS = {
    "precise": 0,
    "invariant": 1,
    **dict.fromkeys(_INTERPOLATION, 2),
    **dict.fromkeys(_AUXILIARY, 3),
    NONUNIFORM: 3,
    **dict.fromkeys(STORAGE, 5),
    # Behind STORAGE, which it belongs to, but it comes first: `const in float x`.
    "const": 4,
    **dict.fromkeys(_PRECISION, 6),
}
_ANYWHERE = (*STORAGE, *_PRECISION)
_GROUPS = (_INTERPOLATION, _AUXILIARY, STORAGE, _PRECISION)


def words_problem(words: tuple[str, ...], language: Language) -> str | None:
    """What is wrong with these words beside each other, wherever they stand.

    Their order is free from 4.20 and ES 3.10 on (section 4.7 of 3.30, 4.10 of 4.20).
    """
    if len(words) < 2:
        return None
    for group in _GROUPS:
        same = [word for word in words if word in group]
        if len(same) > 1 and sorted(same) != ["const", "in"]:
            return f"'{' '.join(same)}' contradict or repeat each other"
    if len(set(words)) < len(words):
        return f"'{' '.join(words)}' repeat each other"
    ranked = [word for word in words if word in _RANKS]
    if not language.es and not any(word in _RANKS and word not in _ANYWHERE for word in words):
        # Compilers of desktop GLSL let go of precisions beside a storage qualifier.
        ranked = [word for word in ranked if word not in _PRECISION]
    ordered = sorted(ranked, key=_RANKS.__getitem__)
    if ordered != ranked and language.qualifier_version < (310 if language.es else 420):
        since = "GLSL ES 3.10" if language.es else "GLSL 4.20"
        return f"before {since} the order of these qualifiers is '{' '.join(ordered)}'"
    return None


def global_problem(words: tuple[str, ...], storage: str, language: Language) -> str | None:
    """What is wrong with these words on a global variable that is stored as ``storage``."""
    if "inout" in words:
        return "'inout' stands only on parameters"
    passed_on = storage in ("in", "out") and (language.stage == "fragment") == (storage == "in")
    for word in words:
        if word in (*_INTERPOLATION, *_AUXILIARY) and not passed_on:
            return f"'{word}' stands only on what a vertex shader passes to a fragment shader"
        if word == "invariant" and storage not in invariable(language):
            return "'invariant' stands only on what a shader passes on"
    return None


def invariable(language: Language) -> tuple[str, ...]:
    """The storages of what may be ``invariant``: in older versions inputs as well."""
    inputs = language.stage == "fragment" and not language.at_least(420, 300)
    return ("out", "in") if inputs else ("out",)


def version_problem(words: tuple[str, ...], language: Language) -> str | None:
    """Words that a version or a profile does not have."""
    gone = not language.es and language.version >= 420 and language.profile != "compatibility"
    for word in words:
        if word in ("attribute", "varying") and gone:
            return f"'{word}' is gone from the core profile since GLSL 4.20"
        if word in ("in", "out") and not language.at_least(130, 300):
            return f"'{word}' stands on parameters only before GLSL 1.30 and GLSL ES 3.00"
    return "'shared' is for compute shaders" if "shared" in words else None

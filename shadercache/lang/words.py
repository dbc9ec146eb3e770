"""The words and operators of GLSL: keywords, type names, reserved words, precedences.

Source: The OpenGL Shading Language 3.30, sections 3.6 (keywords) and 5.1 (operators), with the
words that versions 4.00 to 4.60 add. The parser folds operator chains by the same precedence
table that the printer sets parentheses by, so the two cannot disagree.
"""

from __future__ import annotations

from functools import cache

# --- type names -----------------------------------------------------------------------------------


def _with_int_kinds(*samplers: str) -> tuple[str, ...]:
    """Each opaque type with its signed and unsigned integer twin."""
    return tuple(kind + name for name in samplers for kind in ("", "i", "u"))


TYPES_330: frozenset[str] = frozenset(
    (
        *("void", "bool", "int", "uint", "float"),
        *(f"{kind}vec{size}" for kind in ("", "b", "i", "u") for size in (2, 3, 4)),
        *(f"mat{size}" for size in (2, 3, 4)),
        *(f"mat{columns}x{rows}" for columns in (2, 3, 4) for rows in (2, 3, 4)),
        *_with_int_kinds("sampler1D", "sampler2D", "sampler3D", "samplerCube"),
        *_with_int_kinds("sampler1DArray", "sampler2DArray", "sampler2DRect"),
        *_with_int_kinds("samplerBuffer", "sampler2DMS", "sampler2DMSArray"),
        *("sampler1DShadow", "sampler2DShadow", "samplerCubeShadow"),
        *("sampler1DArrayShadow", "sampler2DArrayShadow", "sampler2DRectShadow"),
    )
)
"""The names of the types that are built into GLSL 3.30."""

TYPES_400: frozenset[str] = frozenset(
    (
        "double",
        *(f"dvec{size}" for size in (2, 3, 4)),
        *(f"dmat{size}" for size in (2, 3, 4)),
        *(f"dmat{columns}x{rows}" for columns in (2, 3, 4) for rows in (2, 3, 4)),
        *_with_int_kinds("samplerCubeArray"),
        "samplerCubeArrayShadow",
    )
)
"""The names of the types that version 4.00 adds."""

TYPES_420: frozenset[str] = frozenset(
    (
        "atomic_uint",
        *_with_int_kinds("image1D", "image2D", "image3D", "imageCube", "image2DRect"),
        *_with_int_kinds("image1DArray", "image2DArray", "imageCubeArray", "imageBuffer"),
        *_with_int_kinds("image2DMS", "image2DMSArray"),
    )
)
"""The names of the types that version 4.20 adds."""

# --- other keywords -------------------------------------------------------------------------------

PRECISIONS = frozenset(("highp", "mediump", "lowp"))

QUALIFIERS_330: frozenset[str] = PRECISIONS | {
    *("const", "in", "out", "inout", "uniform", "attribute", "varying"),
    *("centroid", "flat", "smooth", "noperspective", "invariant"),
}
QUALIFIERS_400 = frozenset(("precise", "patch", "sample"))
QUALIFIERS_420 = frozenset(("coherent", "volatile", "restrict", "readonly", "writeonly"))
QUALIFIERS_430 = frozenset(("buffer", "shared"))

STATEMENT_WORDS = frozenset(
    (
        *("if", "else", "for", "while", "do", "switch", "case", "default"),
        *("break", "continue", "return", "discard", "struct", "layout", "precision"),
    )
)

TRUTH_WORDS = frozenset(("true", "false"))

_RESERVED_330: frozenset[str] = frozenset(
    (
        *("common", "partition", "active", "asm", "class", "union", "enum", "typedef"),
        *("template", "this", "goto", "inline", "noinline", "volatile", "public"),
        *("static", "extern", "external", "interface", "long", "short", "double", "half"),
        *("fixed", "unsigned", "superp", "input", "output", "filter", "sizeof", "cast"),
        *("namespace", "using", "sampler3DRect", "shared"),
        *(f"{kind}vec{size}" for kind in ("h", "d", "f") for size in (2, 3, 4)),
        *_with_int_kinds("image1D", "image2D", "image3D", "imageCube"),
        *_with_int_kinds("image1DArray", "image2DArray", "imageBuffer"),
        *("image1DShadow", "image2DShadow", "image1DArrayShadow", "image2DArrayShadow"),
    )
)

QUALIFIER_ORDER: dict[str, int] = {
    word: rank
    for rank, group in enumerate(
        (
            ("precise",),
            ("invariant",),
            ("smooth", "flat", "noperspective"),
            ("const", "centroid", "patch", "sample"),
            ("in", "out", "inout", "uniform", "buffer", "shared", "attribute", "varying"),
            ("coherent", "volatile", "restrict", "readonly", "writeonly"),
            ("highp", "mediump", "lowp"),
        )
    )
    for word in group
}
"""The order that versions before 4.20 demand of qualifiers; layouts may stand anywhere in it."""


def type_names(version: int) -> frozenset[str]:
    """The built-in type names of a version (330 to 460)."""
    names = TYPES_330
    if version >= 400:
        names |= TYPES_400
    return names | TYPES_420 if version >= 420 else names


def qualifier_words(version: int) -> frozenset[str]:
    """The qualifier keywords of a version (330 to 460)."""
    words = QUALIFIERS_330
    for since, added in ((400, QUALIFIERS_400), (420, QUALIFIERS_420), (430, QUALIFIERS_430)):
        if version >= since:
            words |= added
    return words


@cache
def keywords(version: int) -> frozenset[str]:
    """Every word that a version gives a meaning to."""
    return type_names(version) | qualifier_words(version) | STATEMENT_WORDS | TRUTH_WORDS


@cache
def reserved_words(version: int) -> frozenset[str]:
    """Words that a version reserves without giving them a meaning."""
    later = frozenset(("subroutine",)) if version >= 400 else frozenset()
    return (_RESERVED_330 | later) - keywords(version)


ALL_WORDS: frozenset[str] = keywords(460) | reserved_words(330) | reserved_words(460)
"""Every word that is a keyword or reserved in some version from 330 to 460.

A fresh name keeps clear of all of them.
"""

# --- operators ------------------------------------------------------------------------------------

COMMA = 1
ASSIGN = 2
CONDITIONAL = 3
UNARY = 15
POSTFIX = 16
PRIMARY = 17

PRECEDENCE: dict[str, int] = {
    "||": 4,
    "^^": 5,
    "&&": 6,
    "|": 7,
    "^": 8,
    "&": 9,
    **dict.fromkeys(("==", "!="), 10),
    **dict.fromkeys(("<", ">", "<=", ">="), 11),
    **dict.fromkeys(("<<", ">>"), 12),
    **dict.fromkeys(("+", "-"), 13),
    **dict.fromkeys(("*", "/", "%"), 14),
}
"""Binary operators; a higher number binds tighter, and all associate to the left."""

ASSIGN_OPS: frozenset[str] = frozenset(
    ("=", "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|=")
)
SIGN_OPS = frozenset(("+", "-"))
PREFIX_OPS = frozenset(("!", "~"))
STEP_OPS = frozenset(("++", "--"))

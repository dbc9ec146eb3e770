"""The words and operators of GLSL: keywords, type names, reserved words, precedences.

The words stand in ``words.txt`` beside this file; section 5.1 of the specifications has the
operators. The parser folds operator chains by the same precedence table that the printer sets
parentheses by, so the two cannot disagree.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from shadercache.lang.availability import (
    NO_EXTENSIONS,
    Availability,
    availability,
    data_lines,
    number,
    settings,
)

# --- keywords and reserved words ------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Row:
    """Words with the same history: where they are keywords, and since when they are reserved."""

    words: frozenset[str]
    section: str
    keywords: Availability
    reserved: int
    reserved_es: int


def _rows() -> Iterator[_Row]:
    for section, text, shared in data_lines(Path(__file__).with_name("words.txt")):
        names, _, history = text.partition(":")
        words: set[str] = set()
        for name in names.split():
            plain = name.removeprefix("g")
            # Only there a g stands for three types; other words may begin with one, too.
            opaque = name != plain and plain.startswith(_OF_THREE)
            words |= {plain, f"i{plain}", f"u{plain}"} if opaque else {name}
        of_row = (*history.split(), *shared)
        since = settings(of_row)
        reserved = (number(since.get(key, "-")) for key in ("reserved", "reserved_es"))
        yield _Row(frozenset(words), section, availability(of_row), *reserved)


_OF_THREE = ("sampler", "image", "texture", "subpassInput")

# From 1.40 on it is the layout of a block, and an ordinary name elsewhere.
_PACKED_UNTIL = 130
_ROWS = tuple(_rows())

PRECISIONS = frozenset(("highp", "mediump", "lowp"))
MEMORY_QUALIFIERS = ("coherent", "volatile", "restrict", "readonly", "writeonly")
BUILTIN_STRUCTS = frozenset(
    (
        *("gl_DepthRangeParameters", "gl_PointParameters", "gl_MaterialParameters"),
        *("gl_LightSourceParameters", "gl_LightModelParameters", "gl_LightModelProducts"),
        *("gl_LightProducts", "gl_FogParameters"),
    )
)
"""The structs that are declared from the start (section 7.4.1 of 4.60)."""

TRUTH_WORDS = frozenset(("true", "false"))
STATEMENT_WORDS: frozenset[str] = frozenset().union(
    *(row.words for row in _ROWS if row.section == "statements")
)
"""The words that begin or divide statements, in any version."""

VERSIONS = (110, 120, 130, 140, 150, 330, 400, 410, 420, 430, 440, 450, 460)
ES_VERSIONS = (100, 300, 310, 320)

NONUNIFORM = "nonuniformEXT"
"""A qualifier of variables, and before a bracket a function (GL_EXT_nonuniform_qualifier)."""

QUALIFIER_ORDER: dict[str, int] = {
    word: rank
    for rank, group in enumerate(
        (
            ("precise",),
            ("invariant",),
            ("smooth", "flat", "noperspective"),
            ("pervertexEXT", "pervertexNV", "__explicitInterpAMD"),
            ("const", "centroid", "patch", "sample"),
            (NONUNIFORM,),
            MEMORY_QUALIFIERS,
            ("in", "out", "inout", "uniform", "buffer", "shared", "attribute", "varying"),
            ("highp", "mediump", "lowp"),
        )
    )
    for word in group
}
"""The order that versions before 4.20 demand of qualifiers; layouts may stand anywhere in it, and
so may what is said about memory, but that Mesa wants it ahead of the storage of a block."""


def _words_of(section: str, version: int, es: bool, extensions: frozenset[str]) -> frozenset[str]:
    profile = "es" if es else None
    return frozenset().union(
        *(
            row.words
            for row in _ROWS
            if section in ("", row.section)
            and row.keywords.holds(version, profile, None, extensions)
        )
    )


@cache
def type_names(
    version: int, es: bool = False, extensions: frozenset[str] = NO_EXTENSIONS
) -> frozenset[str]:
    """The names of the types that are built into a version.

    ``version`` is the number of ``#version`` (100 to 460), ``es``: it is one of GLSL ES;
    ``extensions`` are those that ``#extension`` turned on. The same for the other functions.
    """
    return _words_of("types", version, es, extensions)


@cache
def qualifier_words(
    version: int, es: bool = False, extensions: frozenset[str] = NO_EXTENSIONS
) -> frozenset[str]:
    """The qualifier keywords of a version."""
    return _words_of("qualifiers", version, es, extensions)


@cache
def keywords(
    version: int, es: bool = False, extensions: frozenset[str] = NO_EXTENSIONS
) -> frozenset[str]:
    """Every word that a version gives a meaning to."""
    return _words_of("", version, es, extensions) | TRUTH_WORDS


@cache
def reserved_words(
    version: int, es: bool = False, extensions: frozenset[str] = NO_EXTENSIONS
) -> frozenset[str]:
    """Words that a version reserves without giving them a meaning."""
    rows = [row for row in _ROWS if version >= (row.reserved_es if es else row.reserved)]
    packed = {"packed"} if version <= _PACKED_UNTIL else set()
    # An extension makes keywords of words that its version merely reserves.
    return frozenset(packed.union(*(row.words for row in rows))) - keywords(version, es, extensions)


def keyword_since(word: str, es: bool = False) -> int | None:
    """The first version that gives the word a meaning without an extension, or ``None``."""
    return next((v for v in (ES_VERSIONS if es else VERSIONS) if word in keywords(v, es)), None)


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

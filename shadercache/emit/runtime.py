"""The fixed GLSL text of the variants, parsed.

It stands in the ``.glsl`` files of this folder; the payloads' types and how they are packed are
filled in through macros.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path
from typing import TypeAlias, get_args

from shadercache.analysis.mapping import MappingKind
from shadercache.ast import nodes as n
from shadercache.caching.configuration import DEFAULT_EPSILON, Configuration
from shadercache.caching.settings import cache_choices, written_settings
from shadercache.emit.layout import MOST_OF_HALF, Layout
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.names import PREFIX
from shadercache.transform.strip_spans import without_places

OUTCOMES = {
    **{"hit": 1, "refresh": 2, "outside": 3, "depth": 4},
    **{"id": 5, "poison": 6, "magnified": 7, "opted-out": 8, "old": 9},
}
"""What a look-up says, as the hit mask shows it (0: nothing is drawn there)."""

_OPTIONAL = {
    "id": lambda chosen: chosen.hit_test.ids,
    "poison": lambda chosen: chosen.storage.guard == "miss",
    "magnified": lambda chosen: chosen.hit_test.magnification,
    "opted-out": lambda chosen: chosen.hit_test.mask,
    "old": lambda chosen: chosen.refresh.age,
}
"""Outcome -> do look-ups of such a configuration say so? (The others always do.)"""

Settings: TypeAlias = tuple[tuple[str, str], ...]
"""Key and word of each setting (:mod:`caching.settings`)."""

DEFAULT_SETTINGS: Settings = tuple(written_settings(Configuration()).items())

FOLDER = Path(__file__).with_name("glsl")

SPREAD = 24.0
"""How many epsilons a single texel of the filter may be off in depth (docs/why/reuse.md)."""


INTERPOLATION = 1.2e-5
"""What the interpolation of positions leaves uncertain in 1/w, relative to it: 4.3e-4 of a pixel,
on the steepest slope that ``SPREAD`` lets through, and rounding (docs/why/reuse.md)."""

LEAST_WEIGHT = 0.25
"""What those texels must weigh together that fit in the depth-aware filter: as the nearest may."""

_NUMBERS = {
    "SPREAD": str(SPREAD),
    "EPSILON": str(DEFAULT_EPSILON),
    "INTERPOLATION": str(INTERPOLATION),
    "LEAST_WEIGHT": str(LEAST_WEIGHT),
    "MOST_OF_HALF": str(MOST_OF_HALF),
}


@dataclass(frozen=True, slots=True)
class Located:
    """How a pass finds its texel; ``own_current``: does the user say where the pixel itself is?"""

    mapping: MappingKind = "surface"
    own_current: bool = False

    @property
    def macros(self) -> dict[str, str]:
        """The macros of the ``.glsl`` files that tell the mapping."""
        marks = {kind.upper(): kind == self.mapping for kind in get_args(MappingKind)}
        marks["OWN_CURRENT"] = self.own_current
        return {name: str(int(mark)) for name, mark in marks.items()}


ON_SURFACE = Located()


def outcomes(configuration: Configuration) -> dict[str, int]:
    """What a look-up can say."""
    return {
        word: value
        for word, value in OUTCOMES.items()
        if word not in _OPTIONAL or _OPTIONAL[word](configuration)
    }


@cache
def option_macros(settings: Settings) -> dict[str, str]:
    """A macro for each thing that can be chosen, 1 where it is: ``REFRESH_RANDOM``, ``IDS``."""
    choices = cache_choices()
    marks: dict[str, bool] = {}
    for key, value in settings:
        name, known = key.upper(), choices[key]
        if "on" in known:
            marks[name] = value == "on"
        else:
            marks |= {f"{name}_{_word(word)}": word == value for word in known}
    return {name: str(int(mark)) for name, mark in marks.items()}


@lru_cache(maxsize=512)  # each struct of each shader is a type of its own
def load_part(
    name: str,
    layout: Layout,
    prefix: str,
    whole: bool = False,
    located: Located = ON_SURFACE,
    settings: Settings = DEFAULT_SETTINGS,
    looks: bool = True,
) -> tuple[n.Decl, ...]:
    """The declarations of one file, for payloads of this layout, with the given name prefix.

    ``whole``: not every fragment has the payloads. ``looks``: is there a look-up in the pass?
    """
    macros = layout.macros(prefix, whole) | located.macros | _NUMBERS
    macros |= option_macros(settings) | {"LOOKS": str(int(looks))}
    macros |= {_word(key): str(value) for key, value in OUTCOMES.items()}
    # Names of the user's can stand in what a macro means; none begins with the prefix.
    capitals = prefix.upper()
    lines = ["#version 330", *(f"#define {capitals}{key} {macros[key]}" for key in macros)]
    # The parser has to know that these are types; what is in them is declared by the user.
    lines += [f"struct {struct} {{ float unknown; }};" for struct in layout.structs]
    text = (_text("macros") + _text(name)).replace(PREFIX, prefix)
    text = text.replace(PREFIX.upper(), capitals)
    source = Source(f"{name}.glsl", "\n".join([*lines, text]))
    decls = parse(source).decls[len(layout.structs) :]
    return tuple(without_places(decl) for decl in decls)


def _word(text: str) -> str:
    return text.upper().replace("-", "_")


def _text(name: str) -> str:
    return (FOLDER / f"{name}.glsl").read_text(encoding="utf-8")


@cache
def runtime_names(prefix: str) -> frozenset[str]:
    """Every name that any of the files declares or expects."""
    files = [*FOLDER.glob("*.glsl"), *FOLDER.glob("passes/*.glsl")]
    words = {w for f in files for w in re.findall(r"\bsc_\w+", f.read_text(encoding="utf-8"))}
    return frozenset(word.replace(PREFIX, prefix, 1) for word in words)

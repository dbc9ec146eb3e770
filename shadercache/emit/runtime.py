"""The fixed GLSL text of the variants, parsed.

It stands in the ``.glsl`` files of this folder; the payload's type is filled in through macros.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from shadercache.ast import nodes as n
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.forget_places import without_places
from shadercache.transform.names import PREFIX

OUTCOMES = {"hit": 1, "refresh": 2, "outside": 3, "depth": 4}
"""What a look-up says, as the hit mask shows it (0: nothing is drawn there)."""

FOLDER = Path(__file__).with_name("glsl")

SPREAD = 24.0
"""How many epsilons a single texel of the filter may be off in depth (docs/NUMERICS.md)."""

_CHANNELS = ("x", "xy", "xyz")


@cache
def load_part(
    name: str, components: int, prefix: str, precision: str | None = None
) -> tuple[n.Decl, ...]:
    """The declarations of one file, for a payload of 1 to 3 floats, with the given name prefix.

    ``precision`` is the payload's, in GLSL ES.
    """
    kind = "float" if components == 1 else f"vec{components}"
    macros = {
        "PAYLOAD": f"{precision} {kind}" if precision else kind,
        "CHANNELS": _CHANNELS[components - 1],
        "SC_SPREAD": str(SPREAD),
        "PADDING": ", 0.0" * (3 - components),
        **{f"SC_{key.upper()}": str(value) for key, value in OUTCOMES.items()},
    }
    lines = ["#version 330", *(f"#define {key} {value}" for key, value in macros.items())]
    text = (FOLDER / f"{name}.glsl").read_text(encoding="utf-8")
    source = Source(f"{name}.glsl", "\n".join([*lines, text.replace(PREFIX, prefix)]))
    return tuple(without_places(decl) for decl in parse(source).decls)


@cache
def runtime_names(prefix: str) -> frozenset[str]:
    """Every name that any of the files declares or expects."""
    files = [*FOLDER.glob("*.glsl"), *FOLDER.glob("passes/*.glsl")]
    words = {w for f in files for w in re.findall(r"\bsc_\w+", f.read_text(encoding="utf-8"))}
    return frozenset(word.replace(PREFIX, prefix, 1) for word in words)

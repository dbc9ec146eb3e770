"""The ``.glsl`` files of the passes, beside those that the slots choose from."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from shadercache.ast import nodes as n
from shadercache.caching.algorithms import PARKED
from shadercache.caching.fill import returned
from shadercache.caching.read_template import FOLDER as SLOTS
from shadercache.caching.read_template import read_template
from shadercache.caching.slots import NUMBERS
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.names import PREFIX

FOLDER = Path(__file__).with_name("glsl")

_MADE = (
    "sc_discrete sc_no_depth sc_poison_depth sc_missed_depth sc_pack sc_payload "
    "sc_valid sc_unpark sc_place sc_frag_coord sc_front_facing sc_point_coord sc_primitive"
)
"""Names of :mod:`shadercache.caching.payload_text` and :mod:`shadercache.emit.parking`."""

_PARKING = ("park", PARKED, "lanes")
"""Names of :mod:`shadercache.emit.parking`, of which there is one for each target."""

_MOST_PAYLOADS = 7  # A scalar for each channel of two texels but the depth's.


def vertex_part(prefix: str) -> tuple[n.Decl, ...]:
    """What stands behind the user's vertex shader."""
    return read_template(FOLDER / "vertex.glsl", prefix).decls


def whole_picture(prefix: str) -> tuple[n.Decl, n.Expr]:
    """``gl_FragCoord`` of the whole picture in a pass that draws a smaller one: the uniform that it
    takes, and the expression."""
    scale, function = read_template(FOLDER / "whole_picture.glsl", prefix).decls
    assert isinstance(function, n.FunctionDef)
    return scale, returned(function, ())


def full_screen_vertex(fragment: n.Module, prefix: str = PREFIX) -> tuple[Source, n.Module]:
    """The vertex shader of a full-screen pass, in the version of a fragment shader.

    One triangle covers the target, from ``gl_VertexID`` alone: the engine binds no attribute.
    """
    return _screen_vertex("full_screen.vert", fragment, prefix)


def group_vertex(fragment: n.Module, prefix: str) -> tuple[Source, n.Module]:
    """The same for a pass that is drawn once for each group of objects, at a depth of its own."""
    return _screen_vertex("group.vert", fragment, prefix)


def _screen_vertex(name: str, fragment: n.Module, prefix: str) -> tuple[Source, n.Module]:
    version = f"#version {fragment.version} {fragment.profile or ''}".rstrip()
    text = (FOLDER / name).read_text(encoding="utf-8")
    for word, number in NUMBERS.items():
        text = text.replace(f"{PREFIX}{word}", number)
    text = text.replace(PREFIX, prefix)
    source = Source(name.replace("_", "-"), f"{version}\n{text}")
    return source, parse(source)


@cache
def runtime_names(prefix: str) -> frozenset[str]:
    """Every name that any of the files declares or expects."""
    files = [*SLOTS.rglob("*.glsl"), *FOLDER.rglob("*.glsl"), FOLDER / "group.vert"]
    texts = [_MADE, *(file.read_text(encoding="utf-8") for file in files)]
    words = {word for text in texts for word in re.findall(r"\bsc_[a-z]\w*", text)}
    # A second texture gives a second one of whatever is there for each (caching/per_target.py).
    words |= {f"{word}_2" for word in words}
    for number in range(1, _MOST_PAYLOADS + 1):
        words |= {f"sc_{name}_{number}" for name in ("payload", "valid", *_PARKING)}
    return frozenset(word.replace(PREFIX, prefix, 1) for word in words)

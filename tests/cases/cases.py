"""The cases: fragment shaders, each of which is a trap for one thing the compiler might get wrong.

Beside each stands what is expected of it: ``name.txt`` has a line for every node. Of those named
``unrolled_...`` the loops are unrolled.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import shortened
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

FOLDER = Path(__file__).parent
NAMES = sorted(path.stem for path in FOLDER.glob("*.frag"))

WIDTH = 90

_VERSION = re.compile(r"#version (\d+)")


def sources(name: str) -> tuple[Source, Source]:
    """The case's fragment shader and the vertex shader of its version."""
    return tuple(
        Source(path.name, path.read_text(encoding="utf-8"))
        for path in (FOLDER / f"{name}.frag", vertex(name))
    )


def vertex(name: str) -> Path:
    """The vertex shader of the case's version."""
    return vertex_for(FOLDER / f"{name}.frag")


def vertex_for(fragment: Path) -> Path:
    """The vertex shader of the version of a fragment shader."""
    version = _VERSION.match(fragment.read_text(encoding="utf-8"))
    assert version is not None
    found = FOLDER / f"shader_{version[1]}.vert"
    return found if found.exists() else FOLDER / "shader.vert"


@cache
def analysed(name: str) -> Analysis:
    """What the compiler makes of a case. Raises :class:`InputError` where it refuses it whole."""
    return analyse(*sources(name), ReadOptions(unroll=name.startswith("unrolled_")))


def told(name: str, analysis: Analysis) -> list[Candidate]:
    """The nodes of a case, but not those inside of ``wave``, which is the same in most of them."""
    if name == "called_twice":
        return list(analysis.nodes)
    return [node for node in analysis.nodes if not node.path.split(" > ")[-1].startswith("wave")]


def golden_text(name: str, analysis: Analysis) -> str:
    """A line for every node: offered or refused, where, what."""
    lines = []
    for node in told(name, analysis):
        verdict = node.refusal.code.code if node.refusal else "offered"
        lines.append(f"{verdict:8}{node.path}: {shortened(node.text, WIDTH)}\n")
    return "".join(lines)

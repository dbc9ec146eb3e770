"""The vertex shader of a full-screen pass, where the user has none.

It draws one triangle that covers the target, from ``gl_VertexID`` alone: the engine draws three
vertices and binds no attribute.
"""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.emit.runtime import FOLDER
from shadercache.front.parse import parse
from shadercache.source import Source


def full_screen_vertex(fragment: n.Module) -> tuple[Source, n.Module]:
    """The text and the tree of the shader, in the version of a fragment shader."""
    words = ["#version", str(fragment.version), fragment.profile or ""]
    version = " ".join(words).rstrip() + "\n"
    text = (FOLDER / "full_screen.vert").read_text(encoding="utf-8")
    source = Source("full-screen.vert", version + text)
    return source, parse(source)

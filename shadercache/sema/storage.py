"""How a variable is stored, by its qualifiers (GLSL 4.60 section 4.3)."""

from __future__ import annotations

from shadercache.ast.nodes import Qualifiers
from shadercache.lang.types import Type
from shadercache.sema.facts import Kind, Stage

_STORAGE: tuple[Kind, ...] = ("const", "uniform", "in", "out", "buffer")
PER_VERTEX = ("pervertexEXT", "pervertexNV")
"""Qualifiers of arrays with an element for each vertex of the triangle."""


def storage_of(qualifiers: Qualifiers, stage: Stage, *, local: bool) -> Kind:
    """The storage of a variable, or of the members of a block, with these qualifiers."""
    for word in qualifiers.words:
        for storage in _STORAGE:
            if word == storage:
                return storage
    if qualifiers.has("attribute"):
        return "in"
    if qualifiers.has("varying"):
        return "in" if stage == "fragment" else "out"
    return "local" if local else "global"


def of_one_vertex(kind: Type, qualifiers: Qualifiers) -> Type:
    """The type of what a vertex shader passes on: its value at each vertex takes no location more
    (GLSL_EXT_fragment_shader_barycentric)."""
    return kind.element if qualifiers.has(*PER_VERTEX) and kind.is_array else kind

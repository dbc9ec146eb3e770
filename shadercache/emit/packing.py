"""How uniform blocks lie in their buffers: their own words, and the defaults that stand in front.

``layout(std140) uniform;`` holds for the blocks behind it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from shadercache.ast import nodes as n
from shadercache.source import NOWHERE

PACKINGS = ("shared", "packed", "std140", "std430")
_MATRICES = ("column_major", "row_major")


@dataclass(frozen=True, slots=True)
class Packing:
    """How a block lies in its buffer, where nothing else is said of a member."""

    # What holds where a shader says nothing (GLSL 3.30 section 4.3.8.3).
    packing: str = "shared"
    matrices: str = "column_major"

    def under(self, qualifiers: n.Qualifiers) -> Packing:
        """With what a ``layout(...)`` changes; its words may be written in capitals."""
        packing = self
        for entry in qualifiers.layout or ():
            word = entry.name.lower()
            if word in PACKINGS:
                packing = replace(packing, packing=word)
            elif word in _MATRICES:
                packing = replace(packing, matrices=word)
        return packing


def has_word(qualifiers: n.Qualifiers, word: str) -> bool:
    """Is a word in the ``layout(...)``?"""
    return any(entry.name == word for entry in qualifiers.layout or ())


def is_default(decl: n.Decl, storage: str) -> bool:
    """Is it ``layout(...) uniform;``, or the same of buffers?"""
    return isinstance(decl, n.QualifierDecl) and not decl.names and decl.qualifiers.has(storage)


def with_layouts(decls: Sequence[n.Decl]) -> Iterable[n.Decl]:
    """The declarations, where uniform blocks say themselves what a later default would change."""
    # The twin of a block stands behind all of the user's, and there another default may hold.
    last = len(decls) - 1
    late = max((at for at in range(last + 1) if is_default(decls[at], "uniform")), default=-1)
    default = Packing()
    for at, decl in enumerate(decls):
        if isinstance(decl, n.QualifierDecl) and is_default(decl, "uniform"):
            default = default.under(decl.qualifiers)
        if at < late and isinstance(decl, n.BlockDecl) and decl.qualifiers.has("uniform"):
            yield _saying(decl, default.under(decl.qualifiers))
        else:
            yield decl


def _saying(block: n.BlockDecl, packing: Packing) -> n.BlockDecl:
    known = (*PACKINGS, *_MATRICES)
    rest = [i for i in block.qualifiers.layout or () if i.name.lower() not in known]
    words = (packing.packing, packing.matrices)
    layout = (*(n.LayoutItem(NOWHERE, word, None) for word in words), *rest)
    return replace(block, qualifiers=replace(block.qualifiers, layout=layout))

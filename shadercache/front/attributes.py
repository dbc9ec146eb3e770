"""Hints about loops and branches, ``[[unroll]] for (...)``, which shader translators write.

They tell a compiler how to run what follows, never what it means, so they are left out of the tree.

Source: GL_EXT_control_flow_attributes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from shadercache.ast.nodes import Directive
from shadercache.front.preprocess import Lexemes

_EXTENSIONS = (
    "GL_EXT_control_flow_attributes",  # The beginning of ..._attributes2, too.
    "GL_EXT_subgroup_uniform_control_flow",
)


def without_attributes(lexemes: Lexemes, directives: Iterable[Directive]) -> Lexemes:
    """The lexemes without attributes, where a directive brings in an extension that has them."""
    if not any(name in line.text for line in directives for name in _EXTENSIONS):
        return lexemes
    kept = Lexemes()
    at = begin = 0
    texts = lexemes.texts
    while at < len(texts):
        behind = _behind_attribute(texts, at)
        if behind > at:
            kept.add(lexemes, begin, at)
            begin = behind
        at = max(behind, at + 1)
    kept.add(lexemes, begin, len(texts))
    return kept


def _behind_attribute(texts: Sequence[str], at: int) -> int:
    """The index behind the attribute that begins at an index, or that index if none does."""
    if texts[at] != "[" or texts[at + 1 : at + 2] != ["["]:
        return at
    depth = 0
    for index in range(at, len(texts)):
        depth += (texts[index] in "([") - (texts[index] in ")]")
        if texts[index] in ";{}":
            break
        if depth == 0:
            return index + 1
    return at

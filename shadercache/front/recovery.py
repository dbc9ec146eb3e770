"""The beginning of a broken shader, made complete: what stands in front of its first mistake.

Of ::

    void main() { float a = b; if (a > 0.0) { a = 1 + ; } }

the mistake stands behind ``1 +``; what stands in front of it and makes sense by itself is ::

    void main() { float a = b; if (a > 0.0) { } }

so that the name ``b``, which nobody declared, can be told too.
"""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.front.preprocess import Lexemes

_PAIRS = {")": "(", "]": "[", "}": "{"}


def recoverable_beginnings(lexemes: Lexemes, offset: int) -> Iterator[tuple[Lexemes, int]]:
    """Beginnings of a text that end before an offset, the longest first, with their lengths.

    The first ends behind the last ``;``, ``{`` or ``}`` of a block, and behind that length has as
    many ``}`` added as blocks are open. The second ends behind a declaration.
    """
    # Included files have offsets of their own, behind those of the user's file.
    places = enumerate(lexemes.starts)
    if offset in lexemes.starts:
        first = lexemes.starts.index(offset)
    else:
        first = next((at for at, start in places if start >= offset), len(lexemes.starts))
    inner, blocks, outer = _ends(lexemes.texts[:first])
    if inner > outer:
        yield _beginning(lexemes, inner, blocks), inner
    yield _beginning(lexemes, outer, 0), outer


def _ends(texts: list[str]) -> tuple[int, int, int]:
    """Where a statement or block ends last, how many blocks are open there, and the same for
    declarations outside of all brackets."""
    inner = blocks = outer = 0
    opened: list[str] = []
    for behind, text in enumerate(texts, 1):
        if text in ("(", "[", "{"):
            opened.append(text)
        # Behind a bracket that fits no other nobody knows which are open.
        elif text in _PAIRS and (not opened or opened.pop() != _PAIRS[text]):
            break
        # The ';' in the head of a `for` stands in parentheses and ends nothing.
        if text in (";", "{", "}") and (not opened or opened[-1] == "{"):
            inner, blocks = behind, len(opened)
            if not opened:
                outer = behind
    return inner, blocks, outer


def _beginning(lexemes: Lexemes, end: int, blocks: int) -> Lexemes:
    begun = Lexemes()
    begun.add(lexemes, 0, end)
    if blocks:
        begun.repeat(["}"] * blocks, begun.ends[-1], begun.ends[-1])
    return begun

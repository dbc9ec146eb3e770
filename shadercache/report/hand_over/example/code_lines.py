"""Lines of Python that are not too long."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

WIDEST = 100
INNER = 4
"""What a block within a function is indented by."""


def spread(head: str, parts: Iterable[str], tail: str, indent: int = 0) -> list[str]:
    """``head``, parts and ``tail`` on one line, or with parts on lines of their own, as many on
    each as fit."""
    parts, margin = list(parts), " " * indent
    whole = f"{margin}{head}{', '.join(parts)}{tail}"
    if len(whole) <= WIDEST - INNER:
        return [whole]
    return [margin + head, *_packed(parts, margin + "    "), margin + tail]


def call(head: str, parts: Iterable[str], indent: int = 0) -> list[str]:
    """The same of a call; its further lines begin below its first part."""
    margin = " " * indent
    lines = _packed(list(parts), margin + " " * len(head))
    lines[0] = margin + head + lines[0].lstrip()
    lines[-1] = lines[-1].removesuffix(",") + ")"
    return lines


def _packed(parts: Sequence[str], margin: str) -> list[str]:
    """Parts with commas, as many on each line as fit."""
    lines = [margin]
    for part in parts:
        if lines[-1] != margin and len(lines[-1]) + len(part) + 2 > WIDEST - INNER:
            lines.append(margin)
        lines[-1] += f"{' ' * (lines[-1] != margin)}{part},"
    return lines

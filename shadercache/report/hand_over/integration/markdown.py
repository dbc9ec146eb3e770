"""Pieces of Markdown."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import TypeVar

T = TypeVar("T")

_NUMBER = re.compile(r" \d+$")


def code(names: Iterable[str]) -> str:
    """Names as code, with commas."""
    return ", ".join(f"`{name}`" for name in names)


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """A table, without a head where that is empty."""
    cells = [head, ["---"] * len(head), *rows]
    return ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in cells]


def alike(told: Iterable[tuple[T, str]]) -> Iterator[tuple[T, str]]:
    """What is told of each, once: with the names of those, `` (a, b)``, unless it is all."""
    names: dict[T, list[str]] = {}
    for what, name in told:
        names.setdefault(what, []).append(name)
    every = {name for some in names.values() for name in some}
    for what, some in names.items():
        yield what, "" if every == set(some) else f" ({', '.join(some)})"


def listed(names: Iterable[str]) -> str:
    """Names with commas; those that differ in a number behind them are counted."""
    counts = Counter(_NUMBER.sub("", name) for name in names)
    return ", ".join(name if count == 1 else f"{count} × {name}" for name, count in counts.items())

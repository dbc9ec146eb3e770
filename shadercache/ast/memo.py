"""What is found out about pieces of a program, kept for the next program that shares them.

The passes of a variant, and the variants of a shader, have most of their functions in common: the
very same nodes. A table maps such nodes, with whatever else an answer depends on, to the answer.
Nodes never change, so an entry is never out of date.
"""

from __future__ import annotations

from typing import Any

MOST_ENTRIES = 30_000
"""Entries that are kept over from one variant to the next: a few hundred kilobytes of keys, and
the functions of some fifty variants."""


class Memo:
    """Tables by name. It lives with the analysis of one shader, and with nothing else."""

    def __init__(self) -> None:
        self._tables: dict[str, dict[Any, Any]] = {}

    def table(self, name: str) -> dict[Any, Any]:
        """The table of this name, empty at first."""
        return self._tables.setdefault(name, {})

    def trim(self) -> None:
        """Forget everything if there is too much; to be called between variants."""
        # What only one variant had is never asked for again. To tell it from the rest would cost
        # more than to begin anew from time to time.
        if sum(map(len, self._tables.values())) > MOST_ENTRIES:
            self._tables = {}

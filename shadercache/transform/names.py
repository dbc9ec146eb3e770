"""Fresh names: the one place that makes them.

Every name this compiler adds begins with ``sc_``. Where the user's text already has such a name
(as an identifier or inside a macro), another prefix is taken, so that nothing can collide.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk

PREFIX = "sc_"


def fresh_prefix(*texts: str, stem: str = "sc") -> str:
    """A prefix that no identifier in the given source texts begins with, in capitals or not.

    ``sc_``, else ``sc1_``, ``sc2_`` ... GLSL reserves names that begin with ``gl_`` or hold two
    underscores (GLSL 3.30 section 3.6); neither can come out.
    """
    taken = {word.lower() for text in texts for word in re.findall(rf"(?i){stem}\d*_", text)}
    number = 0
    prefix = f"{stem}_"
    while prefix in taken:
        number += 1
        prefix = f"{stem}{number}_"
    return prefix


def all_names(module: n.Module) -> set[str]:
    """Every name that anything in a module has."""
    return {name for node in walk(module) if (name := getattr(node, "name", None))}


class FreshNames:
    """Makes names that are not in use; remembers what it made."""

    def __init__(self, taken: Iterable[str]) -> None:
        self._taken = set(taken)
        self._numbers: dict[str, int] = {}

    def make(self, wanted: str) -> str:
        """``wanted`` if it is free, else ``wanted_1``, ``wanted_2`` ..."""
        # Two underscores in a row are reserved (GLSL 3.30 section 3.6).
        wanted = re.sub(r"__+", "_", wanted)
        name = wanted
        stem = wanted.rstrip("_")
        while name in self._taken:
            # Counted on from the last: from 1 again, many names of one stem take quadratic time.
            number = self._numbers[stem] = self._numbers.get(stem, 0) + 1
            name = f"{stem}_{number}"
        self._taken.add(name)
        return name

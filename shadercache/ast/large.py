"""Trees are deep and large: two of Python's defaults that do not suit them."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager

RECURSION_LIMIT = 20_000
"""Statements are walked recursively; Python's own limit is meant for C stacks of old."""


def allow_deep_trees() -> None:
    """Let passes recurse as deep as the parser lets a shader nest."""
    sys.setrecursionlimit(max(sys.getrecursionlimit(), RECURSION_LIMIT))


@contextmanager
def without_collector() -> Iterator[None]:
    """Make a tree or its tables without the garbage collector."""
    # It looks for cycles, which trees do not have, again and again as a tree grows: at 1 MB of
    # source that takes as long as the work itself.
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            gc.enable()

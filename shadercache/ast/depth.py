"""How deep a tree may be for those passes that recurse."""

from __future__ import annotations

import sys

RECURSION_LIMIT = 20_000
"""Statements are walked recursively; Python's own limit is meant for C stacks of old."""


def allow_deep_trees() -> None:
    """Let passes recurse as deep as the parser lets a shader nest."""
    sys.setrecursionlimit(max(sys.getrecursionlimit(), RECURSION_LIMIT))

"""The comments of a module, handed out to the printer one by one.

Each comes out once, however often its nodes were cloned, and not at all where they are gone.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from copy import copy

from shadercache.ast.nodes import Comment


class Comments:
    """The comments that are still to be printed."""

    def __init__(self, comments: Iterable[Comment] = ()) -> None:
        self._all = sorted(comments, key=lambda comment: comment.span)
        self._starts = [comment.span.start for comment in self._all]
        self._anchored: dict[tuple[int, bool], list[Comment]] = {}
        """By what they belong to: where that begins or, for those behind it, ends."""
        for comment in self._all:
            self._anchored.setdefault((comment.anchor, comment.behind), []).append(comment)
        self._taken: set[int] = set()

    def __bool__(self) -> bool:
        """Is any left?"""
        return len(self._taken) < len(self._all)

    def anew(self) -> Comments:
        """All the comments of the module, none of them printed."""
        fresh = copy(self)
        fresh._taken = set()
        return fresh

    @property
    def taken(self) -> frozenset[int]:
        """Where those begin that are printed."""
        return frozenset(self._taken)

    def take_all(self, starts: frozenset[int]) -> bool:
        """Count these as printed, if all of them are left; else say no."""
        if not starts.isdisjoint(self._taken):
            return False
        self._taken |= starts
        return True

    def before(self, offset: int) -> list[str]:
        """Those that belong to what begins at an offset."""
        return self._take(self._anchored.get((offset, False), ()))

    def behind(self, offset: int) -> list[str]:
        """Those that stand behind what ends at an offset."""
        return self._take(self._anchored.get((offset, True), ()))

    def within(self, start: int, end: int) -> list[str]:
        """Those that stand in a range of the source."""
        first, last = bisect_left(self._starts, start), bisect_left(self._starts, end)
        return self._take(self._all[first:last])

    def _take(self, comments: Iterable[Comment]) -> list[str]:
        left = [comment for comment in comments if comment.span.start not in self._taken]
        self._taken.update(comment.span.start for comment in left)
        return [comment.text for comment in left]

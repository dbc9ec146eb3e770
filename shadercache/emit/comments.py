"""The comments of a module, handed out to the printer one by one.

Each comes out once, however often the nodes that it is anchored to were cloned, and those that are
anchored to nodes which are gone do not come out at all.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable

from shadercache.ast.nodes import Comment


class Comments:
    """The comments that are still to be printed."""

    def __init__(self, comments: Iterable[Comment] = ()) -> None:
        self._all = sorted(comments, key=lambda comment: comment.span)
        self._starts = [comment.span.start for comment in self._all]
        self._left = {comment.span.start for comment in self._all}
        self._anchored: dict[tuple[int, bool], list[Comment]] = {}
        for comment in self._all:
            self._anchored.setdefault((comment.anchor, comment.behind), []).append(comment)

    def __bool__(self) -> bool:
        """Is any left?"""
        return bool(self._left)

    def anew(self) -> Comments:
        """All the comments of the module, none of them printed."""
        return Comments(self._all)

    @property
    def taken(self) -> frozenset[int]:
        """Where those begin that are printed."""
        return frozenset(self._starts) - self._left

    def take_all(self, starts: frozenset[int]) -> bool:
        """Count these as printed, if all of them are left; else say no."""
        if not starts <= self._left:
            return False
        self._left -= starts
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
        taken = [comment for comment in comments if comment.span.start in self._left]
        self._left.difference_update(comment.span.start for comment in taken)
        return [comment.text for comment in taken]

"""Passes with nothing to do are not drawn, where that is certain beforehand.

While nothing moves and nothing is refreshed on purpose, a pass that drew no fragment in the last
frame draws none in this one: each pixel that hit then has stored what it read, at the depth that
it expects now. So an occlusion query of the last frame tells. As soon as anything moves, all passes
are drawn again.
"""

from __future__ import annotations

from collections.abc import Sequence

import moderngl
import numpy as np

from shadercache.caching.configuration import Refresh
from shadercache.render.bound_pass import BoundPass
from shadercache.render.drawable import Drawable
from shadercache.scene.camera import Values


class EmptyPasses:
    """Remembers what the last frame showed, and which of its passes drew nothing."""

    def __init__(self, refresh: Refresh, query: moderngl.Query) -> None:
        """Args: ``refresh``: what is recomputed on purpose."""
        self.skipped = 0
        self._fits = refresh.schedule == "none" and not refresh.age
        self._query = query
        self._shown: dict[Drawable, Values] = {}
        self._empty: dict[BoundPass, bool] = {}
        self._still = False

    def begin(self, shown: Sequence[tuple[Drawable, Values]], resets: bool) -> None:
        """Begin a frame that shows these objects with these uniforms.

        ``resets``: some of them were not in the last frame, or that is not to be reused.
        """
        if not self._fits:
            return
        now = dict(shown)
        was, self._shown = self._shown, now
        same = was.keys() == now.keys() and all(
            _equal(was[drawable], now[drawable]) for drawable in now
        )
        self._still = same and not resets
        if not self._still:
            self._empty.clear()

    def skips(self, bound: BoundPass) -> bool:
        """Has the pass nothing to do?"""
        found = self._still and self._empty.get(bound, False)
        self.skipped += found
        return found

    def counting(self, bound: BoundPass) -> moderngl.Query | None:
        """What to count the pass's fragments with, if they are to be counted."""
        return self._query if self._still and bound not in self._empty else None

    def counted(self, bound: BoundPass) -> None:
        """The pass was drawn and counted."""
        self._empty[bound] = int(self._query.samples) == 0


def _equal(one: Values, other: Values) -> bool:
    return one is other or (
        one.keys() == other.keys() and all(np.array_equal(one[name], other[name]) for name in one)
    )

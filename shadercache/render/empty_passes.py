"""Passes with nothing to do are not drawn, where that is certain beforehand.

While nothing moves and nothing is refreshed on purpose, a pass that drew no fragment in the last
frame draws none in this one: each pixel that hit then has stored what it read, at the depth that
it expects now. So an occlusion query of the last frame tells. As soon as anything moves, all passes
are drawn again.
"""

from __future__ import annotations

from collections.abc import Mapping

import moderngl
import numpy as np

from shadercache.caching.configuration import Refresh
from shadercache.render.bound_pass import BoundPass
from shadercache.render.draw_items import Turn
from shadercache.render.drawable import Drawable
from shadercache.scene.camera import Values


class EmptyPasses:
    """Remembers what the last frame showed, and which of its passes drew nothing."""

    def __init__(self, refresh: Refresh, query: moderngl.Query) -> None:
        """Args: ``refresh``: what is recomputed on purpose."""
        self.skipped = 0
        # With ages a payload gets too old though nothing moves.
        self._fits = refresh.schedule == "none" and not refresh.age
        self._query = query
        self._shown: Mapping[Drawable, Values] = {}
        self._empty: dict[BoundPass, bool] = {}
        self._still = False

    def begin(self, shown: Mapping[Drawable, Values], resets: bool) -> None:
        """Begin a frame that shows these objects with these uniforms.

        ``resets``: some of them were not in the last frame, or that is not to be reused.
        """
        if not self._fits:
            return
        was, self._shown = self._shown, shown
        same = was.keys() == shown.keys() and all(
            _equal(was[drawable], shown[drawable]) for drawable in shown
        )
        self._still = same and not resets
        if not self._still:
            self._empty.clear()

    def draw(self, turn: Turn) -> bool:
        """Draw a pass, unless it is known to have nothing to do; whether it was drawn."""
        bound = turn.bound
        # The first frame at rest is queried; what it finds holds until something moves.
        if self._still and bound not in self._empty:
            with self._query:
                turn.draw()
            self._empty[bound] = int(self._query.samples) == 0
            return True
        if self._still and self._empty[bound]:
            self.skipped += 1
            return False
        turn.draw()
        return True


def _equal(one: Values, other: Values) -> bool:
    return one is other or (
        one.keys() == other.keys() and all(np.array_equal(one[name], other[name]) for name in one)
    )

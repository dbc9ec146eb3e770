"""A clock for tests: it says what it is told to."""

from __future__ import annotations

from collections.abc import Callable
from itertools import cycle


class ToldClock:
    """A clock that draws, and says these seconds one after another, over and over."""

    name = "told"

    def __init__(self, *seconds: float) -> None:
        self._seconds = cycle(seconds)

    def time(self, draw: Callable[[], None]) -> float:
        """Draw, and what it is told."""
        draw()
        return next(self._seconds)

"""Resets: why a cache is forgotten, and cuts that nobody told and that the run gives away.

Nothing is reset on a suspicion. A cut that was not told is still drawn rightly, for the hit test
turns everything down; but all that the look-ups cost was spent for nothing, and what passes the
test by chance is wrong.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from typing import Literal, TypeAlias, get_args

import numpy as np

from shadercache.render.draw_items import DrawItem
from shadercache.scene.camera import Values
from shadercache.scene.object_inputs import root_of

ResetReason: TypeAlias = Literal[
    "first frame", "cut", "resize", "projection change", "shader reload", "lost context"
]
"""Why the last frame says nothing about the next one."""

REASONS: tuple[ResetReason, ...] = get_args(ResetReason)

# From so many numbers on a uniform is a matrix, which leaps when the camera does. Frame counters
# and clocks leap as well, in an innocent way.
SMALLEST_MATRIX = 9

# Relative to the size of a matrix: a turn by 5 degrees is 0.04, one by 90 degrees 0.7.
LEAP = 0.1
"""A change of a matrix that is a leap if it is also unusual."""

UNUSUAL = 4.0
"""So many times what the frames before changed."""

COLLAPSE = 0.5
"""Hits below this share of what they were in the frames before are a collapse."""


@dataclass(frozen=True, slots=True)
class Suspicion:
    """A frame that looks like a cut, and why."""

    frame: int
    why: str

    def __str__(self) -> str:
        what = "a cut that was not told: call reset() before it"
        return f"frame {self.frame} looks like {what} ({self.why})"


@dataclass(slots=True)
class CutDetector:
    """Looks at each frame of a run, and keeps those that look like cuts."""

    suspicions: list[Suspicion] = field(default_factory=list)
    _changes: deque[float] = field(default_factory=lambda: deque(maxlen=8))
    _rates: deque[float] = field(default_factory=lambda: deque(maxlen=8))

    def reset(self) -> None:
        """A reset was told: what came before is no measure for what comes."""
        self._changes.clear()
        self._rates.clear()

    def watch(self, frame: int, items: Iterable[DrawItem], shown: int) -> None:
        """Does what a cached object is seen from leap, though no reset was told?

        ``shown`` is the frame of the scene that this one shows.
        """
        for role in items:
            if role.caches is not None and role.before is not None:
                before, now = role.drawable.values(role.before), role.drawable.values(shown)
                self.moved(frame, before, now, set(role.naming.twins.values()))

    def moved(self, frame: int, before: Values, now: Values, names: Collection[str]) -> None:
        """Compare the uniforms that decide where things are with those of the last frame.

        ``names`` may be of structs and instances of blocks, whose parts have the values.
        """
        changes = (_change(before[name], now[name]) for name in now if root_of(name) in names)
        change = max(changes, default=0.0)
        # The median, so that one leap does not excuse the next. A frame with none before it is its
        # own measure, and never suspected.
        usual = float(np.median(self._changes)) if self._changes else change
        if change > max(LEAP, UNUSUAL * usual):
            self._suspect(frame, f"what it is seen from changed by {change:.0%} at once")
        self._changes.append(change)

    def hit(self, frame: int, rate: float) -> None:
        """Compare the share of hits with those of the last frames that were looked at."""
        usual = float(np.median(self._rates)) if self._rates else rate
        if rate < COLLAPSE * usual:
            self._suspect(frame, f"hits fell from {usual:.0%} to {rate:.0%}")
        self._rates.append(rate)

    def _suspect(self, frame: int, why: str) -> None:
        for place, known in enumerate(self.suspicions):
            if known.frame == frame:
                if why not in known.why:
                    self.suspicions[place] = Suspicion(frame, f"{known.why}; {why}")
                return
        self.suspicions.append(Suspicion(frame, why))


def _change(before: np.ndarray, now: np.ndarray) -> float:
    """How far a matrix is from what it was, relative to both; 0 for anything smaller."""
    if now.size < SMALLEST_MATRIX or before is now:
        return 0.0
    size = float(np.linalg.norm(before) + np.linalg.norm(now))
    return 2.0 * float(np.linalg.norm(now - before)) / size if size > 0.0 else 0.0

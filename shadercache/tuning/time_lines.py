"""Times that follow from the time of hits by a line: of misses, and of hits by other choices.

Where the pass that looks up discards a miss at once, a miss takes the look-up and the whole shader,
whatever is cached. Where it goes through the shading first (its derivatives forbid an early
discard), a miss takes what a hit does and the whole shader on top of that.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

ENOUGH = 2
"""Values that a line is drawn through."""

APART = 0.05
"""Times that are nearer to each other, as shares of the original's, tell no slope."""


@dataclass
class TimeLine:
    """A line through what was found of some values, as shares of the original's time.

    ``slope``: what is taken where that does not tell it.
    """

    slope: float
    points: dict[object, tuple[float, float]] = field(default_factory=dict)

    def learn(self, value: object, x: float, y: float) -> None:
        """What was found of a value."""
        self.points[value] = (x, y)

    def wants(self, value: object) -> bool:
        """Is it worth measuring a value?"""
        return len(self.points) < ENOUGH and value not in self.points

    def at(self, x: float) -> float:
        """The time of a value whose other time is ``x``."""
        xs, ys = (np.array(column) for column in zip(*self.points.values(), strict=True))
        slope = self.slope
        if np.ptp(xs) >= APART:
            fitted = np.mean((xs - xs.mean()) * (ys - ys.mean())) / np.var(xs)
            # What is left of the shader is in both times, at most once in each.
            slope = float(np.clip(fitted, 0.0, 1.0))
        return max(0.0, float(np.mean(ys) + slope * (x - np.mean(xs))))

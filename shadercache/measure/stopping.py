"""When a measurement ends before its last frame: as soon as its ratios are known well enough.

Whoever stops when the intervals are narrow does so more often when chance has made them so: a
95 % interval then holds slightly less than 95 %. That is right for a demonstration; a benchmark
draws a fixed number of frames.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from shadercache.measure.statistics import Ratio

COMPARED = 8
"""A run ends no sooner than so many images have been compared."""


@dataclass(frozen=True, slots=True)
class StopRule:
    """Stop when every ratio is known to within ``half_width`` of itself, or after ``seconds``."""

    half_width: float
    seconds: float

    def is_met(self, elapsed: float, ratios: Iterable[Ratio]) -> bool:
        """Whether a run that has taken ``elapsed`` seconds and found ``ratios`` may end."""
        return elapsed >= self.seconds or widest(ratios) <= self.half_width


def widest(ratios: Iterable[Ratio]) -> float:
    """Half of the widest interval, as a share of its ratio."""
    return max((ratio.high - ratio.low) / (2.0 * ratio.median) for ratio in ratios)

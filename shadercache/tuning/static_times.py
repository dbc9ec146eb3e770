"""Times of values that nobody drew, from static costs and the times of a few that were drawn.

Where all is found a frame takes what is left of the shader and what a look-up takes; where nothing
is, the whole shader and the same again. So the first follows a line over the share of the shader
that is left, and the second is much the same for all values.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import optimize

from shadercache.tuning.models import TimeModel

FEWEST = 3
"""Values that a line is fitted to."""


@dataclass(frozen=True, slots=True)
class StaticTimes:
    """``offset`` and ``slope`` of the time of hits over the share of the shader that is left, and
    the time of misses, all as shares of the original's; ``residual``: the root mean square of what
    the line is off."""

    offset: float
    slope: float
    miss: float
    mu: float
    residual: float

    def at(self, saved: float, period: float) -> float:
        """The time of a value that saves a share of the shader by static costs."""
        rate = self.mu * (1.0 - 1.0 / period)
        hit = self.offset + self.slope * (1.0 - saved)
        return rate * hit + (1.0 - rate) * self.miss


def fit_static(saved: Sequence[float], times: Sequence[TimeModel]) -> StaticTimes | None:
    """Fit to values that were drawn by one algorithm; None for fewer than three of them."""
    if len(times) < FEWEST:
        return None
    left = 1.0 - np.asarray(saved, np.float64)
    hits = np.array([time.hit.value for time in times])
    matrix = np.stack([np.ones_like(left), left], axis=1)
    offset, slope = optimize.lsq_linear(matrix, hits, bounds=(0.0, np.inf)).x
    off = hits - offset - slope * left
    return StaticTimes(
        float(offset),
        float(slope),
        float(np.median([time.miss.value for time in times])),
        float(np.median([time.mu for time in times])),
        float(np.sqrt(np.mean(off**2))),
    )

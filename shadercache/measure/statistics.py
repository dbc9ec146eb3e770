"""Numbers about samples of time: median, tail, the ratio of two series, and when it is known."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

RESAMPLES = 2000

COMPARED = 8
"""A run ends no sooner than so many images have been compared."""


@dataclass(frozen=True, slots=True)
class Timing:
    """Seconds per frame, in the order they were taken, and what is said about them.

    ``p95`` and ``p99``: what 95 and 99 of 100 frames do not exceed; of fewer than 20 or 100 samples
    these are nearly the largest.
    """

    samples: tuple[float, ...]
    median: float
    minimum: float
    p95: float
    p99: float


@dataclass(frozen=True, slots=True)
class Ratio:
    """How many times longer the first of two paired series takes.

    ``median`` of the ratios of the pairs with its 95 % interval, and the ratio of the ``total``
    times, which the frames that refresh much weigh on in full.
    """

    median: float
    low: float
    high: float
    total: float


@dataclass(frozen=True, slots=True)
class StopRule:
    """Stop when every ratio is known to within ``half_width`` of itself, or after ``seconds``."""

    # Whoever stops when the intervals are narrow does so more often when chance has made them so: a
    # 95 % interval then holds slightly less than 95 %. That is right for a demonstration; a
    # benchmark draws a fixed number of frames.

    half_width: float
    seconds: float

    def is_met(self, elapsed: float, ratios: Iterable[Ratio]) -> bool:
        """Whether a run that has taken ``elapsed`` seconds and found ``ratios`` may end."""
        return elapsed >= self.seconds or widest(ratios) <= self.half_width


def widest(ratios: Iterable[Ratio]) -> float:
    """Half of the widest interval, as a share of its ratio."""
    return max((ratio.high - ratio.low) / (2.0 * ratio.median) for ratio in ratios)


def timing(samples: Sequence[float]) -> Timing:
    """Median, minimum and tail of at least one sample."""
    least, median, p95, p99 = (float(q) for q in np.quantile(samples, (0.0, 0.5, 0.95, 0.99)))
    return Timing(tuple(samples), median, least, p95, p99)


def paired_ratio(first: Sequence[float], second: Sequence[float]) -> Ratio:
    """The ratio ``first / second`` of samples taken side by side, frame by frame.

    Raises :class:`ValueError` where the series differ in length or are empty.
    """
    a, b = np.asarray(first, np.float64), np.asarray(second, np.float64)
    if a.shape != b.shape or a.size == 0:
        raise ValueError(f"not paired: {a.size} and {b.size} samples")
    # Machines drift by a factor of two within minutes; pairs drift together.
    ratios = a / b
    # The percentile bootstrap over the pairs (Efron), with a fixed seed: equal samples, equal
    # interval.
    picks = np.random.default_rng(1).integers(0, a.size, (RESAMPLES, a.size))
    medians = np.median(ratios[picks], axis=1)
    low, high = np.quantile(medians, (0.025, 0.975))
    return Ratio(float(np.median(ratios)), float(low), float(high), float(a.sum() / b.sum()))

"""Numbers about samples of time: median, minimum, and the ratio of two series with its interval."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

RESAMPLES = 2000


@dataclass(frozen=True, slots=True)
class Timing:
    """Seconds per frame, in the order they were taken, and what is said about them.

    ``p95`` and ``p99`` are percentiles, interpolated: of few samples they come near the slowest.
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


def timing(samples: Sequence[float]) -> Timing:
    """Median, minimum and the slow end of at least one sample."""
    slow = np.percentile(samples, (95.0, 99.0))
    return Timing(
        tuple(samples),
        float(np.median(samples)),
        float(np.min(samples)),
        float(slow[0]),
        float(slow[1]),
    )


def paired_ratio(first: Sequence[float], second: Sequence[float], seed: int = 1) -> Ratio:
    """The ratio ``first / second`` of samples taken side by side, frame by frame.

    Machines drift by a factor of two within minutes; pairs drift together. The interval is the
    percentile bootstrap over the pairs (Efron), with a fixed seed: equal samples, equal interval.

    Raises:
        ValueError: the series differ in length or are empty.
    """
    a, b = np.asarray(first, np.float64), np.asarray(second, np.float64)
    if a.shape != b.shape or a.size == 0:
        raise ValueError(f"not paired: {a.size} and {b.size} samples")
    ratios = a / b
    picks = np.random.default_rng(seed).integers(0, a.size, (RESAMPLES, a.size))
    medians = np.median(ratios[picks], axis=1)
    low, high = np.quantile(medians, (0.025, 0.975))
    return Ratio(float(np.median(ratios)), float(low), float(high), float(a.sum() / b.sum()))

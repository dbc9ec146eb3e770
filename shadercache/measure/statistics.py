"""Numbers about samples of time: median, tail, the ratio of two series, and when it is known.

Also how well two orders of the same things agree.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

RESAMPLES = 2000

LOOK_EVERY = 8
"""A stopping rule looks at the intervals once in so many frames."""

FEWEST = 8
"""Of fewer pairs no interval is believed: the bootstrap of a median never reaches beyond them."""


@dataclass(frozen=True, slots=True)
class Timing:
    """Seconds per frame, in the order they were taken, and what is said about them.

    ``p95`` and ``p99``: what 95 and 99 of 100 frames do not exceed; of fewer than 20 or 100 samples
    these are nearly the largest. ``tail`` is ``p99`` over ``median``: 1 where all frames take as
    long.
    """

    samples: tuple[float, ...]
    median: float
    minimum: float
    p95: float
    p99: float
    tail: float


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
    """Time on until every ratio is known to within ``half_width`` of itself, or for ``seconds``.

    ``half_width`` is half of the 95 % interval over the ratio; ``seconds`` are those of all the
    timing of a batch, its fixed frames included.
    """

    # Whoever stops when the intervals are narrow does so more often when chance has made them so: a
    # 95 % interval then holds slightly less than 95 %. Each look is one more chance, so there are
    # few (``LOOK_EVERY``). What decides nothing else, such as the error, is of the fixed frames.

    half_width: float = 0.03
    seconds: float = 30.0

    def is_over(self, elapsed: float) -> bool:
        """Is the time up after so many seconds?"""
        return elapsed >= self.seconds

    def is_met(self, reached: float) -> bool:
        """Is a half width (:func:`widest`) narrow enough?"""
        return reached <= self.half_width


@dataclass(frozen=True, slots=True)
class Reached:
    """What the timing of a batch came to.

    ``half_width``: half of the widest 95 % interval of its ratios, over the ratio. ``frames`` were
    timed, the reset frames not counted, in ``seconds`` of the wall clock, all that is drawn and
    computed between them included. ``capped``: a stopping rule ran out of time first.
    """

    half_width: float
    frames: int
    seconds: float
    capped: bool


def widest(ratios: Iterable[Ratio]) -> float:
    """Half of the widest interval, as a share of its ratio."""
    return max((ratio.high - ratio.low) / (2.0 * ratio.median) for ratio in ratios)


def timing(samples: Sequence[float]) -> Timing:
    """Median, minimum and tail of at least one sample."""
    least, median, p95, p99 = (float(q) for q in np.quantile(samples, (0.0, 0.5, 0.95, 0.99)))
    return Timing(tuple(samples), median, least, p95, p99, p99 / median if median else 1.0)


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


def rank_correlation(first: Sequence[float], second: Sequence[float]) -> float | None:
    """Spearman's rank correlation, from -1 to 1; what ties shares the mean of its ranks.

    None where it says nothing: of fewer than three pairs, and where one side is all the same.
    Raises :class:`ValueError` where the sequences differ in length.
    """
    if len(first) != len(second):
        raise ValueError(f"not paired: {len(first)} and {len(second)} values")
    if min(len(first), len(set(first)), len(set(second))) < 2 or len(first) < 3:
        return None
    return float(np.corrcoef(_ranks(first), _ranks(second))[0, 1])


def _ranks(values: Sequence[float]) -> NDArray[np.float64]:
    _, places, counts = np.unique(values, return_inverse=True, return_counts=True)
    last = np.cumsum(counts)
    return (last - (counts - 1) / 2.0)[places]

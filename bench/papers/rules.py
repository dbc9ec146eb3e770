"""The rules that turn numbers into verdicts. They were written before anything was measured.

A difference that lies inside its 95 % interval is none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from shadercache.measure import statistics
from shadercache.measure.statistics import Ratio

ALMOST_EVERY = 0.90
"""The share of nodes that "almost every" asks for."""

GENERALLY = 0.75
"""The share that "generally" asks for."""

HIGH = 0.5
"""P/T from here on is high."""

MARGIN = 0.02
"""A change of less than this is "no significant change", however well it is known."""

KNOWN = 0.05
"""Half of the width, as a share of its ratio, up to which an interval can show that two times are
equal."""

FEWEST_NODES = 12
"""Of fewer nodes no trend is told."""

LITTLE = 0.10
"""A gain of less than this is little."""

OVERLAP = 0.10
"""Share of the shader that both passes compute, from which on a node suffers from overlap (the
compiler's own notes begin there as well)."""

RESAMPLES = 2000

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Interval:
    """A number with its 95 % interval."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{self.value:.2f} [{self.low:.2f} to {self.high:.2f}]"


def median_interval(values: Floats) -> Interval:
    """The median of values that were taken frame by frame."""
    picks = np.random.default_rng(1).integers(0, values.size, (RESAMPLES, values.size))
    low, high = np.quantile(np.median(values[picks], axis=1), (0.025, 0.975))
    return Interval(float(np.median(values)), float(low), float(high))


def is_positive(interval: Interval) -> bool | None:
    """None where 0 lies inside."""
    return True if interval.low > 0.0 else (False if interval.high < 0.0 else None)


def is_above(ratio: Ratio, than: float = 1.0) -> bool:
    """Is it surely more?"""
    return ratio.low > than


def is_below(ratio: Ratio, than: float = 1.0) -> bool:
    """Is it surely less?"""
    return ratio.high < than


def is_more(ratio: Ratio, known: float = KNOWN) -> bool | None:
    """Is it surely more than 1? None where the interval holds 1 and is wider than ``known``."""
    if is_above(ratio) or is_below(ratio):
        return is_above(ratio)
    return False if statistics.widest([ratio]) <= known else None


def is_unchanged(ratio: Ratio) -> bool | None:
    """Is it 1, but for the margin? None where the interval is too wide to say."""
    if is_above(ratio, 1.0 + MARGIN) or is_below(ratio, 1.0 - MARGIN):
        return False
    return True if statistics.widest([ratio]) <= KNOWN else None


def reaches(ratio: Ratio, wanted: float) -> bool | None:
    """Is it as much? None where the interval holds what is wanted, but for a narrow one whose
    median reaches it."""
    if ratio.high < wanted or ratio.low >= wanted:
        return ratio.low >= wanted
    return True if statistics.widest([ratio]) <= KNOWN and ratio.median >= wanted else None


def is_at_most(ratio: Ratio, limit: float) -> bool | None:
    """None where the limit lies inside the interval."""
    return False if is_above(ratio, limit) else (True if ratio.high <= limit else None)


def all_of(found: Iterable[bool | None]) -> bool | None:
    """False where one fails, None where one cannot be told, else True."""
    each = list(found)
    return False if False in each else (None if None in each else True)


def written(ratio: Ratio) -> str:
    """A ratio with its interval."""
    return f"{ratio.median:.3f} [{ratio.low:.3f} to {ratio.high:.3f}]"


def rank_correlation(x: Sequence[float], y: Sequence[float]) -> Interval:
    """Spearman's, with a bootstrap interval over the pairs."""
    # A resample may be the same pair throughout: nothing rises or falls with it.
    return _over_pairs(
        x, y, lambda a, b: statistics.rank_correlation(a.tolist(), b.tolist()) or 0.0
    )


def slope(x: Sequence[float], y: Sequence[float]) -> Interval:
    """Of the least-squares line, with a bootstrap interval over the pairs."""
    # The same resample has no slope, and must not divide by zero.
    return _over_pairs(x, y, lambda a, b: _covariance(a, b) / max(_covariance(a, a), 1e-30))


def _over_pairs(
    x: Sequence[float], y: Sequence[float], of: Callable[[Floats, Floats], float]
) -> Interval:
    a, b = np.asarray(x, np.float64), np.asarray(y, np.float64)
    picks = np.random.default_rng(1).integers(0, a.size, (RESAMPLES, a.size))
    low, high = np.quantile([of(a[pick], b[pick]) for pick in picks], (0.025, 0.975))
    return Interval(of(a, b), float(low), float(high))


def _covariance(a: Floats, b: Floats) -> float:
    return float(np.mean((a - a.mean()) * (b - b.mean())))

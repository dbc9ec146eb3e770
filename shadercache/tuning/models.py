"""Models of hit rate, time and error over the refresh period, fitted to few measurements.

The hit rate of a period of n frames is mu (1 - 1/n), a frame takes gamma T_h + (1 - gamma) T_m, and
the error is alpha (1 - exp(-lambda (n - 1))): equations 1, 2 and 5 of Scherzer et al. 2010, after
Sitthi-amorn et al. 2008. Everything is computed in double precision.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, special

Floats = NDArray[np.float64]
AnyFloats = NDArray[np.floating[Any]]

CLOSE = 0.05
"""A model that is off by more than this share, by root mean square over the points, is not
followed."""

LEAST = 0.01
"""Errors below this share of the largest count as if they were as large."""

_FASTEST, _SLOWEST = 10.0, 1e-4
"""Rates of decay, a frame: the error is all there in the second frame, or grows to the last."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """A fitted number with its 95 % interval; infinite where so few points cannot tell."""

    value: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Goodness:
    """How well a model fits: ``r_squared``, the share of the variance that it explains, and the
    root mean square of what is left, in the unit of the values. ``points`` it was fitted to."""

    r_squared: float
    residual: float
    points: int


@dataclass(frozen=True, slots=True)
class HitModel:
    """``mu``: the share of what is seen that was seen in the frame before."""

    mu: Estimate
    goodness: Goodness

    def at(self, period: float) -> float:
        """The hit rate of a period in frames, from 0 to 1."""
        return self.mu.value * (1.0 - 1.0 / period)


@dataclass(frozen=True, slots=True)
class TimeModel:
    """What a frame takes where all is found (``hit``) and where nothing is (``miss``), as shares of
    the original's."""

    hit: Estimate
    miss: Estimate
    mu: float
    goodness: Goodness

    def at(self, period: float) -> float:
        """The time of a period in frames, as a share of the original's."""
        rate = self.mu * (1.0 - 1.0 / period)
        return rate * self.hit.value + (1.0 - rate) * self.miss.value


@dataclass(frozen=True, slots=True)
class ErrorModel:
    """``alpha``: what the error grows to; ``rate``: how fast, a frame.

    Where the points do not ``follow`` the model, they are interpolated instead: so are those of
    payloads at a fraction of the rate, whose error is above 0 even where all is recomputed.
    """

    alpha: Estimate
    rate: Estimate
    goodness: Goodness
    points: tuple[tuple[float, float], ...]
    follows: bool

    def at(self, period: float) -> float:
        """The error of a period in frames."""
        if self.follows:
            return self.alpha.value * float(-np.expm1(-self.rate.value * (period - 1.0)))
        # In the logarithm of the period, whose octaves matter alike; 0 where all is recomputed.
        fresh = () if self.points[0][0] == 1.0 else ((1.0, 0.0),)
        places, errors = (np.array(one) for one in zip(*fresh, *self.points, strict=True))
        places, place = np.log(places), float(np.log(period))
        if place > places[-1] and len(places) > 1:  # on along the last piece, but never down
            slope = (errors[-1] - errors[-2]) / (places[-1] - places[-2])
            return float(errors[-1] + max(0.0, slope) * (place - places[-1]))
        return float(np.interp(place, places, errors))


def fit_hits(periods: Sequence[float], rates: Sequence[float]) -> HitModel:
    """Fit mu to hit rates at periods above 1.

    Raises:
        ValueError: no points, or not as many rates as periods.
    """
    x, y = _points(periods, rates)
    [mu], goodness = _linear((1.0 - 1.0 / x)[:, None], y)
    return HitModel(mu, goodness)


def fit_time(periods: Sequence[float], shares: Sequence[float], mu: float) -> TimeModel:
    """Fit the times of hits and misses to shares of the original's time at two periods or more.

    Raises:
        ValueError: fewer than two different periods, or not as many shares.
    """
    x, y = _points(periods, shares)
    if len(set(periods)) < 2:
        raise ValueError("one period cannot tell hits from misses")
    rate = mu * (1.0 - 1.0 / x)
    [hit, miss], goodness = _linear(np.stack([rate, 1.0 - rate], axis=1), y)
    return TimeModel(hit, miss, mu, goodness)


def time_of_hits(share: float, period: float, mu: float, miss: float) -> TimeModel:
    """The model through one point, where the time of misses is known from elsewhere."""
    rate = mu * (1.0 - 1.0 / period)
    # Where nothing is ever found, nobody knows what a hit would take.
    hit = max(0.0, (share - (1.0 - rate) * miss) / rate) if rate > 0.0 else share
    return time_of_parts(hit, miss, mu)


def time_of_parts(hit: float, miss: float, mu: float) -> TimeModel:
    """The model of times that are known from elsewhere."""
    unknown = (-np.inf, np.inf)
    return TimeModel(Estimate(hit, *unknown), Estimate(miss, *unknown), mu, Goodness(1.0, 0.0, 0))


def constant_time(share: float) -> TimeModel:
    """The model of what takes that share whatever the period is."""
    return time_of_hits(share, np.inf, 1.0, share)


def fit_error(periods: Sequence[float], errors: Sequence[float]) -> ErrorModel:
    """Fit the error's growth to errors at some periods.

    Raises:
        ValueError: no points, or not as many errors as periods.
    """
    x, y = _points(periods, errors)
    points = tuple(sorted(zip(x.tolist(), y.tolist(), strict=True)))
    largest = float(y.max())
    if largest == 0.0:
        nothing = Estimate(0.0, 0.0, 0.0)
        exact = Goodness(1.0, 0.0, len(y))
        return ErrorModel(nothing, Estimate(0.0, 0.0, np.inf), exact, points, True)
    if np.all(x == 1.0):
        unknown = Estimate(largest, -np.inf, np.inf)
        return ErrorModel(unknown, unknown, Goodness(0.0, largest, len(y)), points, False)
    best = _decay(x - 1.0, y / largest)
    fitted = largest * best[0] * -np.expm1(-best[1] * (x - 1.0))
    goodness = _goodness(y, fitted, len(y))
    off = float(np.sqrt(np.mean((_weights(y / largest) * (fitted - y) / largest) ** 2)))
    alpha, rate = _intervals(x - 1.0, y / largest, best)
    alpha = Estimate(*(largest * one for one in (alpha.value, alpha.low, alpha.high)))
    return ErrorModel(alpha, rate, goodness, points, off <= CLOSE)


def _points(periods: Sequence[float], values: Sequence[float]) -> tuple[Floats, Floats]:
    x, y = np.asarray(periods, np.float64), np.asarray(values, np.float64)
    if x.shape != y.shape or x.size == 0:
        raise ValueError(f"not paired: {x.size} periods and {y.size} values")
    return x, y


def _linear(matrix: Floats, y: Floats) -> tuple[list[Estimate], Goodness]:
    """Least squares with parameters of at least 0."""
    values = optimize.lsq_linear(matrix, y, bounds=(0.0, np.inf)).x
    free = len(y) - matrix.shape[1]
    left = y - matrix @ values
    inverse = np.linalg.pinv(matrix.T @ matrix)
    return _parameters(values, inverse, left, free), _goodness(y, matrix @ values, len(y))


def _decay(x: Floats, y: Floats) -> tuple[float, float]:
    """Alpha and rate of least squares, for values of at most 1."""
    weights = _weights(y)

    # With the rate given, alpha is linear, so one number is searched for: from both ends, since a
    # straight line and a step are limits of the same curve.
    def alpha_of(rate: float) -> float:
        shape = -np.expm1(-rate * x)
        squares = float(np.sum((weights * shape) ** 2))
        return float(np.sum(weights**2 * shape * y)) / squares if squares > 0.0 else 0.0

    def left(log_rate: float) -> float:
        rate = float(np.exp(log_rate))
        return float(np.sum((weights * (y - alpha_of(rate) * -np.expm1(-rate * x))) ** 2))

    low, high = np.log(_SLOWEST), np.log(_FASTEST)
    starts = np.linspace(low, high, 25)
    best = starts[int(np.argmin([left(start) for start in starts]))]
    step = starts[1] - starts[0]
    around = (max(low, best - step), min(high, best + step))
    found = optimize.minimize_scalar(left, bounds=around, method="bounded")
    rate = float(np.exp(found.x))
    return alpha_of(rate), rate


def _weights(y: Floats) -> Floats:
    """Each value, of at most 1, counts by its share: small errors at short periods matter as much
    as large ones, since tight bounds are kept there."""
    weights: Floats = 1.0 / np.maximum(y, LEAST)
    return weights


def _intervals(x: Floats, y: Floats, best: tuple[float, float]) -> tuple[Estimate, Estimate]:
    """What the curvature at the best fit says of alpha and rate."""
    alpha, rate = best
    weights = _weights(y)
    left = weights * (y - alpha * -np.expm1(-rate * x))
    gradient = np.stack([-np.expm1(-rate * x), alpha * x * np.exp(-rate * x)], axis=1)
    gradient *= weights[:, None]
    inverse = np.linalg.pinv(gradient.T @ gradient)
    one, other = _parameters(np.array(best), inverse, left, len(y) - 2)
    return one, other


def _parameters(values: Floats, inverse: AnyFloats, left: Floats, free: int) -> list[Estimate]:
    if free <= 0:
        return [Estimate(float(value), -np.inf, np.inf) for value in values]
    deviation = np.sqrt(float(left @ left) / free * np.diag(inverse))
    reach = float(special.stdtrit(free, 0.975)) * deviation
    return [
        Estimate(float(value), float(value - half), float(value + half))
        for value, half in zip(values, reach, strict=True)
    ]


def _goodness(y: Floats, fitted: Floats, count: int) -> Goodness:
    left = y - fitted
    spread = float(np.sum((y - y.mean()) ** 2))
    squares = float(left @ left)
    explained = 1.0 - squares / spread if spread > 0.0 else float(squares == 0.0)
    return Goodness(explained, float(np.sqrt(squares / count)), count)

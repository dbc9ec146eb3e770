"""The models of the papers, fitted by least squares."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

RATES = np.geomspace(1e-3, 10.0, 401)
"""Rates of decay that are tried; the range is wider than what 2 to 64 frames can tell apart."""


@dataclass(frozen=True, slots=True)
class Fit:
    """``offset + scale * shape(n)``: ``residual`` is the root mean square of what is left over, in
    the unit of the values, ``rate`` the decay per frame where there is one."""

    offset: float
    scale: float
    residual: float
    rate: float | None = None

    @property
    def words(self) -> str:
        """The parameters."""
        rate = "" if self.rate is None else f", rate {self.rate:.3g}"
        return f"{self.offset:.4g} + {self.scale:.4g} x{rate}, residual {self.residual:.2g}"


def fit_hyperbola(n: Sequence[float], values: Sequence[float]) -> Fit:
    """``a + b / n``: what equations 2 and 3 of Scherzer et al. 2010 say of the time."""
    return _line(1.0 / np.asarray(n, np.float64), np.asarray(values, np.float64))


def fit_exponential(n: Sequence[float], values: Sequence[float]) -> Fit:
    """``a + b exp(-c (n - 1))``: what Sitthi-amorn et al. 2008, section 4.2, say of it in words."""
    at, y = np.asarray(n, np.float64), np.asarray(values, np.float64)
    return _best(lambda rate: _line(np.exp(-rate * (at - 1.0)), y))


def fit_error(n: Sequence[float], values: Sequence[float]) -> Fit:
    """``alpha (1 - exp(-lambda (n - 1)))``: equation 5 of Scherzer et al. 2010."""
    at, y = np.asarray(n, np.float64), np.asarray(values, np.float64)
    return _best(lambda rate: _through_origin(1.0 - np.exp(-rate * (at - 1.0)), y))


def _best(fit: Callable[[float], Fit]) -> Fit:
    # With the rate given, the rest is linear: trying rates one by one misses no minimum.
    fits = [(fit(float(rate)), float(rate)) for rate in RATES]
    found, rate = min(fits, key=lambda pair: pair[0].residual)
    return Fit(found.offset, found.scale, found.residual, rate)


def _line(x: Floats, y: Floats) -> Fit:
    spread = float(np.sum((x - x.mean()) ** 2))
    scale = float(np.sum((x - x.mean()) * (y - y.mean()))) / spread if spread > 0.0 else 0.0
    offset = float(y.mean() - scale * x.mean())
    return Fit(offset, scale, _rms(y - offset - scale * x))


def _through_origin(x: Floats, y: Floats) -> Fit:
    squares = float(np.sum(x * x))
    scale = float(np.sum(x * y)) / squares if squares > 0.0 else 0.0
    return Fit(0.0, scale, _rms(y - scale * x))


def _rms(left: Floats) -> float:
    return float(np.sqrt(np.mean(left * left)))

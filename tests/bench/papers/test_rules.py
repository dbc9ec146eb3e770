"""What the rules of the verdicts say, and the fits."""

from __future__ import annotations

import numpy as np
import pytest

from bench.papers.models import fit_error, fit_exponential, fit_hyperbola
from bench.papers.rules import (
    all_of,
    is_at_most,
    is_more,
    is_unchanged,
    rank_correlation,
    reaches,
    slope,
)
from shadercache.measure.statistics import Ratio

PERIODS = (2, 4, 8, 16, 32, 64)


def ratio(low: float, high: float) -> Ratio:
    middle = 0.5 * (low + high)
    return Ratio(middle, low, high, middle)


@pytest.mark.parametrize(
    ("low", "high", "more"),
    [(1.01, 1.2, True), (0.7, 0.9, False), (0.98, 1.02, False), (0.8, 1.2, None)],
)
def test_a_difference_inside_the_interval_is_none(low: float, high: float, more: bool) -> None:
    assert is_more(ratio(low, high)) is more


@pytest.mark.parametrize(
    ("low", "high", "same"),
    [(0.99, 1.01, True), (1.001, 1.01, True), (1.03, 1.05, False), (0.9, 1.1, None)],
)
def test_to_be_unchanged_takes_a_narrow_interval(low: float, high: float, same: bool) -> None:
    assert is_unchanged(ratio(low, high)) is same


def test_limits_and_sums() -> None:
    assert is_at_most(ratio(1.0, 1.05), 1.1) is True
    assert is_at_most(ratio(1.2, 1.3), 1.1) is False
    assert is_at_most(ratio(1.0, 1.3), 1.1) is None
    assert reaches(ratio(2.2, 2.4), 2.1) is True
    assert reaches(ratio(2.06, 2.16), 2.1) is True
    assert reaches(ratio(2.04, 2.14), 2.1) is None
    assert reaches(ratio(1.5, 2.6), 2.1) is None
    assert reaches(ratio(1.5, 2.0), 2.1) is False
    assert all_of([True, True]) is True
    assert all_of([True, None]) is None
    assert all_of([None, False]) is False


def test_trends_have_intervals() -> None:
    x = np.linspace(0.0, 1.0, 20)
    noise = np.random.default_rng(3).normal(0.0, 0.05, 20)
    up = rank_correlation(x.tolist(), (x + noise).tolist())
    assert up.low > 0.5 and up.high <= 1.0
    none = rank_correlation(x.tolist(), np.random.default_rng(4).normal(size=20).tolist())
    assert none.low < 0.0 < none.high
    steep = slope(x.tolist(), (3.0 * x + noise).tolist())
    assert steep.low < 3.0 < steep.high and steep.value == pytest.approx(3.0, abs=0.2)


def test_each_law_is_fitted_best_by_its_own_model() -> None:
    n = np.array(PERIODS, np.float64)
    hyperbola, exponential = 0.4 + 0.5 / n, 0.4 + 0.5 * np.exp(-0.2 * (n - 1.0))
    assert fit_hyperbola(PERIODS, hyperbola.tolist()).residual < 1e-9
    assert fit_exponential(PERIODS, hyperbola.tolist()).residual > 1e-3
    assert fit_exponential(PERIODS, exponential.tolist()).residual < 1e-3
    assert fit_hyperbola(PERIODS, exponential.tolist()).residual > 1e-2


def test_the_error_model_finds_what_it_was_made_of() -> None:
    n = np.array((2, 4, 12, 32), np.float64)
    fit = fit_error(n.tolist(), (0.03 * (1.0 - np.exp(-0.15 * (n - 1.0)))).tolist())
    assert fit.scale == pytest.approx(0.03, rel=0.02)
    assert fit.rate == pytest.approx(0.15, rel=0.03)
    assert fit.residual < 1e-4

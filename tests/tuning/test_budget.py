"""Bounds, and what fits into a budget."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import UsageError
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import Budget
from shadercache.tuning.laboratory import Run


def test_a_psnr_is_an_rmse_in_decibels() -> None:
    bound = Bound("psnr", 40.0)
    assert bound.error == pytest.approx(0.01)
    assert bound.told(0.01) == "40.0 dB" and bound.told(0.0) == "inf dB"
    assert str(bound) == "psnr 40 dB"
    assert Bound("rmse", 0.01).told(0.0042) == "0.0042"


@pytest.mark.parametrize("limit", [0.0, -1.0, float("nan"), float("inf"), 1.5])
def test_what_is_no_bound(limit: float) -> None:
    with pytest.raises(UsageError, match="SC008"):
        Bound("rmse", limit)


def test_what_was_timed_tells_what_fits() -> None:
    seconds = iter([0.0, 10.0, 10.0])
    budget = Budget(100.0, lambda: next(seconds))
    run = Run(10)
    assert budget.expected(run, 4, 0) == 0.0  # nothing is known yet
    budget.note(run, 4, 5.0, 0)
    assert budget.expected(run, 9, 0) == pytest.approx(10.0)
    assert budget.fits(0.25, (run, 9, 0))
    assert not budget.fits(0.15, (run, 9, 0))


def test_the_slower_of_two_runs_is_believed() -> None:
    budget = Budget(100.0, lambda: 0.0)
    run = Run(10)
    for seconds in (5.0, 10.0, 1.0):
        budget.note(run, 4, seconds, 0)
    assert budget.expected(run, 4, 0) > 5.0
    small = Run(10, small=True)
    assert budget.expected(small, 4, 0) == 0.0

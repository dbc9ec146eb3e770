"""Ages that are followed from frame to frame, and the error by age."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.measure.metrics.pixel_motion import PixelMotion
from shadercache.measure.metrics.texel_age import AgeError, AgeErrors, next_ages

ROW = np.ones((1, 6), bool)


def moved(right: float) -> PixelMotion:
    x = np.arange(6) + 0.5
    return PixelMotion(np.stack([x - right, np.full(6, 0.5)], axis=-1)[None], ROW)


def test_what_hits_grows_older_where_it_goes() -> None:
    before = np.array([[0, 1, 2, 3, 4, 5]])
    hit = np.array([[0, 1, 1, 0, 1, 1]], bool)
    assert next_ages(before, hit, ROW, moved(1.0)).tolist() == [[0, 1, 2, 0, 4, 5]]
    assert next_ages(before, hit, ROW, moved(0.0)).tolist() == [[0, 2, 3, 0, 5, 6]]


def test_what_is_not_cached_has_no_age() -> None:
    before = np.array([[-1, 1, 2, 3, 4, 5]])
    cached = np.array([[1, 1, 0, 1, 1, 1]], bool)
    # The first hit reuses a texel beside the nearest one, which is at least as old as the last.
    assert next_ages(before, ROW & cached, cached, moved(0.0)).tolist() == [[1, 2, -1, 4, 5, 6]]


def test_a_period_without_motion() -> None:
    """A quarter is due in each frame: after a period every age from 0 to 3 is there."""
    due = [np.array([[frame % 4 == turn for turn in (0, 1, 2, 3, 0, 1)]]) for frame in range(12)]
    ages = np.zeros((1, 6), np.int64)
    for frame in range(1, 12):
        ages = next_ages(ages, ~due[frame], ROW, moved(0.0))
    assert ages.tolist() == [[3, 2, 1, 0, 3, 2]]


def test_errors_by_age() -> None:
    ages = np.array([[0, 1, 2, 3, 4, -1]])
    error = np.zeros((1, 6, 3), np.float32)
    error[0, :, 0] = [0.0, 0.1, 0.2, 0.3, 0.5, 9.0]
    total = AgeErrors()
    total.add(ages, error, ROW)
    total.add(ages, error, ROW)
    found = total.result()
    assert [(age.youngest, age.oldest) for age in found] == [(0, 0), (1, 1), (2, 2), (3, 4)]
    assert [age.share for age in found] == pytest.approx([0.2, 0.2, 0.2, 0.4])
    rmse = [0.0, 0.1 / 3**0.5, 0.2 / 3**0.5, ((0.09 + 0.25) / 6) ** 0.5]
    assert [age.rmse for age in found] == pytest.approx(rmse)


@pytest.mark.parametrize(
    ("age", "youngest", "oldest"),
    [
        (0, 0, 0),
        (5, 5, 8),
        (8, 5, 8),
        (9, 9, 16),
        (64, 33, 64),
        (65, 65, 128),
        (65_535, 32_769, 65_536),
    ],
)
def test_ages_are_put_together_by_powers_of_two(age: int, youngest: int, oldest: int) -> None:
    total = AgeErrors()
    total.add(np.full((2, 2), age), np.zeros((2, 2, 3), np.float32), np.ones((2, 2), bool))
    assert total.result() == (AgeError(youngest, oldest, 1.0, 0.0),)


def test_uncovered_pixels_have_no_part() -> None:
    total = AgeErrors()
    total.add(np.zeros((2, 2), np.int64), np.ones((2, 2, 3), np.float32), np.zeros((2, 2), bool))
    assert total.result() == ()

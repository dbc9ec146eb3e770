"""Errors over several outputs: floats by distance, integers by what changed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from shadercache.measure.output_errors import OutputErrors

COVERED = np.ones((4, 4), np.bool_)


def floats(value: float) -> np.ndarray:
    return np.full((4, 4, 4), value, np.float32)


def test_one_output_is_its_error() -> None:
    errors = OutputErrors()
    assert errors.add((floats(0.0),), (floats(0.5),), COVERED) == 0.5
    assert errors.stats().rmse == 0.5
    assert errors.each(("a",)) == ()


def test_floats_count_as_if_side_by_side() -> None:
    errors = OutputErrors()
    pair = (floats(0.0), floats(0.0))
    assert errors.add(pair, (floats(0.0), floats(0.5)), COVERED) == math.sqrt(0.125)
    assert errors.stats().rmse == math.sqrt(0.125)
    assert [one.error for one in errors.each(("a", "b"))] == [0.0, 0.5]


def test_integers_count_by_what_changed() -> None:
    errors = OutputErrors()
    ids = np.zeros((4, 4, 4), np.uint32)
    other = ids.copy()
    other[0, 0, 1] = 1 << 24
    found = errors.add((ids, floats(0.0)), (other, floats(0.25)), COVERED)
    assert found == 0.25, "what has no distance is not in the whole"
    number, color = errors.each(("number", "color"))
    assert (number.error, number.integers) == (pytest.approx(1 / 16), True)
    assert (color.error, color.integers) == (0.25, False)


def test_integers_alone_are_the_whole() -> None:
    errors = OutputErrors()
    ids = np.zeros((4, 4, 4), np.int32)
    other = ids.copy()
    other[:2] = 3
    assert errors.add((ids,), (other,), COVERED) == math.sqrt(0.5)

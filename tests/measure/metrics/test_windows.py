"""SSIM and FLIP: equal images, constants, what a window sees."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.measure.image_error import Floats
from shadercache.measure.metrics.flip_error import RADIUS, flip_error
from shadercache.measure.metrics.structural import SMALLEST, structural_similarity

WHOLE = np.ones((64, 64), bool)


def noise(seed: int, height: int = 64, width: int = 64) -> Floats:
    return np.random.default_rng(seed).random((height, width, 3), np.float32)


def test_equal_images() -> None:
    one = noise(1)
    assert structural_similarity(one, one.copy(), WHOLE) == 1.0
    assert flip_error(one, one.copy(), WHOLE) == 0.0


def test_the_ssim_of_constants_is_that_of_their_means() -> None:
    """Wang et al. 2004, equation 6, with C1 = (0.01 * L)^2 and no variance."""
    one, other = np.full((32, 32, 3), 0.25, np.float32), np.full((32, 32, 3), 0.75, np.float32)
    expected = (2 * 0.25 * 0.75 + 1e-4) / (0.25**2 + 0.75**2 + 1e-4)
    found = structural_similarity(one, other, np.ones((32, 32), bool))
    assert found == pytest.approx(expected, abs=1e-6)


def test_black_and_white_differ_as_much_as_anything_can() -> None:
    black, white = np.zeros((32, 32, 3), np.float32), np.ones((32, 32, 3), np.float32)
    found = flip_error(black, white, np.ones((32, 32), bool))
    assert found is not None and 0.9 < found <= 1.0


def test_what_is_farther_than_a_window_does_not_count() -> None:
    one = noise(2)
    other = one.copy()
    other[:, 40:] = 0.5
    covered = WHOLE.copy()
    covered[:, 40 - RADIUS :] = False
    assert flip_error(one, other, covered) == 0.0
    assert structural_similarity(one, other, covered) == 1.0
    assert (flip_error(one, other, WHOLE) or 0.0) > 0.1
    assert (structural_similarity(one, other, WHOLE) or 1.0) < 0.9


def test_flip_sees_what_a_display_shows() -> None:
    one = noise(3)
    beyond = np.where(one > 0.9, 1.4, one).astype(np.float32)
    assert flip_error(np.minimum(beyond, 1.0), beyond, WHOLE) == 0.0


def test_nothing_to_compare() -> None:
    one = noise(4)
    assert structural_similarity(one, one, ~WHOLE) is None
    assert flip_error(one, one, ~WHOLE) is None
    small = noise(5, SMALLEST - 1)
    assert structural_similarity(small, small, np.ones((SMALLEST - 1, 64), bool)) is None

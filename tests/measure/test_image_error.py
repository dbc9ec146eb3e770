"""The error of images, over one frame and over several."""

from __future__ import annotations

import math

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.measure.image_error import ErrorStats, ErrorSum, Pixels, encoded_pair

ALL = np.ones((4, 8), bool)


def compare(original: Pixels, image: Pixels, covered: np.ndarray) -> ErrorStats:
    total = ErrorSum()
    total.add(original, image, covered)
    return total.stats()


@pytest.mark.parametrize("kind", [np.uint8, np.float32])
def test_error_of_one_pixel(kind: type[np.generic]) -> None:
    scale = 255 if kind is np.uint8 else 1
    one = np.zeros((4, 8, 4), kind)
    other = one.copy()
    other[1, 2, :3] = np.array([0.2, 0.4, 0.0]) * scale
    other[1, 2, 3] = scale  # alpha is not looked at
    found = compare(one, other, ALL)
    assert found.pixels == 32
    assert found.maximum == pytest.approx(0.4, abs=1e-6)
    assert found.rmse == pytest.approx(math.sqrt((0.04 + 0.16) / 96), rel=1e-6)
    assert found.psnr == pytest.approx(-20 * math.log10(found.rmse))
    assert found.p99 == pytest.approx(0.4, abs=2e-5)


def test_only_covered_pixels_count() -> None:
    one, other = np.zeros((4, 8, 4), np.uint8), np.full((4, 8, 4), 51, np.uint8)
    half = ALL.copy()
    half[:2] = False
    other[2:] = 0
    assert compare(one, other, half).rmse == 0.0
    assert compare(one, other, half).psnr == math.inf
    assert compare(one, other, ~half).rmse == pytest.approx(0.2)
    assert compare(one, other, ~ALL).pixels == 0


def test_frames_add_up() -> None:
    total = ErrorSum()
    zero = np.zeros((4, 8, 4), np.uint8)
    for level in (0, 51):
        total.add(zero, np.full((4, 8, 4), level, np.uint8), ALL)
    found = total.stats()
    assert found.rmse == pytest.approx(0.2 / math.sqrt(2))
    assert (found.p99, found.maximum, found.pixels) == (pytest.approx(0.2), pytest.approx(0.2), 64)


def test_the_percentile_is_exact_for_bytes() -> None:
    rng = np.random.default_rng(3)
    one = rng.integers(0, 256, (64, 64, 4), np.uint8)
    other = rng.integers(0, 256, (64, 64, 4), np.uint8)
    whole = np.ones((64, 64), bool)
    apart = np.abs(one.astype(int) - other)[..., :3].max(-1).ravel() / 255.0
    expected = np.sort(apart)[math.ceil(0.99 * apart.size) - 1]
    assert compare(one, other, whole).p99 == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("poison", [np.nan, np.inf])
def test_poison_is_never_given_a_score(poison: float) -> None:
    one = np.zeros((4, 8, 4), np.float32)
    other = one.copy()
    other[0, 0, 1] = poison
    with pytest.raises(InputError, match="SC604"):
        compare(one, other, ALL)
    uncovered = ALL.copy()
    uncovered[0, 0] = False
    assert compare(one, other, uncovered).rmse == 0.0


def test_images_of_bytes_and_floats_are_encoded_alike() -> None:
    levels = np.arange(4 * 8 * 4, dtype=np.uint8).reshape(4, 8, 4)
    one, other = encoded_pair(levels, levels.astype(np.float64) / 255.0)
    assert one.shape == (4, 8, 3) and one.dtype == other.dtype == np.float32
    assert np.array_equal(one, other) and one.max() == np.float32(126 / 255)


@pytest.mark.parametrize("poison", [np.nan, -np.inf])
def test_windows_see_poison_everywhere(poison: float) -> None:
    one = np.zeros((4, 8, 4), np.float32)
    other = one.copy()
    other[0, 0, 1] = poison
    with pytest.raises(InputError, match="SC604"):
        encoded_pair(one, other)
    one[0, 0, 3] = poison  # alpha is not looked at
    encoded_pair(one, np.zeros_like(one))

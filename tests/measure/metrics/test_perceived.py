"""What is perceived, added up over frames."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from shadercache.measure.image_error import Floats, Mask
from shadercache.measure.metrics import perceived
from shadercache.measure.metrics.block_pattern import block_pattern
from shadercache.measure.metrics.flip_error import flip_error
from shadercache.measure.metrics.perceived import PerceivedSum, missing_extras
from shadercache.measure.metrics.pixel_motion import PixelMotion
from shadercache.measure.metrics.structural import structural_similarity

SIZE = 96


def noise(seed: int) -> Floats:
    return np.random.default_rng(seed).random((SIZE, SIZE, 3), np.float32)


@pytest.fixture
def covered() -> Mask:
    """A part in the middle, so that images are cut before they are looked at."""
    mask = np.zeros((SIZE, SIZE), bool)
    mask[30:70, 25:80] = True
    mask[40, 50] = False
    return mask


def test_it_is_the_mean_of_the_frames(covered: Mask) -> None:
    total = PerceivedSum(block=4)
    pairs = [(noise(1), noise(2)), (noise(3), noise(4))]
    for original, image in pairs:
        total.add(original, image, covered)
    found = total.result()
    assert found.frames == 2
    ssim = [structural_similarity(*pair, covered) for pair in pairs]
    flip = [flip_error(*pair, covered) for pair in pairs]
    pattern = [block_pattern((b - a).mean(axis=-1), covered, 4) for a, b in pairs]
    assert found.ssim == pytest.approx(sum(filter(None, ssim)) / 2, abs=1e-6)
    assert found.flip == pytest.approx(sum(filter(None, flip)) / 2, abs=1e-6)
    assert found.pattern == pytest.approx(sum(filter(None, pattern)) / 2)


def test_flicker_is_a_root_of_the_mean_square(covered: Mask) -> None:
    y, x = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    motion = PixelMotion(np.stack([x, y], axis=-1), np.ones((SIZE, SIZE), bool))
    total, zero = PerceivedSum(block=None), np.zeros((SIZE, SIZE, 3), np.float32)
    total.add_change(zero + np.float32(0.5), zero, motion, covered)
    total.add_change(zero, zero, motion, covered)
    assert total.result().flicker == pytest.approx(0.5 / 2**0.5)


def test_equal_images(covered: Mask) -> None:
    total = PerceivedSum(block=4)
    total.add(noise(5), noise(5), covered)
    found = total.result()
    assert (found.ssim, found.flip, found.pattern) == (1.0, 0.0, None)
    assert (found.flicker, found.by_age) == (None, ())


def test_nothing_covered() -> None:
    total = PerceivedSum(block=4)
    total.add(noise(6), noise(7), np.zeros((SIZE, SIZE), bool))
    found = total.result()
    assert (found.ssim, found.flip, found.flicker, found.pattern) == (None, None, None, None)


def test_libraries_that_are_not_installed(monkeypatch: pytest.MonkeyPatch, covered: Mask) -> None:
    assert missing_extras() == []
    monkeypatch.setattr(perceived, "find_spec", lambda name: None)
    for module in ("skimage", "flip_evaluator"):
        monkeypatch.setitem(sys.modules, module, None)  # an import of it fails
    notes = missing_extras()
    assert len(notes) == 2 and all("pip install 'shadercache[metrics]'" in note for note in notes)
    total = PerceivedSum(block=4)
    total.add(noise(8), noise(9), covered)
    found = total.result()
    assert found.ssim is None and found.flip is None and found.pattern is not None

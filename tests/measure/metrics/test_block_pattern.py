"""The pattern of blocks is found where there is one, and not in noise."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.measure.image_error import Floats
from shadercache.measure.metrics.block_pattern import block_pattern

SIZE = 128
WHOLE = np.ones((SIZE, SIZE), bool)


def noise(seed: int) -> Floats:
    return np.random.default_rng(seed).normal(0.0, 0.02, (SIZE, SIZE)).astype(np.float32)


def blocks(seed: int, block: int) -> Floats:
    """An error by blocks, of which each has its own at random."""
    count = -(-SIZE // block)
    each = np.random.default_rng(seed).normal(0.0, 0.02, (count, count))
    return np.kron(each, np.ones((block, block)))[:SIZE, :SIZE].astype(np.float32)


@pytest.mark.parametrize("block", [2, 4, 8, 12])
def test_blocks_are_found(block: int) -> None:
    found = block_pattern(blocks(1, block), WHOLE, block)
    assert found is not None and found > 20.0


@pytest.mark.parametrize("block", [2, 4, 8, 12])
def test_white_noise_has_none(block: int) -> None:
    found = [block_pattern(noise(seed), WHOLE, block) or 0.0 for seed in range(12)]
    assert 0.6 < np.mean(found) < 1.6 and max(found) < 3.0


def test_blocks_of_another_size_are_not_taken_for_these() -> None:
    assert (block_pattern(blocks(2, 8), WHOLE, 12) or 0.0) < 3.0


def test_a_pattern_is_seen_in_noise_of_its_strength() -> None:
    found = block_pattern(blocks(3, 4) + noise(3), WHOLE, 4)
    assert found is not None and found > 10.0


def test_the_scale_of_the_error_does_not_matter() -> None:
    error = blocks(4, 4) + noise(4)
    assert block_pattern(4.0 * error, WHOLE, 4) == pytest.approx(block_pattern(error, WHOLE, 4))


def test_only_covered_pixels_count() -> None:
    covered = WHOLE.copy()
    covered[:, 96:] = False
    covered[100:] = False
    other = noise(5)
    error = np.where(covered, other, 100.0 * blocks(5, 4)).astype(np.float32)
    assert block_pattern(error, covered, 4) == block_pattern(
        np.where(covered, other, 0.0), covered, 4
    )


def test_its_own_spectrum_has_no_line() -> None:
    """Why steps are looked at: a random pattern of blocks is zero at one per block."""
    power = np.mean(np.abs(np.fft.rfft(blocks(6, 4), axis=1)) ** 2, axis=0)
    assert power[SIZE // 4] < 1e-6 * np.median(power)


def test_nothing_to_find() -> None:
    assert block_pattern(np.zeros((SIZE, SIZE), np.float32), WHOLE, 4) is None
    assert block_pattern(noise(7), ~WHOLE, 4) is None
    assert block_pattern(noise(7), WHOLE, 32) is None, "four blocks in a row"

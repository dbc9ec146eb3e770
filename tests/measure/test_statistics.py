"""Medians, and intervals of the ratio of paired samples."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.measure.statistics import paired_ratio, rank_correlation, timing


def test_timing() -> None:
    found = timing([3.0, 1.0, 2.0])
    assert (found.median, found.minimum, found.samples) == (2.0, 1.0, (3.0, 1.0, 2.0))
    assert found.tail == found.p99 / 2.0 > 1.0
    assert timing([0.0, 0.0]).tail == 1.0, "a clock too coarse for the scene"


def test_a_drift_of_the_machine_leaves_the_ratio_alone() -> None:
    drift = np.linspace(1.0, 3.0, 40)
    found = paired_ratio((drift * 0.02).tolist(), (drift * 0.01).tolist())
    assert found.median == pytest.approx(2.0) and found.total == pytest.approx(2.0)
    assert found.low == pytest.approx(2.0) and found.high == pytest.approx(2.0)


def test_the_interval_covers_the_truth_and_is_the_same_each_time() -> None:
    rng = np.random.default_rng(7)
    covered = 0
    for _ in range(60):
        first = 2.0 * np.exp(rng.normal(0.0, 0.1, 30))
        second = np.exp(rng.normal(0.0, 0.1, 30))
        found = paired_ratio(first.tolist(), second.tolist())
        assert found == paired_ratio(first.tolist(), second.tolist())
        assert found.low <= found.median <= found.high
        covered += found.low <= 2.0 <= found.high
    assert covered >= 52


def test_unpaired_samples_are_refused() -> None:
    with pytest.raises(ValueError, match="not paired"):
        paired_ratio([1.0, 2.0], [1.0])
    with pytest.raises(ValueError, match="not paired"):
        paired_ratio([], [])


def test_the_correlation_of_ranks() -> None:
    assert rank_correlation([1.0, 2.0, 9.0], [0.1, 0.2, 0.3]) == pytest.approx(1.0)
    assert rank_correlation([1.0, 2.0, 9.0], [0.3, 0.2, 0.1]) == pytest.approx(-1.0)
    # Ranks 1, 2.5, 2.5, 4 and 1, 3, 2, 4: (5 - 0.5) / sqrt(4.5 * 5) by hand.
    tied = rank_correlation([1.0, 2.0, 2.0, 3.0], [1.0, 3.0, 2.0, 4.0])
    assert tied == pytest.approx(4.5 / (4.5 * 5.0) ** 0.5)


def test_what_says_nothing_has_no_correlation() -> None:
    assert rank_correlation([1.0, 2.0], [1.0, 2.0]) is None
    assert rank_correlation([1.0, 1.0, 1.0], [1.0, 2.0, 3.0]) is None
    assert rank_correlation([], []) is None
    with pytest.raises(ValueError, match="not paired"):
        rank_correlation([1.0], [])

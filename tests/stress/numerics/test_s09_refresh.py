"""S9: what refresh schedules leave unrefreshed under motion, and how even they are."""

from __future__ import annotations

import math

import numpy as np
import pytest

from bench.pan import ages, pan
from shadercache.caching.configuration import RefreshSchedule
from shadercache.gpu.context import Gpu
from tests.configured import configured

from .criteria import Criteria

pytestmark = pytest.mark.xdist_group("gl")

VELOCITIES = ((0.1, 0.03), (0.5, 0.2), (1.0, 0.0), (1.7, 0.9), (4.0, 0.0), (0.0, -4.0), (0.0, 0.0))
"""Pixels a frame: below one, odd, and by just a block."""

MOST_REFRESHED = 1.3
"""Of a period's share per frame, on average over velocities, with the guard of ages (law 7)."""


@pytest.mark.parametrize("schedule", ["stratified", "random", "tiled"])
def test_each_frame_refreshes_its_share(
    gpu: Gpu, stress: Criteria, schedule: RefreshSchedule
) -> None:
    """Each block has one turn in a period; and of stratified ones no frame has 5 % more than its
    share, unless that is less than one block."""
    sizes = ((128, 128), (200, 150), (512, 512), (1024, 1024)) if stress.deep else ((128, 128),)
    worst = 0.0
    for size in sizes:
        for period in (4, 7, 16, 32, 64):
            block = 4
            with pan(
                gpu, (0.0, 0.0), configured(refresh=schedule, period=period, block=block), size
            ) as runner:
                refresh = runner.bundle.mask_values["refresh"]
                runner.draw(0)
                due = np.stack([runner.hit_mask(clock) == refresh for clock in range(period)])
            assert (due.sum(0) == 1).all(), "each pixel is refreshed once in a period"
            counts = due[:, ::block, ::block].sum((1, 2))
            share = due[0, ::block, ::block].size / period
            if schedule == "stratified":
                assert counts.max() <= math.ceil(share)
                assert counts.min() >= math.floor(share)
            worst = max(worst, counts.max() / math.ceil(share))
    stress.tell("most blocks of a frame, of an even share", worst)
    if schedule == "stratified":
        stress.at_most("most blocks of a frame, of an even share", worst, 1.05)


@pytest.mark.parametrize("period", [7, 32])
def test_ages_are_bounded_with_the_guard(gpu: Gpu, stress: Criteria, period: int) -> None:
    """Law 7, by a payload that is the number of the frame in which it was computed."""
    shares = []
    for velocity in VELOCITIES:
        with pan(gpu, velocity, configured(age=True, period=period), (96, 96)) as runner:
            found = ages(runner, 40 * period if stress.deep else 2 * period)
        shares.append(np.mean(found.refreshed) * period / (1.0 - found.missed))
        # Frame numbers are blended in 32-bit floats, which adds up to some 1e-4 frames.
        oldest = round(found.worst, 3)
        stress.at_most(f"oldest at {velocity} pixels a frame, frames of {period}", oldest, period)
        # No frame is a burst: of what is there, none refreshes twice the share.
        stress.at_most("worst frame, of a period's share", max(found.refreshed) * period, 2.0)
    stress.at_most("refreshed, of a period's share", float(np.mean(shares)), MOST_REFRESHED)


def test_a_reset_is_no_burst_a_period_later(gpu: Gpu, stress: Criteria) -> None:
    period = 32
    for velocity in ((0.0, 0.0), (0.5, 0.2), (1.0, 0.0)):
        with pan(gpu, velocity, configured(age=True, period=period), (96, 96)) as runner:
            found = ages(runner, 3 * period, warm=1)
        share = max(found.refreshed) * period
        stress.at_most(f"worst frame at {velocity}, of a period's share", share, 2.5)


@pytest.mark.parametrize("schedule", ["stratified", "random", "tiled"])
def test_ages_without_the_guard(gpu: Gpu, stress: Criteria, schedule: RefreshSchedule) -> None:
    """Nothing is promised but that refreshing happens: the distribution is told."""
    period = 16
    for velocity in VELOCITIES:
        with pan(gpu, velocity, configured(refresh=schedule, period=period), (96, 96)) as runner:
            found = ages(runner, 40 * period if stress.deep else 2 * period)
        told = f"mean {found.mean:.1f}, oldest {found.worst:.0f}, {found.over:.1%} over the period"
        stress.tell(f"ages at {velocity} pixels a frame, period {period}", told)
        share = float(np.mean(found.refreshed)) * period
        stress.at_most("refreshed, of a period's share", abs(share - 1.0), 0.05)


def test_the_guard_bounds_what_would_grow_old(gpu: Gpu) -> None:
    """The test above could not fail if nothing ever grew older than the period."""
    with pan(gpu, (1.0, 0.0), configured(period=16), (96, 96)) as runner:
        assert ages(runner, 64).worst > 16

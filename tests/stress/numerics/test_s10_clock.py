"""S10: the clock beyond 2^24, where floats count no further, and 2^32, where integers wrap."""

from __future__ import annotations

import numpy as np
import pytest

from bench.pan import pan
from shadercache.caching.configuration import RefreshSchedule
from shadercache.gpu.context import Gpu
from tests.configured import configured

from .criteria import Criteria

pytestmark = pytest.mark.xdist_group("gl")

EDGES = (2**24, 2**31, 2**32)


@pytest.mark.parametrize("schedule", ["stratified", "random", "tiled"])
@pytest.mark.parametrize("period", [7, 10, 32])
def test_no_phase_jumps(gpu: Gpu, stress: Criteria, schedule: RefreshSchedule, period: int) -> None:
    """At rest each pixel is refreshed once in any ``period`` frames in a row, across the edge."""
    wrong = 0
    with pan(
        gpu, (0.0, 0.0), configured(refresh=schedule, period=period), (64, 64), False
    ) as runner:
        refresh = runner.bundle.mask_values["refresh"]
        runner.draw(0)
        for edge in EDGES:
            frames = range(edge - period, edge + period)
            due = np.stack([runner.hit_mask(frame) == refresh for frame in frames])
            turns = np.cumsum(due, axis=0)
            inside = turns[period:] - turns[:-period]
            wrong += int(np.count_nonzero(inside != 1))
            wrong += int(np.count_nonzero(turns[period - 1] != 1))
    stress.none("pixels that miss their turn, or have two, about 2^24, 2^31 and 2^32", wrong)


def test_ages_do_not_know_the_clock(gpu: Gpu, stress: Criteria) -> None:
    """A run across 2^32 with the guard: no age beyond the period."""
    period = 10
    with pan(gpu, (0.5, 0.2), configured(age=True, period=period), (64, 64)) as run:
        oldest = 0.0
        for frame in range(2**32 - 20, 2**32 + 20):
            run.draw(frame)
            found = run.ages()
            assert found is not None
            oldest = max(oldest, float(found.max()))
    stress.at_most("oldest, frames of 10", oldest, period)

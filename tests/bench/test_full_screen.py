"""The full-screen shaders: what they cache is found again, and near to the original."""

from __future__ import annotations

import pytest

from bench.full_screen import CASES, Case, run, table
from shadercache.measure.measurement import MeasureOptions

pytestmark = pytest.mark.xdist_group("gl")


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.file)
def test_reuse_is_near_where_old_frames_are_not(case: Case) -> None:
    row = run(case, (96, 64), 16, MeasureOptions(20))
    # A sixteenth is refreshed. In so small a picture the mosaic's far floor passes no depth test.
    assert 0.6 < row.hits < 0.94
    assert row.rmse <= 0.01
    assert row.unchanged > 3.0 * row.rmse
    assert case.file.removesuffix(".frag") in table([row])

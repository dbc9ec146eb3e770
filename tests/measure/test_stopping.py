"""When a measurement ends early."""

from __future__ import annotations

import pytest

from shadercache.measure.statistics import Ratio, StopRule, widest

NARROW, WIDE = Ratio(2.0, 1.96, 2.04, 2.0), Ratio(0.5, 0.45, 0.55, 0.5)


def test_the_widest_interval_decides() -> None:
    assert widest([NARROW]) == pytest.approx(0.02)
    assert widest([NARROW, WIDE]) == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("elapsed", "ratios", "met"),
    [(1.0, [NARROW], True), (1.0, [NARROW, WIDE], False), (9.0, [NARROW, WIDE], True)],
)
def test_it_ends_when_all_are_known_or_time_is_up(
    elapsed: float, ratios: list[Ratio], met: bool
) -> None:
    assert StopRule(0.03, 8.0).is_met(elapsed, ratios) is met

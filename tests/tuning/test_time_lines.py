"""Times that follow from the time of hits."""

from __future__ import annotations

import pytest

from shadercache.tuning.time_lines import TimeLine


def test_one_value_tells_a_level_or_a_shift() -> None:
    level, shift = TimeLine(slope=0.0), TimeLine(slope=1.0)
    for line in (level, shift):
        line.learn("one", 0.3, 1.4)
    assert level.at(0.9) == pytest.approx(1.4)
    assert shift.at(0.9) == pytest.approx(2.0)


def test_two_values_tell_a_line() -> None:
    line = TimeLine(slope=0.0)
    line.learn("one", 0.3, 1.3)
    assert line.wants("other") and not line.wants("one")
    line.learn("other", 0.9, 1.6)
    assert line.at(0.6) == pytest.approx(1.45)
    assert not line.wants("third")


@pytest.mark.parametrize("y", [5.0, 0.2])
def test_a_line_is_no_steeper_than_the_shader_and_never_falls(y: float) -> None:
    line = TimeLine(slope=0.5)
    line.learn("one", 0.2, 1.3)
    line.learn("other", 0.8, y)
    mean = (1.3 + y) / 2.0
    assert line.at(0.5) == pytest.approx(mean)
    assert line.at(0.9) == pytest.approx(mean + (0.4 if y > 1.3 else 0.0))


def test_values_beside_each_other_tell_no_slope() -> None:
    line = TimeLine(slope=0.0)
    line.learn("one", 0.30, 1.3)
    line.learn("other", 0.31, 1.5)
    assert line.at(0.9) == pytest.approx(1.4)

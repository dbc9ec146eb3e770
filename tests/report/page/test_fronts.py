"""The Pareto front."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from shadercache.report.page.fronts import Point, pareto_front

STEPS = st.integers(0, 5).map(float)


@given(st.lists(st.tuples(STEPS, STEPS), max_size=12))
def test_the_front_is_what_nothing_beats(points: list[Point]) -> None:
    front = [points[number] for number in pareto_front(points)]
    beaten = {
        (time, error)
        for time, error in points
        if any(t <= time and e <= error and (t, e) != (time, error) for t, e in points)
    }
    assert set(front) == set(points) - beaten
    assert front == sorted(front)
    assert len(set(front)) == len(front)

"""Cuts that nobody told: what gives them away, and what does not."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from shadercache.render.cut_detector import CutDetector


def turned(degrees: float) -> NDArray[np.float64]:
    angle = np.radians(degrees)
    matrix = np.eye(4)
    matrix[0, 0] = matrix[2, 2] = np.cos(angle)
    matrix[0, 2], matrix[2, 0] = np.sin(angle), -np.sin(angle)
    return matrix.ravel()


def watched(angles: list[float]) -> list[int]:
    """The frames that look like cuts as a matrix turns."""
    watch = CutDetector()
    for frame, (before, now) in enumerate(pairwise(angles), start=1):
        watch.moved(frame, {"u_model": turned(before)}, {"u_model": turned(now)}, ["u_model"])
    return [suspicion.frame for suspicion in watch.suspicions]


@pytest.mark.parametrize("step", [0.0, 0.2, 5.0, 20.0])
def test_a_leap_is_a_cut_and_steady_motion_is_none(step: float) -> None:
    steady = [step * frame for frame in range(20)]
    assert watched(steady) == []
    assert watched([*steady, steady[-1] + 170.0, steady[-1] + 170.0 + step]) == [20]


def test_counters_and_clocks_may_leap() -> None:
    watch = CutDetector()
    for frame in range(5):
        before, now = ({"u_time": np.array([10.0**n])} for n in (frame, frame + 1))
        watch.moved(frame, before, now, ["u_time"])
    assert not watch.suspicions


def test_a_collapse_of_hits_is_told_with_its_numbers() -> None:
    watch = CutDetector()
    for frame, rate in enumerate([0.0, 0.93, 0.95, 0.92, 0.7, 0.95, 0.03, 0.94]):
        watch.hit(frame, rate)
    assert [suspicion.frame for suspicion in watch.suspicions] == [6]
    assert "hits fell from 92% to 3%" in str(watch.suspicions[0])


def test_one_frame_is_named_once() -> None:
    watch = CutDetector()
    watch.hit(1, 0.9)
    watch.moved(2, {"m": turned(0.0)}, {"m": turned(0.1)}, ["m"])
    watch.hit(3, 0.0)
    watch.moved(3, {"m": turned(0.1)}, {"m": turned(90.0)}, ["m"])
    (only,) = watch.suspicions
    assert "hits fell" in only.why and "at once" in only.why


def test_what_was_before_a_reset_is_no_measure() -> None:
    watch = CutDetector()
    watch.hit(1, 0.9)
    watch.reset()
    watch.hit(2, 0.0)
    assert not watch.suspicions

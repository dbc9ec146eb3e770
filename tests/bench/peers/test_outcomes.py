"""The front, the sentence on who wins where, and the plot of both."""

from __future__ import annotations

import io
from dataclasses import dataclass

import msgspec
import numpy as np
import pytest
from PIL import Image

from bench.peers.outcomes import Point, SceneOutcome, pareto_front, who_wins
from bench.peers.plane import plot_planes, spanned, spread


def point(label: str, ratio: float, rmse: float, kind: str = "peer", **errors: float) -> Point:
    return Point(
        label=label,
        kind="cache" if kind == "cache" else "peer",
        ratio=ratio,
        low=0.9 * ratio,
        high=1.1 * ratio,
        milliseconds=10.0 / ratio,
        errors={"rmse": rmse, **errors},
    )


POINTS = (
    point("half", 2.5, 0.03),
    point("fine", 1.2, 0.004, "cache"),
    point("coarse", 1.7, 0.01, "cache"),
    point("worse", 1.6, 0.011),
    point("slow", 0.8, 0.001),
    point("quarter", 4.0, 0.06),
)


def labels(points: list[Point]) -> list[str]:
    return [one.label for one in points]


def test_the_front_is_what_nothing_else_beats() -> None:
    assert labels(pareto_front(POINTS, "rmse")) == ["fine", "coarse", "half", "quarter"]
    assert labels(pareto_front(POINTS[::-1], "rmse")) == ["fine", "coarse", "half", "quarter"]


def test_of_two_with_one_error_the_faster_is_on_the_front() -> None:
    pair = [point("a", 1.5, 0.01), point("b", 1.6, 0.01), point("c", 1.6, 0.02)]
    assert labels(pareto_front(pair, "rmse")) == ["b"]


def test_the_original_is_on_the_front_of_those_that_are_slower() -> None:
    assert pareto_front([point("a", 1.0, 0.01), point("b", 0.5, 0.0)], "rmse") == []


def test_what_may_be_no_faster_is_not_on_the_front() -> None:
    unsure = point("unsure", 1.1, 0.001)
    assert unsure.low < 1.0
    assert labels(pareto_front([unsure, *POINTS], "rmse")) == labels(pareto_front(POINTS, "rmse"))


def test_a_metric_that_was_not_measured_makes_no_front() -> None:
    seen = point("seen", 1.5, 0.01, flip=0.2)
    assert labels(pareto_front([*POINTS, seen], "flip")) == ["seen"]


def test_the_sentence_names_who_is_the_fastest_from_which_error_on() -> None:
    assert who_wins(POINTS, "rmse") == (
        "By RMSE, nothing is faster than the original below 0.004; from 0.004 on the fastest is "
        "the cache of fine or coarse (1.20 times as fast, 1.70 times at 0.01); "
        "from 0.03 on it is half (2.50 times as fast); "
        "from 0.06 on it is quarter (4.00 times as fast)."
    )
    assert who_wins(POINTS[4:5], "rmse") == "By RMSE, nothing is faster than the original."


def test_caches_apart_from_each_other_are_told_apart() -> None:
    between = [*POINTS, point("other", 2.8, 0.04, "cache")]
    expected = "it is half (2.50 times as fast); from 0.04 on it is the cache of other (2.80"
    assert expected in who_wins(between, "rmse")


@dataclass(frozen=True)
class Range:
    low: float
    high: float


@pytest.mark.parametrize("of", [Range(0.5, 0.5), Range(0.5, 0.6), Range(0.01, 1.0)])
def test_an_axis_spans_a_factor_of_two_at_least(of: Range) -> None:
    low, high = spanned(of.low, of.high)
    assert low < of.low and high > of.high
    assert high / low >= 2.0 * (1.0 - 1e-12)


def test_labels_are_moved_apart_and_stay_in_order() -> None:
    heights = [0.0, 0.5, 0.501, 0.502, 0.99, 0.995, 1.0]
    placed = spread(heights)
    assert np.diff(placed).min() > 0.04
    assert placed[0] == 0.0 and placed[-1] <= 1.0
    assert abs(placed[1] - 0.5) < 1e-9
    many = spread([0.5] * 60)
    assert np.diff(many).min() > 0.0 and min(many) > -1e-9 and max(many) <= 1.0


def outcome(points: tuple[Point, ...]) -> SceneOutcome:
    return SceneOutcome(
        schema_version=1,
        scene="ring",
        size=(64, 64),
        frames=8,
        clock="none",
        environment={},
        original=10.0,
        points=points,
        winners={},
    )


def test_a_plane_is_drawn_for_each_metric_there_is() -> None:
    one = Image.open(io.BytesIO(plot_planes(outcome(POINTS))))
    more = point("seen", 1.5, 0.0, flip=0.2, flicker=0.0)
    three = Image.open(io.BytesIO(plot_planes(outcome((*POINTS, more)))))
    assert three.height == 3 * one.height
    assert np.ptp(np.asarray(one.convert("L"))) > 100


def test_an_outcome_is_read_back_as_it_was_written() -> None:
    found = outcome(POINTS)
    assert msgspec.json.decode(msgspec.json.encode(found), type=SceneOutcome) == found

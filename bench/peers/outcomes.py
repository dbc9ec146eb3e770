"""What a comparison found: a point for everything that was drawn, the front, who wins where."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal

import msgspec

SCHEMA_VERSION = 1

METRICS: Mapping[str, str] = {
    "rmse": "RMSE",
    "flip": "FLIP",
    "flicker": "flicker",
}
"""The errors that are drawn against time, 0 for equal images, and what they are called."""


class Point(msgspec.Struct, frozen=True, kw_only=True):
    """Something that was drawn.

    ``kind``: a variant of the cache, or a peer. ``ratio``: how many times as long the original
    takes, with its 95 % interval; ``milliseconds``: the mean of a frame. ``errors``: by metric,
    over the covered pixels; ``p99`` and ``ssim`` are not errors to draw. ``configuration``: of the
    variants of a cache. ``samples``: seconds of each frame but the first.
    """

    label: str
    kind: Literal["cache", "peer"]
    ratio: float
    low: float
    high: float
    milliseconds: float
    errors: dict[str, float]
    configuration: dict[str, Any] | None = None
    samples: tuple[float, ...] = ()


class SceneOutcome(msgspec.Struct, frozen=True, kw_only=True):
    """One scene: where and how it was measured, its points, and the sentences.

    ``original``: milliseconds of a frame, and ``samples`` of it as of points. ``winners``: a
    sentence for each metric.
    """

    schema_version: int
    scene: str
    size: tuple[int, int]
    frames: int
    clock: str
    environment: dict[str, Any]
    original: float
    points: tuple[Point, ...]
    winners: dict[str, str]
    samples: tuple[float, ...] = ()


def pareto_front(points: Iterable[Point], metric: str) -> list[Point]:
    """What nothing else is both faster and nearer than, in ascending order of the error.

    The original is one of them, so only what is faster belongs to the front, and that with its
    whole interval. Points without the metric are left out.
    """
    front: list[Point] = []
    fastest = 1.0
    known = (point for point in points if metric in point.errors and point.low > 1.0)
    for point in sorted(known, key=lambda point: (point.errors[metric], -point.ratio)):
        if point.ratio > fastest:
            front.append(point)
            fastest = point.ratio
    return front


def who_wins(points: Sequence[Point], metric: str) -> str:
    """One sentence: up to which error the original wins, and from which on who does."""
    front, name = pareto_front(points, metric), METRICS[metric]
    if not front:
        return f"By {name}, nothing is faster than the original."
    steps = [f"nothing is faster than the original below {_number(front[0].errors[metric])}"]
    for run in _runs(front):
        first, last = run[0], run[-1]
        ratios = f"{first.ratio:.2f} times as fast"
        if len(run) > 1:
            ratios += f", {last.ratio:.2f} times at {_number(last.errors[metric])}"
        labels = " or ".join(point.label for point in run)
        who = f"the cache of {labels}" if first.kind == "cache" else labels
        verb = "it is" if len(steps) > 1 else "the fastest is"
        steps.append(f"from {_number(first.errors[metric])} on {verb} {who} ({ratios})")
    return f"By {name}, {'; '.join(steps)}."


def _runs(front: Sequence[Point]) -> list[list[Point]]:
    """Neighbours on the front that are variants of the cache go together; peers go alone."""
    runs: list[list[Point]] = []
    for point in front:
        if runs and point.kind == "cache" == runs[-1][0].kind:
            runs[-1].append(point)
        else:
            runs.append([point])
    return runs


def _number(error: float) -> str:
    return f"{error:.2g}"

"""Error against time: a plane for each metric, with the front and a label for every point.

matplotlib takes half a second to import, so it is imported when a plot is made.
"""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from bench.peers.outcomes import METRICS, Point, SceneOutcome, pareto_front

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LOOKS: Mapping[str, Mapping[str, Any]] = {
    "cache": {"marker": "o", "color": "#26849a", "label": "a cached value"},
    "peer": {"marker": "s", "color": "#d6573c", "label": "instead"},
}
_LEAST_ERROR = 1e-5
_SPAN = 2.0
"""Each axis spans at least so much, so that no plot makes much of nothing."""


def plot_planes(outcome: SceneOutcome) -> bytes:
    """Planes beside one another, a PNG file: of the metrics that anything was measured by."""
    from matplotlib.figure import Figure

    shown = [
        metric for metric in METRICS if any(metric in point.errors for point in outcome.points)
    ]
    figure = Figure(figsize=(7.5 * len(shown), 6.0), layout="constrained")
    for number, metric in enumerate(shown, start=1):
        _plane(figure.add_subplot(1, len(shown), number), outcome, metric)
    width, height = outcome.size
    figure.suptitle(f"{outcome.scene}, {width} x {height}: error against time")
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110)
    return buffer.getvalue()


def _plane(axes: Axes, outcome: SceneOutcome, metric: str) -> None:
    points = [point for point in outcome.points if metric in point.errors]
    places = {point.label: _place(point, metric) for point in points}
    for kind, look in _LOOKS.items():
        of_kind = [places[point.label] for point in points if point.kind == kind]
        if of_kind:
            axes.scatter(*zip(*of_kind, strict=True), s=26, zorder=3, **look)
    axes.set_xscale("log")
    axes.set_yscale("log")
    x, y = (np.array(of) for of in zip(*places.values(), strict=True))
    axes.set_xlim(*spanned(float(x.min()), max(1.0, float(x.max()))))
    axes.set_ylim(*spanned(float(y.min()), float(y.max())))
    axes.axvline(1.0, color="#333333", lw=1.0, label="the original")
    front = [places[point.label] for point in pareto_front(points, metric)]
    if front:
        _staircase(axes, front)
    _labels(axes, places)
    axes.set_xlabel("time of a frame over that of the original")
    axes.set_ylabel(f"{METRICS[metric]} over the covered pixels")
    ticks = [tick for tick in (0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0)]
    low, high = axes.get_xlim()
    axes.set_xticks([tick for tick in ticks if low <= tick <= high])
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.minorticks_off()
    axes.grid(True, which="both", color="#eeeeee", zorder=0)
    axes.legend(loc="upper right", fontsize=7)


def _place(point: Point, metric: str) -> tuple[float, float]:
    return 1.0 / point.ratio, max(point.errors[metric], _LEAST_ERROR)


def spanned(low: float, high: float) -> tuple[float, float]:
    """A range on a logarithmic axis, with a margin, from at most ``low`` to at least ``high``."""
    widen = max(1.15, np.sqrt(_SPAN * low / high))
    return low / widen, high * widen


def _staircase(axes: Axes, front: Sequence[tuple[float, float]]) -> None:
    """The front, which goes on to the left and upwards: there is nothing below and left of it."""
    x, y = (list(of) for of in zip(*front, strict=True))
    axes.step([1.0, *x], [y[0], *y], where="pre", color="#888888", lw=1.2, label="the front")


def _labels(axes: Axes, places: Mapping[str, tuple[float, float]]) -> None:
    """Names in a column beside the plane, in the order of the points, with a line to each."""
    order = sorted(places, key=lambda label: places[label][1])
    for number, label in enumerate(order):
        axes.annotate(
            label,
            places[label],
            xytext=(1.02, (number + 0.5) / len(order)),
            textcoords="axes fraction",
            fontsize=7,
            va="center",
            arrowprops={"arrowstyle": "-", "color": "#bbbbbb", "lw": 0.5},
        )

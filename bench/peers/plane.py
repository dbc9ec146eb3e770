"""Error against time: a plane for each metric, with the front and a label for every point.

matplotlib takes half a second to import, so it is imported when a plot is made.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from bench.peers.outcomes import METRICS, Point, SceneOutcome, pareto_front

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

_LOOKS: Mapping[str, Mapping[str, Any]] = {
    "cache": {"marker": "o", "color": "#26849a", "label": "a value cached"},
    "peer": {"marker": "s", "color": "#d6573c", "label": "a peer"},
}
_LEAST_ERROR = 1e-5
_SPAN = 2.0
"""Each axis spans at least so much, so that no plot makes much of nothing."""

_MARGIN = 1.15
_LINE = 0.042
"""Height of a line of text over that of a plane."""


def plot_planes(outcome: SceneOutcome) -> bytes:
    """Planes below one another, a PNG file: of the metrics that anything was measured by."""
    from matplotlib.figure import Figure

    shown = [
        metric for metric in METRICS if any(metric in point.errors for point in outcome.points)
    ]
    figure = Figure(figsize=(9.0, 5.0 * len(shown)), layout="constrained")
    for number, metric in enumerate(shown, start=1):
        _plane(figure.add_subplot(len(shown), 1, number), outcome, metric)
    width, height = outcome.size
    figure.suptitle(f"{outcome.scene}, {width} x {height}: error against time")
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=100)
    return buffer.getvalue()


def _plane(axes: Axes, outcome: SceneOutcome, metric: str) -> None:
    points = [point for point in outcome.points if metric in point.errors]
    places = {point.label: _place(point, metric) for point in points}
    for kind, look in _LOOKS.items():
        x, y = (
            [places[point.label][at] for point in points if point.kind == kind] for at in (0, 1)
        )
        axes.plot(x, y, ls="", ms=5, zorder=3, **look)
    axes.axvline(1.0, color="#333333", lw=1.0, label="the original")
    front = [places[point.label] for point in pareto_front(points, metric)]
    if front:
        _staircase(axes, front)
    times, errors = (np.array(of) for of in zip(*places.values(), strict=True))
    _scale(axes.set_xscale, axes.set_xlim, axes.xaxis, (float(times.min()), max(1.0, times.max())))
    _scale(axes.set_yscale, axes.set_ylim, axes.yaxis, (float(errors.min()), float(errors.max())))
    _labels(axes, places)
    axes.set_xlabel("time of a frame over that of the original")
    axes.set_ylabel(f"{METRICS[metric]} over the covered pixels")
    axes.grid(True, color="#eeeeee", zorder=0)
    axes.legend(loc="best", fontsize=7)


def _place(point: Point, metric: str) -> tuple[float, float]:
    return 1.0 / point.ratio, max(point.errors[metric], _LEAST_ERROR)


def _scale(
    set_scale: Callable[[str], None],
    set_limits: Callable[[float, float], Any],
    axis: Axis,
    values: tuple[float, float],
) -> None:
    """Make an axis logarithmic, with some ticks in each decade."""
    from matplotlib.ticker import LogLocator, NullLocator

    set_scale("log")
    set_limits(*spanned(*values))
    axis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(lambda value, _: f"{value:g}")


def spanned(low: float, high: float) -> tuple[float, float]:
    """A range on a logarithmic axis, with a margin, from at most ``low`` to at least ``high``."""
    widen = max(_MARGIN, float(np.sqrt(_SPAN * low / high)))
    return low / widen, high * widen


def _staircase(axes: Axes, front: Sequence[tuple[float, float]]) -> None:
    """The front, from the original on: there is nothing below and left of it."""
    x, y = (list(of) for of in zip(*front, strict=True))
    axes.step([1.0, *x], [y[0], *y], where="pre", color="#888888", lw=1.2, label="the front")


def _labels(axes: Axes, places: Mapping[str, tuple[float, float]]) -> None:
    """Names in a column beside the plane, each as near to its point's height as there is room."""
    low, high = np.log(axes.get_ylim())
    order = sorted(places, key=lambda label: (places[label][1], -places[label][0]))
    heights = [(float(np.log(places[label][1])) - low) / (high - low) for label in order]
    for label, height in zip(order, spread(heights), strict=True):
        axes.annotate(
            label,
            places[label],
            xytext=(1.02, height),
            textcoords="axes fraction",
            fontsize=7,
            va="center",
            arrowprops={"arrowstyle": "-", "relpos": (0.0, 0.5), "color": "#bbbbbb", "lw": 0.5},
        )


def spread(heights: Sequence[float]) -> list[float]:
    """Heights in ascending order, moved apart so that lines of text fit between 0 and 1."""
    gap = min(_LINE, 1.0 / max(1, len(heights) - 1))
    placed: list[float] = []
    for height in heights:
        placed.append(max(height, placed[-1] + gap) if placed else max(0.0, height))
    # Pushed up, the last may stand above 1: then all come down again as far as they must.
    top = 1.0
    for at in range(len(placed) - 1, -1, -1):
        placed[at] = min(placed[at], top)
        top = placed[at] - gap
    return placed

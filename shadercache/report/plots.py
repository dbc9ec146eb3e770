"""The plots of a sweep: time against P/T, error against time, hits by frame.

The first two are figure 8 of Sitthi-amorn et al. 2008, the last is figure 6.2 of Nehab et al. 2006,
course.

matplotlib takes half a second to import, so it is imported when a plot is made.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from shadercache.caching.algorithms import NAMES
from shadercache.caching.configuration import Configuration
from shadercache.measure.measurement import (
    Curve,
    Measurement,
    NodeResult,
    SubjectResult,
    VariantResult,
)
from shadercache.report.axes import (
    PointLabel,
    label_points,
    make_logarithmic,
    new_axes,
    to_png,
)

_SHAPES, _COLORS = "os^Dv*", ("#26849a", "#d6573c", "#6a58a8", "#7a8b2f", "#b8860b", "#555555")
MARKERS = dict(zip(NAMES, zip(_SHAPES, _COLORS, strict=True), strict=False))
"""Marker and colour of each algorithm, the same in every plot."""

_FILLS = ("full", "none", "left", "top", "right", "bottom")
"""How markers are filled, of each period and block."""

_LEAST_ERROR = 1e-5


def plot_time(measurement: Measurement) -> bytes:
    """Median frame time (ms) of every variant against the node's measured P/T; a PNG file.

    The original's time is a line, its geometry's a dotted one; bars span the speed-up's interval.
    """
    figure, axes = new_axes(f"{measurement.scene}: time against payload share")
    for name, drawn in _by_kind(measurement).items():
        known = [(node.ratio, variant) for node, variant in drawn if node.ratio is not None]
        if not known:
            continue
        x = [ratio for ratio, _ in known]
        y = [variant.timing.median * 1e3 for _, variant in known]
        look = _look(measurement, drawn[0][1].configuration)
        bars = np.array([_bar(variant) for _, variant in known]).T
        axes.errorbar(x, y, yerr=bars, **look, ls="", ms=4, lw=0.8, alpha=0.8, label=name)
    original, geometry = _medians(measurement)
    axes.axhline(original, color="#333333", lw=1.2, label=f"original, {original:.1f} ms")
    axes.axhline(geometry, color="#999999", lw=1.0, ls=":", label=f"geometry, {geometry:.1f} ms")
    axes.set_xlabel("P/T: cost of the payload over cost of the shader, measured")
    axes.set_ylabel("median time of a frame (ms)")
    axes.set_xlim(min(0.0, axes.get_xlim()[0]), max(1.0, axes.get_xlim()[1]))
    axes.set_ylim(bottom=0.0)
    label_points(figure, axes, _fastest(measurement))
    return to_png(figure, axes)


def plot_error(measurement: Measurement) -> bytes:
    """RMSE of every variant against its median frame time (ms); a PNG file.

    The error is on a logarithmic scale; images without error stand at its lower end. What is no
    variant is a cross. The line joins those that nothing beats in both.
    """
    figure, axes = new_axes(f"{measurement.scene}: error against time")
    points = []
    for name, drawn in _by_kind(measurement).items():
        here = [_point(node.label, variant) for node, variant in drawn]
        look = _look(measurement, drawn[0][1].configuration)
        x, y = [point.x for point in here], [point.y for point in here]
        axes.plot(x, y, **look, ls="", ms=4, alpha=0.8, label=name)
        points += here
    others = [_point(other.label, other) for group in measurement.groups for other in group.others]
    x, y = [point.x for point in others], [point.y for point in others]
    axes.plot(x, y, marker="x", color="#333333", ls="", ms=5)
    points += others
    best = pareto_front(points)
    axes.plot([p.x for p in best], [p.y for p in best], color="#bbbbbb", lw=0.8, zorder=0)
    original, _ = _medians(measurement)
    axes.axvline(original, color="#333333", lw=1.2, label=f"original, {original:.1f} ms")
    axes.set_xlim(0.0, 1.1 * max(original, *(point.x for point in points)))
    make_logarithmic(axes, [point.y for point in points])
    axes.set_xlabel("median time of a frame (ms)")
    axes.set_ylabel("RMSE over covered pixels (display-encoded, 0-1)")
    label_points(figure, axes, [*best, *others, *points])
    return to_png(figure, axes)


def pareto_front(points: Iterable[PointLabel]) -> list[PointLabel]:
    """The points that no other is both left of and below of, from left to right."""
    front: list[PointLabel] = []
    for point in sorted(points, key=lambda point: (point.x, point.y)):
        if not front or point.y < front[-1].y:
            front.append(point)
    return front


def _point(label: str, found: SubjectResult) -> PointLabel:
    return PointLabel(found.timing.median * 1e3, max(found.error.rmse, _LEAST_ERROR), label)


def plot_hits(measurement: Measurement) -> bytes | None:
    """The share of hits in every frame of each node; a PNG file.

    None where nothing was counted. The level of full reuse is what random refresh leaves.
    """
    curves = {}
    for node in measurement.nodes:
        for curve in node.curves:
            which = f", n{curve.period} k{curve.block}" if len(node.curves) > 1 else ""
            curves[node.label + which] = curve
    return plot_curves(f"{measurement.scene}: hit rate", curves) if curves else None


def plot_curves(title: str, curves: Mapping[str, Curve]) -> bytes:
    """The share of hits in every frame of each curve, by name; a PNG file."""
    figure, axes = new_axes(title)
    for label, curve in curves.items():
        rates = f"mean {curve.hit_rate:.1%}, {curve.found_rate:.1%} of what was not due"
        axes.plot(range(1, len(curve.hit)), curve.hit[1:], lw=1.2, label=f"{label}: {rates}")
    for number, period in enumerate(dict.fromkeys(curve.period for curve in curves.values())):
        label = "" if number else "1 - 1/period"
        # Of what is found again a refresh leaves 1 - 1/n (Scherzer et al. 2010, 3.4.1).
        axes.axhline(1.0 - 1.0 / period, color="#999999", lw=1.0, ls=":", label=label)
    # The share that Nehab et al. 2006 say is found again.
    axes.axhline(0.9, color="#333333", lw=0.8, ls="--", label="90 %")
    axes.set_xlabel("frame")
    axes.set_ylabel("share of the visible pixels of cached objects")
    axes.set_ylim(0.0, 1.0)
    return to_png(figure, axes)


def _fastest(measurement: Measurement) -> list[PointLabel]:
    """The fastest variant of each node, those of much P/T first."""
    known = [(node, node.ratio) for node in measurement.nodes if node.ratio is not None]
    return [
        PointLabel(ratio, min(of.timing.median for of in node.variants) * 1e3, node.label)
        for node, ratio in sorted(known, key=lambda pair: -pair[1])
    ]


def _by_kind(measurement: Measurement) -> dict[str, list[tuple[NodeResult, VariantResult]]]:
    """The variants by what tells those of one node apart."""
    kinds: dict[str, list[tuple[NodeResult, VariantResult]]] = {}
    for node in measurement.nodes:
        for variant in node.variants:
            kinds.setdefault(measurement.name(variant.configuration), []).append((node, variant))
    return dict(sorted(kinds.items()))


def _look(measurement: Measurement, configuration: Configuration) -> dict[str, Any]:
    """Marker and colour by the algorithm, filled by period and block."""
    marker, color = MARKERS.get(configuration.algorithm, ("x", "#555555"))
    refresh = configuration.refresh
    place = measurement.refreshes.index((refresh.period, refresh.block))
    return {"marker": marker, "color": color, "fillstyle": _FILLS[place % len(_FILLS)]}


def _bar(variant: VariantResult) -> tuple[float, float]:
    """How far the interval of the speed-up reaches below and above the time, in ms."""
    middle = variant.timing.median * 1e3
    ratio = variant.speedup
    # Of very few frames the median may lie outside of its interval.
    below, above = 1 - ratio.median / ratio.high, ratio.median / ratio.low - 1
    return middle * max(0.0, below), middle * max(0.0, above)


def _medians(measurement: Measurement) -> tuple[float, float]:
    """Milliseconds of the original and of its geometry."""
    groups = measurement.groups
    original = np.median([group.original.median for group in groups])
    geometry = np.median([group.geometry.median for group in groups])
    return float(original) * 1e3, float(geometry) * 1e3

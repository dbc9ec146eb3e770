"""Axes that show enough, labels that can be read, and the front of what nothing beats."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from shadercache.report.axes import (
    LEAST_SPAN,
    PointLabel,
    label_points,
    make_logarithmic,
    new_axes,
    to_png,
)
from shadercache.report.plots import pareto_front


@pytest.mark.parametrize("values", [(8.984e-3, 8.998e-3), (1e-5, 1e-5), (1e-5, 0.2), (0.01, 0.025)])
def test_a_logarithmic_axis_spans_enough_and_has_ticks(values: tuple[float, float]) -> None:
    figure, axes = new_axes("title")
    axes.plot((1.0, 2.0), values)
    make_logarithmic(axes, values)
    low, high = axes.get_ylim()
    assert low < min(values) and max(values) < high
    assert high / low >= LEAST_SPAN * (1 - 1e-9) >= 2.0
    figure.draw_without_rendering()
    ticks = [tick for tick in axes.get_yticks() if low <= tick <= high]
    assert ticks
    # Told apart, and without more digits than anybody reads.
    words = [axes.yaxis.get_major_formatter()(tick) for tick in ticks]
    assert len(set(words)) == len(words) and all(len(word) <= 6 for word in words)


def test_labels_that_would_be_over_others_are_left_out() -> None:
    figure, axes = new_axes("title")
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, 1.0)
    labels = [
        PointLabel(0.2, 0.2, "first"),
        PointLabel(0.201, 0.2, "over it"),
        PointLabel(0.8, 0.8, "far away"),
    ]
    label_points(figure, axes, labels)
    assert [text.get_text() for text in axes.texts] == ["first", "far away"]


def test_the_front_is_what_nothing_beats() -> None:
    places = {"fast": (1.0, 0.5), "between": (2.0, 0.3), "beaten": (2.5, 0.4), "exact": (4.0, 0.1)}
    points = [PointLabel(x, y, name) for name, (x, y) in places.items()]
    found = [point.words for point in pareto_front(reversed(points))]
    assert found == ["fast", "between", "exact"]
    twins = [PointLabel(1.0, 0.5, "a"), PointLabel(1.0, 0.5, "b")]
    assert len(pareto_front(twins)) == 1 and pareto_front([]) == []


def test_a_plot_is_a_picture() -> None:
    figure, axes = new_axes("title")
    axes.plot((0.0, 1.0), (0.0, 1.0), label="line")
    with Image.open(io.BytesIO(to_png(figure, axes))) as image:
        assert image.size == (1200, 750)
        assert len(np.unique(np.asarray(image))) > 2

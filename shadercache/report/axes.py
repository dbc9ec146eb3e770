"""What every plot has in common: a figure, axes that show enough, labels that do not overlap.

matplotlib takes half a second to import, so it is imported when a plot is made.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.transforms import Bbox

LEAST_SPAN = 4.0
"""The end of a logarithmic axis over its beginning, at least: results that are nearly the same are
to look so."""

_LABEL_SIZE = 7


@dataclass(frozen=True, slots=True)
class PointLabel:
    """Words beside a point, which is in units of the axes."""

    x: float
    y: float
    words: str


def new_axes(title: str) -> tuple[Figure, Axes]:
    """An empty plot."""
    # Not pyplot: it keeps global state and wants a display.
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.0, 5.0), dpi=150, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.set_title(title, loc="left", fontsize=11)
    axes.grid(True, color="#dddddd", lw=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def make_logarithmic(axes: Axes, values: Iterable[float]) -> None:
    """Give the y axis a logarithmic scale that holds all values and spans a factor of four."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    known = list(values)
    low, high = min(known), max(known)
    # The same at both ends, so that values of a small span stand in the middle.
    room = max(1.25, math.sqrt(max(1.0, LEAST_SPAN * low / high)))
    axes.set_yscale("log")
    axes.set_ylim(low / room, high * room)
    # Between two decades of the usual ticks a small span would have none.
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def label_points(figure: Figure, axes: Axes, labels: Iterable[PointLabel]) -> None:
    """Write words beside points, in this order, and leave out what would be over another.

    The limits of the axes are to be set before.
    """
    canvas: Any = figure.canvas
    figure.draw_without_rendering()  # lays the axes out, so that places in pixels are known
    taken: list[Bbox] = []
    for label in labels:
        text = axes.annotate(
            label.words,
            (label.x, label.y),
            xytext=(4, 3),
            textcoords="offset points",
            fontsize=_LABEL_SIZE,
            color="#444444",
        )
        box = text.get_window_extent(canvas.get_renderer())
        if any(box.overlaps(other) for other in taken):
            text.remove()
        else:
            taken.append(box)


def to_png(figure: Figure, axes: Axes) -> bytes:
    """The plot with its legend, as a PNG file."""
    axes.legend(frameon=False, fontsize=9)
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    return buffer.getvalue()

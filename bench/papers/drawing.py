"""Plots: panels beside or above each other, with the looks of the package's own plots."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING

from shadercache.report.plots import MARKERS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLORS = {name: color for name, (_, color) in MARKERS.items()}
"""Of each algorithm."""

SHAPES = {name: marker for name, (marker, _) in MARKERS.items()}

PALETTE = ("#26849a", "#d6573c", "#6a58a8", "#7a8b2f", "#b8860b", "#555555")

ORIGINAL, BARE = "#333333", "#999999"


def panels(
    rows: int, columns: int, size: tuple[float, float], share: str = ""
) -> tuple[Figure, list[Axes]]:
    """A figure of ``size`` inches with its panels, row by row.

    ``share`` names the axes that all panels have in common: ``x``, ``y``, ``xy``.
    """
    # Not pyplot: it keeps global state and wants a display.
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=130, layout="constrained")
    FigureCanvasAgg(figure)
    made = figure.subplots(rows, columns, squeeze=False, sharex="x" in share, sharey="y" in share)
    every = [axes for row in made for axes in row]
    for axes in every:
        axes.grid(True, color="#dddddd", lw=0.6)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
    return figure, every


def png(figure: Figure) -> bytes:
    """The figure as a PNG file."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    return buffer.getvalue()


def mark_periods(axes: Axes, periods: Sequence[int]) -> None:
    """A logarithmic axis of periods with a tick at each."""
    axes.set_xscale("log", base=2)
    axes.set_xticks(periods, [str(period) for period in periods])
    axes.minorticks_off()

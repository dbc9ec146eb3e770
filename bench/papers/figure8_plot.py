"""The plot of figure 8: times, the ratio to two passes, P/T and overlap, node by node."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from bench.papers.drawing import BARE, COLORS, ORIGINAL, SHAPES, panels, png
from bench.papers.rules import OVERLAP
from shadercache.caching.algorithms import USUAL

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from bench.papers.figure8 import Point


def plot(scene: str, nodes: Sequence[Point]) -> bytes:
    """Three panels above each other; nodes from left to right in ascending P/T."""
    from matplotlib.ticker import MaxNLocator

    figure, (times, ratios, shares) = panels(3, 1, (9.0, 10.0), share="x")
    original = 1e3 * float(np.median([np.median(node.turns.original) for node in nodes]))
    _times(times, nodes, original)
    times.set_title(f"{scene}: time by node, block 4, period 32", loc="left", fontsize=11)
    _ratios(ratios, nodes)
    at = np.arange(1, len(nodes) + 1)
    twice = [node.facts.overlap for node in nodes]
    shares.plot(at, [node.ratio for node in nodes], color=ORIGINAL, lw=1.2, label="P/T, measured")
    shares.bar(at, twice, color="#d9a441", label="computed in both passes (static)")
    shares.set_ylabel("share of the shader")
    shares.set_xlabel("node, in ascending P/T")
    shares.xaxis.set_major_locator(MaxNLocator(integer=True))
    shares.set_ylim(min(0.0, nodes[0].ratio), max(1.05, nodes[-1].ratio))
    shares.legend(frameon=False, fontsize=9)
    return png(figure)


def _times(axes: Axes, nodes: Sequence[Point], original: float) -> None:
    for name in USUAL:
        drawn = [(at, node) for at, node in enumerate(nodes, start=1) if node.has(name)]
        x, y = [at for at, _ in drawn], [original * node.share(name) for _, node in drawn]
        speeds = [node.turns.speedup(node.label(name)) for _, node in drawn]
        # Of very few frames the median may lie outside of its interval.
        below = [time * max(0.0, 1 - s.median / s.high) for time, s in zip(y, speeds, strict=True)]
        above = [time * max(0.0, s.median / s.low - 1) for time, s in zip(y, speeds, strict=True)]
        axes.errorbar(
            x,
            y,
            yerr=[below, above],
            marker=SHAPES[name],
            color=COLORS[name],
            ls="",
            ms=3.5,
            lw=0.8,
            label=name,
        )
    bare = original * float(np.median([node.turns.bare for node in nodes]))
    axes.axhline(original, color=ORIGINAL, lw=1.2, label=f"original, {original:.1f} ms")
    axes.axhline(bare, color=BARE, lw=1.0, ls=":", label=f"geometry, {bare:.1f} ms")
    # Above the points there is room for the legend.
    axes.set_ylim(0.0, 1.3 * axes.get_ylim()[1])
    axes.set_ylabel("time of a frame (ms)")
    axes.legend(frameon=False, fontsize=9, ncols=5, loc="upper left")


def _ratios(axes: Axes, nodes: Sequence[Point]) -> None:
    """How many times as fast as two passes; nodes with overlap are ringed."""
    for name in ("1-pass", "3-pass"):
        drawn = [(at, node) for at, node in enumerate(nodes, start=1) if node.has(name, "2-pass")]
        y = [node.share("2-pass") / node.share(name) for _, node in drawn]
        look: dict[str, Any] = {"marker": SHAPES[name], "color": COLORS[name], "ls": "", "ms": 3.5}
        axes.plot([at for at, _ in drawn], y, label=f"{name} against 2-pass", **look)
        rings = [
            (at, ratio)
            for (at, node), ratio in zip(drawn, y, strict=True)
            if node.facts.overlap >= OVERLAP
        ]
        axes.scatter(
            [at for at, _ in rings], [ratio for _, ratio in rings], 60, fc="none", ec="#d9a441"
        )
    axes.axhline(1.0, color=COLORS["2-pass"], lw=1.2, label="2-pass")
    low, high = axes.get_ylim()
    axes.set_yscale("log", base=2)
    axes.set_ylim(min(low, 0.5), max(high, 2.0))
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_ylabel("2-pass time over its time")
    axes.legend(frameon=False, fontsize=9)

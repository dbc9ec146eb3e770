"""FIG9: time over the refresh period for several blocks (T8 to T10).

Figure 9 of Sitthi-amorn et al. 2008: the dragon's node of two of five octaves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from bench.papers.claims import Verdict
from bench.papers.drawing import BARE, COLORS, ORIGINAL, PALETTE, SHAPES, mark_periods, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.models import Fit, fit_exponential, fit_hyperbola
from bench.papers.rules import (
    Interval,
    all_of,
    is_above,
    is_below,
    is_more,
    is_positive,
    is_unchanged,
    median_interval,
    written,
)
from bench.papers.turns import Turns, Variant, take_turns, until_known
from bench.papers.two_octaves import by_period, label, two_octaves
from shadercache.caching.algorithms import USUAL
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.measure.statistics import Ratio, paired_ratio, widest

PERIODS, BLOCKS = (2, 4, 8, 16, 32, 64), (1, 2, 4, 8)
FITTED = 4
"""The block whose curves are fitted: that of figure 8."""

FRAMES, SECONDS = 16, 150.0


@dataclass(frozen=True, slots=True)
class Figure9:
    """What is stored; all was drawn in the same turns."""

    periods: tuple[int, ...]
    blocks: tuple[int, ...]
    turns: Turns

    def shares(self, algorithm: str, block: int) -> list[float]:
        """The curve of an algorithm: times as shares of the original's."""
        return [self.turns.share(name) for name in by_period(algorithm, self.periods, block)]

    def over_periods(self, algorithm: str, block: int, other: int) -> Ratio:
        """The time with a block over that with another, at all periods, frame by frame."""
        both = [
            [time for period in self.periods for time in self.times(algorithm, period, edge)]
            for edge in (block, other)
        ]
        return paired_ratio(*both)

    def bend(self, algorithm: str, block: int) -> Interval:
        """What the first half of the steps saves more than the second, as a share of the original,
        frame by frame."""
        last = len(self.periods) - 1
        first, middle, end = (
            np.array(self.times(algorithm, self.periods[at], block)) for at in (0, last // 2, last)
        )
        return median_interval((first - 2.0 * middle + end) / self.turns.original)

    def times(self, algorithm: str, period: int, block: int) -> tuple[float, ...]:
        """The samples of one variant."""
        return self.turns.of(label(algorithm, period, block)).times


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Figure9:
    """Measure all periods and blocks in the same turns."""
    tell(0, 1)
    periods = tuple(options.some(PERIODS, quick=3))
    with two_octaves(gpu, options.size) as bench:
        subjects = [
            Variant(label(subject.configuration.algorithm, period, block), subject)
            for period in periods
            for block in BLOCKS
            for subject in bench.variants(period, block)
        ]
        how = until_known(options.frames(FRAMES), options.seconds(SECONDS))
        return Figure9(periods, BLOCKS, take_turns(bench.world, bench.linker, subjects, how))


def judge(data: Figure9) -> list[Verdict]:
    """T8 to T10."""
    return [_drops(data), _decays(data), _from_one_to_two(data), _from_two_to_four(data)]


def _drops(data: Figure9) -> Verdict:
    """T8: from the first to the last period surely less, at no step surely more, and the first
    half of the steps brings more than the second."""
    found: list[bool | None] = []
    words = []
    for name in USUAL:
        labels = by_period(name, data.periods, FITTED)
        steps = [data.turns.ratio(*pair) for pair in pairwise(labels)]
        whole = data.turns.ratio(labels[0], labels[-1])
        shares = data.shares(name, FITTED)
        middle = (len(shares) - 1) // 2
        first, second = shares[0] - shares[middle], shares[middle] - shares[-1]
        less = is_positive(data.bend(name, FITTED))
        found += [is_more(whole), not any(map(is_below, steps)), less]
        words.append(
            f"{name} {written(whole)} times as fast at {data.periods[-1]} as at {data.periods[0]}, "
            f"{first:.3f} of the original saved up to {data.periods[middle]}, {second:.3f} beyond"
        )
    return Verdict("T8", all_of(found), "; ".join(words))


def fits(data: Figure9, algorithm: str) -> tuple[Fit, Fit]:
    """The hyperbola and the exponential through an algorithm's curve."""
    shares = data.shares(algorithm, FITTED)
    return fit_hyperbola(data.periods, shares), fit_exponential(data.periods, shares)


def _decays(data: Figure9) -> Verdict:
    """T8b: the exponential, which has a parameter more, must leave less than half of what the
    hyperbola leaves, for every algorithm whose time drops. Where both leave no more than the
    intervals of the times do, they cannot be told apart."""
    holds: list[bool | None] = []
    words = []
    for name in USUAL:
        labels = by_period(name, data.periods, FITTED)
        if not is_above(data.turns.ratio(labels[0], labels[-1])):
            continue
        hyperbola, exponential = fits(data, name)
        closer = exponential.residual < 0.5 * hyperbola.residual
        unknown = widest(map(data.turns.slowdown, labels)) * max(data.shares(name, FITTED))
        worse = max(hyperbola.residual, exponential.residual)
        holds.append(closer if worse > unknown else None)
        words.append(
            f"{name}: a + b/n leaves {hyperbola.residual:.4f} of the original's time, "
            f"a + b exp(-c n) with c = {exponential.rate:.2f} leaves {exponential.residual:.4f}"
        )
    if not holds:
        return Verdict("T8b", None, "no algorithm's time drops")
    # Three parameters fit a few points, whatever law is behind them.
    if len(data.periods) < 5:
        return Verdict("T8b", None, f"too few periods; {'; '.join(words)}")
    return Verdict("T8b", all_of(holds), "; ".join(words))


def _from_one_to_two(data: Figure9) -> Verdict:
    """T9: surely less for each algorithm."""
    ratios = {name: data.over_periods(name, 1, 2) for name in USUAL}
    words = ", ".join(f"{name} {written(ratio)}" for name, ratio in ratios.items())
    return Verdict(
        "T9", all_of(map(is_more, ratios.values())), f"time with k = 1 over k = 2: {words}"
    )


def _from_two_to_four(data: Figure9) -> Verdict:
    """T10: no change of more than the margin from 2 to 4, nor from 4 to 8."""
    found: list[bool | None] = []
    words = []
    for small, large in ((2, 4), (4, 8)):
        ratios = {name: data.over_periods(name, small, large) for name in USUAL}
        found += map(is_unchanged, ratios.values())
        each = ", ".join(f"{name} {written(ratio)}" for name, ratio in ratios.items())
        words.append(f"time with k = {small} over k = {large}: {each}")
    return Verdict("T10", all_of(found), "; ".join(words))


def table(data: Figure9) -> str:
    """A row for each algorithm and block: speed-ups by period."""
    header = ("algorithm", "block", *(f"n {period}" for period in data.periods))
    rows = format_table(header, _rows(data))
    lines = []
    for name in USUAL:
        hyperbola, exponential = fits(data, name)
        lines += [
            f"{name}, k = {FITTED}: hyperbola {hyperbola.words}",
            f"{name}, k = {FITTED}: exponential {exponential.words}",
        ]
    return "\n".join([rows, f"widest interval {data.turns.widest:.1%}", *lines])


def _rows(data: Figure9) -> Iterator[tuple[str, ...]]:
    for name in USUAL:
        for block in data.blocks:
            speeds = [
                data.turns.speedup(one).median for one in by_period(name, data.periods, block)
            ]
            yield name, str(block), *(f"{speed:.2f}x" for speed in speeds)


def draw(data: Figure9) -> dict[str, bytes]:
    """A panel for each algorithm, a curve for each block."""
    figure, every = panels(1, len(USUAL), (12.0, 4.6), share="xy")
    original = 1e3 * float(np.median(data.turns.original))
    for axes, name in zip(every, USUAL, strict=True):
        for block, color in zip(data.blocks, PALETTE, strict=False):
            times = [original * share for share in data.shares(name, block)]
            axes.plot(
                data.periods, times, color=color, marker=SHAPES[name], ms=4, label=f"k = {block}"
            )
        hyperbola, _ = fits(data, name)
        smooth = np.geomspace(data.periods[0], data.periods[-1], 60)
        fitted = original * (hyperbola.offset + hyperbola.scale / smooth)
        axes.plot(smooth, fitted, color=COLORS[name], lw=1, ls="--", label="a + b/n, k = 4")
        axes.axhline(original, color=ORIGINAL, lw=1.2, label=f"original, {original:.1f} ms")
        axes.axhline(original * data.turns.bare, color=BARE, lw=1.0, ls=":", label="geometry")
        axes.set_title(name, loc="left", fontsize=11)
        axes.set_xlabel("refresh period (frames)")
        mark_periods(axes, data.periods)
    every[0].set_ylabel("time of a frame (ms)")
    every[0].set_ylim(bottom=0.0)
    every[0].legend(frameon=False, fontsize=9)
    return {"figure9": png(figure)}


EXPERIMENT = Experiment(
    "FIG9", "Time over the refresh period, by block", Figure9, gather, judge, table, draw
)

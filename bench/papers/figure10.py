"""FIG10: time from period 1 to 50, and the model of it (T11 to T13).

Figure 10 of Scherzer et al. 2010: two of five octaves on the dragon.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from bench.papers.claims import Verdict
from bench.papers.drawing import BARE, COLORS, ORIGINAL, SHAPES, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.rules import ALMOST_EVERY, LITTLE, all_of, is_above, is_at_most, is_more, written
from bench.papers.turns import AllHits, Turns, Variant, take_turns, until_known
from bench.papers.two_octaves import by_period, label, two_octaves
from shadercache.caching.algorithms import USUAL
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.measure.measure import outcome_curves
from shadercache.measure.statistics import widest

PERIODS, BLOCKS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 50), (1, 2, 4)
MODELLED = 4
"""The block whose curve the model is compared with."""

HITS = "all hits"
LOW = 4
"""Periods up to here are low."""

CLOSE = 0.05
"""How far a model may be off, as a share of the time, to agree closely."""

FRAMES, SECONDS = 16, 150.0


@dataclass(frozen=True, slots=True)
class Figure10:
    """What is stored; ``found`` is mu, the share of pixels that reprojection finds again."""

    periods: tuple[int, ...]
    blocks: tuple[int, ...]
    found: float
    turns: Turns

    def shares(self, algorithm: str, block: int) -> list[float]:
        """The curve of an algorithm: times as shares of the original's."""
        return [self.turns.share(name) for name in by_period(algorithm, self.periods, block)]

    def predicted(self, algorithm: str, period: float) -> float:
        """Equations 2 and 3, from the times of all hits and of all misses alone."""
        rate = self.found * (1.0 - 1.0 / period)
        # With a period of 1 every pixel is computed, as a miss is: that is T_miss.
        hit = self.turns.share(f"{HITS} {algorithm}")
        return rate * hit + (1.0 - rate) * self.turns.share(label(algorithm, 1, MODELLED))


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Figure10:
    """Measure all periods and blocks in the same turns."""
    tell(0, 1)
    periods = tuple(options.some(PERIODS))
    with two_octaves(gpu, options.size) as bench:
        subjects: list[Variant | AllHits] = [
            Variant(label(subject.configuration.algorithm, period, block), subject)
            for period in periods
            for block in BLOCKS
            for subject in bench.variants(period, block)
        ]
        longest = bench.variants(periods[-1], MODELLED)
        subjects += [AllHits(f"{HITS} {one.configuration.algorithm}", one) for one in longest]
        how = until_known(options.frames(FRAMES), options.seconds(SECONDS))
        turns = take_turns(bench.world, bench.linker, subjects, how)
        [curve] = outcome_curves(bench.world, longest[-1:], how.frames)
    return Figure10(periods, BLOCKS, curve.found_rate, turns)


def judge(data: Figure10) -> list[Verdict]:
    """T11 to T13."""
    return [_one_gains_little(data), _two_at_low(data), _three_consistently(data), _model(data)]


def _one_gains_little(data: Figure10) -> Verdict:
    """T11: at no period and block a speed-up that is surely more than little."""
    labels = [name for block in data.blocks for name in by_period("1-pass", data.periods, block)]
    best = max(labels, key=lambda name: data.turns.speedup(name).median)
    speedup = data.turns.speedup(best)
    holds = is_at_most(speedup, 1.0 + LITTLE)
    return Verdict("T11", holds, f"one pass is at most {written(speedup)} times as fast ({best})")


def _two_at_low(data: Figure10) -> Verdict:
    """T12a: surely slower than the original at some period that is low, but reuses."""
    low = [period for period in data.periods if 1 < period <= LOW]
    if not low:
        return Verdict("T12a", None, "no low period was drawn")
    labels = [name for block in data.blocks for name in by_period("2-pass", low, block)]
    worst = min(labels, key=lambda name: data.turns.speedup(name).median)
    speedup = data.turns.speedup(worst)
    words = f"two passes are {written(speedup)} times as fast as the original at worst ({worst})"
    slower = data.turns.slowdown(worst)
    return Verdict("T12a", is_more(slower), words)


def _three_consistently(data: Figure10) -> Verdict:
    """T12b: surely faster than the original at all periods but 1, with blocks of 4."""
    periods = [period for period in data.periods if period > 1]
    speedups = {p: data.turns.speedup(label("3-pass", p, MODELLED)) for p in periods}
    faster = sum(map(is_above, speedups.values()))
    holds = all_of(map(is_more, speedups.values()))
    worst = min(speedups, key=lambda period: speedups[period].median)
    best = max(speedups, key=lambda period: speedups[period].median)
    words = (
        f"three passes are faster at {faster} of {len(periods)} periods, from "
        f"{written(speedups[worst])} (n = {worst}) to {written(speedups[best])} (n = {best})"
    )
    return Verdict("T12b", holds, words)


def _model(data: Figure10) -> Verdict:
    """T13: within the tolerance at almost every period; nothing is fitted. It cannot be told
    where the times themselves are known less well."""
    off = {}
    for name in USUAL:
        pairs = zip(data.periods, data.shares(name, MODELLED), strict=True)
        # At period 1 the model is the measurement.
        off[name] = [data.predicted(name, n) / share - 1.0 for n, share in pairs if n > 1]
    close = sum(abs(error) <= CLOSE for error in off["3-pass"])
    speedups = map(data.turns.speedup, by_period("3-pass", data.periods, MODELLED))
    known = widest(speedups) <= CLOSE
    holds = close >= ALMOST_EVERY * len(off["3-pass"]) if known else None
    hit = data.turns.share(f"{HITS} 3-pass")
    miss = data.turns.share(label("3-pass", 1, MODELLED))
    errors = ", ".join(f"{name} {min(e):+.1%} to {max(e):+.1%}" for name, e in off.items())
    words = (
        f"mu = {data.found:.3f}, T_hit {hit:.2f} and T_miss {miss:.2f} of the original; off by "
        f"{errors}; three passes within {CLOSE:.0%} at {close} of {len(off['3-pass'])} periods"
    )
    return Verdict("T13", holds, words)


def table(data: Figure10) -> str:
    """A row for each algorithm and block: speed-ups by period; and the model's."""
    header = ("algorithm", "block", *(f"n {period}" for period in data.periods))
    return f"{format_table(header, _rows(data))}\nwidest interval {data.turns.widest:.1%}"


def _rows(data: Figure10) -> Iterator[tuple[str, ...]]:
    for name in USUAL:
        for block in data.blocks:
            labels = by_period(name, data.periods, block)
            speeds = (data.turns.speedup(one).median for one in labels)
            yield name, str(block), *(f"{speed:.2f}x" for speed in speeds)
        modelled = (1.0 / data.predicted(name, period) for period in data.periods)
        yield name, "model", *(f"{speed:.2f}x" for speed in modelled)


def draw(data: Figure10) -> dict[str, bytes]:
    """A panel for each block, a curve for each algorithm."""
    figure, every = panels(1, len(data.blocks), (12.0, 4.6), share="xy")
    original = 1e3 * float(np.median(data.turns.original))
    smooth = np.linspace(data.periods[0], data.periods[-1], 200)
    for axes, block in zip(every, data.blocks, strict=True):
        for name in USUAL:
            look: dict[str, Any] = {
                "color": COLORS[name],
                "marker": SHAPES[name],
                "ms": 4,
                "label": name,
            }
            axes.plot(data.periods, np.multiply(original, data.shares(name, block)), **look)
            if block == MODELLED:
                model = [original * data.predicted(name, period) for period in smooth]
                axes.plot(smooth, model, color=COLORS[name], lw=1.0, ls="--")
        axes.axhline(original, color=ORIGINAL, lw=1.2, label=f"original, {original:.1f} ms")
        axes.axhline(original * data.turns.bare, color=BARE, lw=1.0, ls=":", label="geometry")
        dashed = "; dashed: model" if block == MODELLED else ""
        axes.set_title(f"blocks of {block} x {block}{dashed}", loc="left", fontsize=11)
        axes.set_xlabel("refresh period n (frames)")
    every[0].set_ylabel("time of a frame (ms)")
    every[0].set_ylim(bottom=0.0)
    every[0].legend(frameon=False, fontsize=9)
    return {"figure10": png(figure)}


EXPERIMENT = Experiment(
    "FIG10", "Time from period 1 to 50, with the model", Figure10, gather, judge, table, draw
)

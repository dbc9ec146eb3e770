"""QUADS: refreshed blocks aligned to the 2 x 2 quads against blocks shifted by a pixel (T15).

The emitted text has blocks that begin at the corner of the picture. The shifted ones come from a
replacement in that text.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bench.papers.claims import Verdict
from bench.papers.drawing import COLORS, ORIGINAL, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.rules import is_more, written
from bench.papers.turns import Turns, Variant, take_turns, until_known
from bench.papers.two_octaves import label, two_octaves
from shadercache.caching.algorithms import USUAL
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.measure.statistics import Ratio, paired_ratio
from shadercache.measure.subjects import VariantSubject
from shadercache.render.bundle import Bundle, LinkedObject

PERIODS, BLOCKS = (8, 32), (2, 4)
PLACE, SHIFTED = "uvec2(gl_FragCoord.xy / float(", "uvec2((gl_FragCoord.xy + 1.0) / float("
"""Where the emitted text asks for a pixel's block, and the same a pixel further on."""

FRAMES, SECONDS = 32, 120.0
HALF_WIDTH = 0.01
"""What is looked for may be as small."""

KNOWN = 0.02
"""Intervals up to this half width show that nothing is lost."""


@dataclass(frozen=True, slots=True)
class Alignment:
    """What is stored; all was drawn in the same turns."""

    periods: tuple[int, ...]
    blocks: tuple[int, ...]
    turns: Turns

    def slower(self, algorithm: str, block: int) -> Ratio:
        """The time of shifted blocks over that of aligned ones, at all periods, frame by frame."""
        names = [label(algorithm, period, block) for period in self.periods]
        both = [
            [time for name in names for time in self.turns.of(name + end).times]
            for end in (" shifted", "")
        ]
        return paired_ratio(*both)


def shifted(subject: VariantSubject) -> VariantSubject:
    """The same with its blocks a pixel further to the left and down.

    Raises :class:`ValueError` where the emitted text asks for the block in other words.
    """
    bundle = subject.bundle
    files = {name: text.replace(PLACE, SHIFTED) for name, text in bundle.files.items()}
    if files == bundle.files:
        raise ValueError(f"no file of {bundle.node('id')} holds {PLACE!r}")
    moved = Bundle(bundle.manifest, files)
    objects = [LinkedObject(moved, linked.configuration) for linked in subject.objects]
    return VariantSubject(subject.label, subject.configuration, objects)


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Alignment:
    """Measure both in the same turns."""
    tell(0, 1)
    with two_octaves(gpu, options.size) as bench:
        subjects = []
        for period in PERIODS:
            for block in BLOCKS:
                for subject in bench.variants(period, block):
                    name = label(subject.configuration.algorithm, period, block)
                    subjects += [
                        Variant(name, subject),
                        Variant(f"{name} shifted", shifted(subject)),
                    ]
        how = until_known(options.frames(FRAMES), options.seconds(SECONDS), HALF_WIDTH)
        return Alignment(PERIODS, BLOCKS, take_turns(bench.world, bench.linker, subjects, how))


def judge(data: Alignment) -> list[Verdict]:
    """T15: with blocks of 2 x 2, shifting them surely costs time in most algorithms."""
    ratios = {name: data.slower(name, 2) for name in USUAL}
    slower = [is_more(ratio, KNOWN) for ratio in ratios.values()]
    if slower.count(True) > len(USUAL) / 2:
        holds: bool | None = True
    else:
        holds = None if None in slower else False
    words = [f"{name} {written(ratio)}" for name, ratio in ratios.items()]
    wide = [f"{name} {written(data.slower(name, 4))}" for name in USUAL]
    numbers = f"time shifted over aligned, k = 2: {', '.join(words)}; k = 4: {', '.join(wide)}"
    return [Verdict("T15", holds, numbers)]


def table(data: Alignment) -> str:
    """A row for each algorithm and block."""
    rows = [
        (name, str(block), written(data.slower(name, block)))
        for name in USUAL
        for block in data.blocks
    ]
    return format_table(("algorithm", "block", "time shifted over aligned"), rows)


def draw(data: Alignment) -> dict[str, bytes]:
    """A panel for each block: a pair of bars for each algorithm and period."""
    figure, every = panels(1, len(data.blocks), (9.0, 4.4), share="y")
    original = 1e3 * float(np.median(data.turns.original))
    for axes, block in zip(every, data.blocks, strict=True):
        names = [(name, period) for period in data.periods for name in USUAL]
        for at, (name, period) in enumerate(names):
            one = label(name, period, block)
            color = COLORS[name]
            axes.bar(at - 0.2, original * data.turns.share(one), 0.4, color=color)
            moved = original * data.turns.share(f"{one} shifted")
            axes.bar(at + 0.2, moved, 0.4, color="white", ec=color, hatch="///")
        ticks = [f"{name}\nn = {period}" for name, period in names]
        axes.set_xticks(range(len(names)), ticks, fontsize=8)
        axes.axhline(original, color=ORIGINAL, lw=1.2, label=f"original, {original:.1f} ms")
        axes.set_title(f"blocks of {block} x {block}", loc="left", fontsize=11)
    # Bars without height, for the legend alone.
    every[0].bar(0, 0, color=ORIGINAL, label="aligned to the quads")
    every[0].bar(0, 0, color="white", ec=ORIGINAL, hatch="///", label="shifted by a pixel")
    every[0].set_ylabel("time of a frame (ms)")
    # Above the bars there is room for the legend.
    every[0].set_ylim(0.0, 1.3 * every[0].get_ylim()[1])
    every[0].legend(frameon=False, fontsize=9, loc="upper left")
    return {"quads": png(figure)}


EXPERIMENT = Experiment(
    "QUADS", "Blocks aligned to quads, and shifted", Alignment, gather, judge, table, draw
)

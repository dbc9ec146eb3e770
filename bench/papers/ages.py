"""AGES: how old what is reused gets, with and without a counter beside it (N8).

A picture that moves evenly, whose payload is the number of the frame.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from bench.pan import ages, pan
from bench.papers.claims import Verdict
from bench.papers.drawing import ORIGINAL, PALETTE, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.turns import PERIOD
from shadercache.caching.configuration import Configuration, Refresh
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu

VELOCITIES = ((0.0, 0.0), (0.1, 0.03), (0.5, 0.2), (0.5, 0.5), (1.0, 0.0), (2.0, 0.0), (4.0, 4.0))
FRAMES = 96
SIZE = (192, 192)


@dataclass(frozen=True, slots=True)
class OldestAges:
    """What is stored: the oldest payload of any pixel, in frames, at each velocity."""

    velocities: tuple[tuple[float, float], ...]
    counted: tuple[float, ...]
    plain: tuple[float, ...]


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> OldestAges:
    """Pan at each velocity, with and without ages."""
    velocities = tuple(options.some(VELOCITIES, quick=3))
    oldest: dict[bool, list[float]] = {True: [], False: []}
    for number, velocity in enumerate(velocities):
        tell(number, len(velocities))
        for counted, found in oldest.items():
            chosen = Configuration(refresh=Refresh("random", PERIOD, age=counted))
            with pan(gpu, velocity, chosen, SIZE) as runner:
                found.append(ages(runner, options.frames(FRAMES)).worst)
    return OldestAges(velocities, tuple(oldest[True]), tuple(oldest[False]))


def judge(data: OldestAges) -> list[Verdict]:
    """N8: no payload is older than the period with the counter."""
    oldest, without = max(data.counted), max(data.plain)
    words = (
        f"oldest payload at period {PERIOD}: {oldest:.1f} frames with ages, {without:.1f} without"
    )
    # A filter blends numbers of frames, and its weights are rounded.
    return [Verdict("N8", oldest <= PERIOD + 1e-3, words)]


def table(data: OldestAges) -> str:
    """A row for each velocity."""
    rows = [
        (f"{x:g}, {y:g}", f"{counted:.1f}", f"{plain:.1f}")
        for (x, y), counted, plain in zip(data.velocities, data.counted, data.plain, strict=True)
    ]
    header = ("pixels a frame", "oldest with ages", "oldest without")
    return format_table(header, rows, right=" ".join(header))


def draw(data: OldestAges) -> dict[str, bytes]:
    """A pair of bars for each velocity."""
    figure, (axes,) = panels(1, 1, (8.0, 4.4))
    places = range(len(data.velocities))
    axes.bar([at - 0.2 for at in places], data.counted, 0.4, color=PALETTE[0], label="with ages")
    axes.bar([at + 0.2 for at in places], data.plain, 0.4, color=PALETTE[1], label="without")
    axes.axhline(PERIOD, color=ORIGINAL, lw=1.2, label=f"period, {PERIOD} frames")
    axes.set_xticks(list(places), [f"{x:g}, {y:g}" for x, y in data.velocities])
    axes.set_xlabel("motion (pixels a frame, right and up)")
    axes.set_ylabel("oldest payload (frames)")
    axes.set_ylim(0.0, max(2.0 * PERIOD, 1.1 * max(data.plain)))
    axes.legend(frameon=False, fontsize=9)
    return {"ages": png(figure)}


EXPERIMENT = Experiment(
    "AGES", "The oldest payload under motion", OldestAges, gather, judge, table, draw
)

"""FIG12: the examples with their own factors: trash can and chess (N5 to N7).

Section 3.5 and figure 12 of Scherzer et al. 2010.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from bench.papers.claims import Verdict
from bench.papers.drawing import COLORS, ORIGINAL, SHAPES, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.rules import reaches, written
from bench.papers.turns import Turns, Variant, as_in_the_papers, take_turns, until_known
from bench.papers.two_octaves import by_period, label
from shadercache.caching.algorithms import USUAL
from shadercache.caching.configuration import by_every_algorithm
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.linking.cache_settings import configured
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.subjects import Subject, subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BLOCK = 4
MOVING, RESTING = (2, 4, 8, 16, 32), (8, 32, 64)
"""Periods of what becomes stale and of what does not."""

FRAMES, SECONDS = 40, 60.0


@dataclass(frozen=True, slots=True)
class Example:
    """A claim: a scene's node, at which periods it is drawn, how many times as fast it shall be, at
    which of them, and within which error (RMSE; None: the paper names none).

    ``larger``: how many times as large the picture is, so that shading outweighs the geometry, as
    it did in the papers.
    """

    claim: str
    scene: str
    node: str
    periods: tuple[int, ...]
    factor: float
    period: int | None = None
    most: float | None = None
    larger: int = 1


EXAMPLES = (
    Example("N5", "trashcan/scene", "24 of 25 samples", MOVING, 2.1, period=4, larger=2),
    # "A marginal level of error": one step of eight bits.
    Example("N6", "chess/scene", "static share", RESTING, 8.0, most=0.004),
    # All of it is worth caching where there are more discs.
    Example("N7", "chess/fine", "whole", RESTING, 15.0),
)


@dataclass(frozen=True, slots=True)
class ExampleTimes:
    """One example as it was drawn, ``edge`` pixels across; all of it in the same turns."""

    claim: str
    edge: int
    turns: Turns


@dataclass(frozen=True, slots=True)
class Figure12:
    """What is stored."""

    examples: tuple[ExampleTimes, ...]


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Figure12:
    """Measure each example."""
    found = []
    for number, example in enumerate(EXAMPLES):
        tell(number, len(EXAMPLES))
        edge = example.larger * options.size
        found.append(ExampleTimes(example.claim, edge, _drawn(gpu, example, edge, options)))
    return Figure12(tuple(found))


def _drawn(gpu: Gpu, example: Example, edge: int, options: Options) -> Turns:
    scene, analysis = open_scene(data_path("corpus", f"{example.scene}.toml"))
    linker = Linker(scene, analysis)
    kinds = by_every_algorithm(
        configured(scene, as_in_the_papers(scene.nodes[example.node].split("+")), [])
    )
    subjects: list[Subject] = [
        Variant(label(subject.configuration.algorithm, period, BLOCK), subject)
        for period in example.periods
        for subject in subjects_of(
            linker, example.node, [kind.with_refresh(period, BLOCK) for kind in kinds]
        )
    ]
    how = until_known(options.frames(FRAMES), options.seconds(SECONDS))
    with RenderScene(gpu, linker.scene, (edge, edge)) as world:
        return take_turns(world, linker, subjects, how)


def judge(data: Figure12) -> list[Verdict]:
    """N5 to N7: does the fastest variant within the error reach the factor?"""
    return [_reached(example, drawn) for example, drawn in _pairs(data)]


def _pairs(data: Figure12) -> list[tuple[Example, ExampleTimes]]:
    drawn = {one.claim: one for one in data.examples}
    return [(one, drawn[one.claim]) for one in EXAMPLES if one.claim in drawn]


def _reached(example: Example, drawn: ExampleTimes) -> Verdict:
    turns = drawn.turns
    allowed = [one for one in _series(example, turns) if _is_allowed(example, turns, one)]
    if not allowed:
        return Verdict(example.claim, False, f"no variant has an RMSE of {example.most} or less")
    best = max(allowed, key=lambda one: turns.speedup(one).median)
    speedup, rmse = turns.speedup(best), turns.of(best).rmse
    words = (
        f"{best}: {written(speedup)} times as fast at RMSE {rmse:.4f} and {drawn.edge} x "
        f"{drawn.edge} pixels; the paper's factor is {example.factor:g}"
    )
    return Verdict(example.claim, reaches(speedup, example.factor), words)


def _is_allowed(example: Example, turns: Turns, name: str) -> bool:
    at = example.period is None or name.endswith(f" n{example.period} k{BLOCK}")
    return at and (example.most is None or turns.of(name).rmse <= example.most)


def _series(example: Example, turns: Turns) -> list[str]:
    """The labels of what was drawn."""
    labels = [one for name in USUAL for one in by_period(name, example.periods, BLOCK)]
    return [one for one in labels if turns.has(one)]


def table(data: Figure12) -> str:
    """A row for each variant."""
    header = ("scene", "node", "variant", "ratio", "RMSE")
    return format_table(header, _rows(data))


def _rows(data: Figure12) -> Iterator[tuple[str, ...]]:
    for example, drawn in _pairs(data):
        for name in _series(example, drawn.turns):
            speedup, rmse = written(drawn.turns.speedup(name)), drawn.turns.of(name).rmse
            yield example.scene, example.node, name, speedup, f"{rmse:.4f}"


def draw(data: Figure12) -> dict[str, bytes]:
    """A panel for each example: error against time, a curve for each algorithm over the period."""
    figure, every = panels(1, len(data.examples), (5.0 * len(data.examples), 4.6))
    for axes, (example, drawn) in zip(every, _pairs(data), strict=True):
        _panel(axes, example, drawn.turns)
        axes.set_title(f"{example.scene}: {example.node}", loc="left", fontsize=11)
        axes.set_xlabel(f"time of a frame (ms), {drawn.edge} x {drawn.edge} pixels")
    every[0].set_ylabel("RMSE over covered pixels (display-encoded, 0-1)")
    return {"figure12": png(figure)}


def _panel(axes: Axes, example: Example, turns: Turns) -> None:
    original = 1e3 * float(np.median(turns.original))
    for name in USUAL:
        periods = [n for n in example.periods if turns.has(label(name, n, BLOCK))]
        labels = by_period(name, periods, BLOCK)
        times = [original * turns.share(one) for one in labels]
        errors = [turns.of(one).rmse for one in labels]
        axes.plot(times, errors, color=COLORS[name], marker=SHAPES[name], ms=4, label=name)
        # The curves show the same periods at the same errors, so one of them is labelled.
        if name == USUAL[-1] and periods:
            for at, below in ((0, -12), (-1, 6)):
                axes.annotate(
                    f"n = {periods[at]}",
                    (times[at], errors[at]),
                    (4, below),
                    textcoords="offset points",
                    fontsize=8,
                    color=COLORS[name],
                )
    axes.axvline(original, color=ORIGINAL, lw=1.2, label=f"original, {original:.0f} ms")
    wanted = f"the paper's {example.factor:g}x"
    axes.axvline(original / example.factor, color=ORIGINAL, lw=1.0, ls=":", label=wanted)
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.2 * axes.get_ylim()[1])
    axes.legend(frameon=False, fontsize=9)


EXPERIMENT = Experiment(
    "FIG12", "Trash can and chess by their factors", Figure12, gather, judge, table, draw
)

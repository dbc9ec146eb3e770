"""FIG8: time of every value by each algorithm, in ascending P/T (T1 to T7).

Figure 8 of Sitthi-amorn et al. 2008: dragon and trash can, blocks of 4 x 4, period 32. Expressions
that are reached on several paths of calls (an octave of the noise, a corner of its lattice) cost
the same on each of them, so one path stands for all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from bench.papers import figure8_plot, overhead
from bench.papers.claims import Verdict
from bench.papers.experiment import Experiment, Options
from bench.papers.rules import (
    ALMOST_EVERY,
    FEWEST_NODES,
    GENERALLY,
    HIGH,
    OVERLAP,
    is_above,
    is_below,
    is_positive,
    median_interval,
    rank_correlation,
    slope,
)
from bench.papers.scene_nodes import NodeFacts, distinct_nodes
from bench.papers.turns import (
    PayloadAlone,
    Turns,
    TwoTargets,
    Variant,
    as_in_the_papers,
    take_turns,
    until_known,
)
from shadercache.caching.algorithms import USUAL
from shadercache.caching.configuration import by_every_algorithm
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.subjects import Subject, subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene

SCENES = ("dragon", "trashcan")
IN_TURNS = 5
"""Nodes that are drawn in the same turns."""

PAYLOAD, TARGETS = "payload", "two targets"
FRAMES, SECONDS = 10, 24.0
"""Of each batch: frames at least, seconds at most."""


@dataclass(frozen=True, slots=True)
class Batch:
    """Nodes that were drawn in the same turns; series are labelled ``node id, what``."""

    nodes: tuple[NodeFacts, ...]
    turns: Turns


@dataclass(frozen=True, slots=True)
class SceneTimes:
    """One scene; ``hits`` is the share of pixels that reuse a payload."""

    scene: str
    hits: float
    batches: tuple[Batch, ...]


@dataclass(frozen=True, slots=True)
class Figure8:
    """What is stored."""

    scenes: tuple[SceneTimes, ...]


@dataclass(frozen=True, slots=True)
class Point:
    """A node with its times, for rules and plots. ``ratio`` is P/T as measured."""

    facts: NodeFacts
    turns: Turns
    ratio: float

    def label(self, what: str) -> str:
        """The label of one of its series."""
        return label(self.facts, what)

    def share(self, what: str) -> float:
        """A time of it as a share of the original's."""
        return self.turns.share(self.label(what))

    def has(self, *what: str) -> bool:
        """Are there all of these series?"""
        return all(self.turns.has(self.label(one)) for one in what)

    def beats(self, first: str, second: str) -> int:
        """1 if the first is surely faster, -1 if surely slower, 0 where nothing is sure."""
        ratio = self.turns.ratio(self.label(second), self.label(first))
        return int(is_above(ratio)) - int(is_below(ratio))


def label(facts: NodeFacts, what: str) -> str:
    """Of a series."""
    return f"{facts.id}, {what}"


def points(scene: SceneTimes) -> list[Point]:
    """All nodes in ascending P/T."""
    found = [
        Point(facts, batch.turns, batch.turns.cost(label(facts, PAYLOAD)))
        for batch in scene.batches
        for facts in batch.nodes
    ]
    return sorted(found, key=lambda point: point.ratio)


Finding = tuple[bool | None, str]
"""Whether a claim holds of one scene (None: it cannot be told), and the numbers."""

Rule = Callable[[Sequence[Point], float], Finding]
"""Given the nodes of a scene in ascending P/T, and the share of hits."""


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Figure8:
    """Measure both scenes."""
    return Figure8(tuple(_scene(gpu, name, options, tell) for name in SCENES))


def _scene(gpu: Gpu, name: str, options: Options, tell: Callable[[int, int], None]) -> SceneTimes:
    scene, analysis = open_scene(data_path("corpus", name, "scene.toml"))
    linker = Linker(scene, analysis)
    chosen = options.some(distinct_nodes(scene, analysis), quick=3)
    how = until_known(FRAMES, options.seconds(SECONDS))
    batches = []
    size = (options.size, options.size)
    with RenderScene(gpu, linker.scene, size) as world:
        for start in range(0, len(chosen), IN_TURNS):
            tell(start, len(chosen))
            nodes = tuple(chosen[start : start + IN_TURNS])
            subjects = [subject for facts in nodes for subject in _subjects(linker, facts)]
            batches.append(Batch(nodes, take_turns(world, linker, subjects, how)))
        hits = overhead.hit_rate(world, linker, chosen[0].id, how.frames)
    return SceneTimes(name, hits, tuple(batches))


def _subjects(linker: Linker, facts: NodeFacts) -> Iterator[Subject]:
    kinds = by_every_algorithm(as_in_the_papers([facts.id]))
    variants = {
        subject.configuration.algorithm: subject for subject in subjects_of(linker, facts.id, kinds)
    }
    for name, subject in variants.items():
        yield Variant(label(facts, name), subject)
    yield PayloadAlone(label(facts, PAYLOAD), variants["2-pass"])
    yield TwoTargets(label(facts, TARGETS), variants["2-pass"])


def judge(data: Figure8) -> list[Verdict]:
    """T1 to T7: a claim holds if it holds on both scenes."""
    rules = {
        "T1": three_fastest,
        "T2": two_beats_one,
        "T3": worse_with_the_rest,
        "T4": overhead.insensitive,
        "T5": targets_cost_more,
        "T6": advantage_shrinks,
        "T7": outliers_overlap,
    }
    verdicts = []
    for claim, rule in rules.items():
        found = [(scene.scene, *_applied(rule, scene)) for scene in data.scenes]
        known = [holds for _, holds, _ in found if holds is not None]
        numbers = "; ".join(f"{name}: {words}" for name, _, words in found)
        verdicts.append(Verdict(claim, all(known) if known else None, numbers))
    return verdicts


def _applied(rule: Rule, scene: SceneTimes) -> Finding:
    nodes = points(scene)
    holds, words = rule(nodes, scene.hits)
    if len(nodes) < FEWEST_NODES:
        return None, f"only {len(nodes)} nodes were drawn; {words}"
    return holds, words


def three_fastest(nodes: Sequence[Point], _: float) -> Finding:
    """T1: surely slower than another for few nodes, surely the fastest for most."""
    all_three = [node for node in nodes if node.has(*USUAL)]
    if not all_three:
        return None, "no node has all three variants"
    against = [[node.beats("3-pass", name) for name in USUAL[:2]] for node in all_three]
    wins, losses = (sum(map(test, against)) for test in (_all_above, _any_below))
    count = len(all_three)
    holds = losses <= (1.0 - ALMOST_EVERY) * count and wins > 0.5 * count
    return holds, f"three passes fastest for {wins}, slower than another for {losses} of {count}"


def _all_above(signs: Sequence[int]) -> bool:
    return min(signs) > 0


def _any_below(signs: Sequence[int]) -> bool:
    return min(signs) < 0


def two_beats_one(nodes: Sequence[Point], _: float) -> Finding:
    """T2: surely faster for so many of the nodes with a high P/T."""
    high = [node for node in nodes if node.ratio >= HIGH and node.has("1-pass", "2-pass")]
    if not high:
        return None, f"no node has P/T of {HIGH} or more"
    wins = sum(node.beats("2-pass", "1-pass") > 0 for node in high)
    gain = np.median([node.share("1-pass") / node.share("2-pass") for node in high])
    words = (
        f"two passes faster for {wins} of {len(high)} nodes of P/T >= {HIGH}, median {gain:.2f}x"
    )
    return wins >= GENERALLY * len(high), words


def worse_with_the_rest(nodes: Sequence[Point], _: float) -> Finding:
    """T3: the speed-up of two passes, and the best of all, rise with P/T."""
    ratios = [node.ratio for node in nodes]
    two = rank_correlation(ratios, [1.0 / node.share("2-pass") for node in nodes])
    best = rank_correlation(ratios, [1.0 / _least(node) for node in nodes])
    words = f"rank correlation of P/T with the speed-up of two passes {two}, of the best {best}"
    return two.low > 0.0 and best.low > 0.0, words


def _least(node: Point) -> float:
    return min(node.share(name) for name in USUAL if node.has(name))


def targets_cost_more(nodes: Sequence[Point], _: float) -> Finding:
    """T5: the original with two targets is surely slower than original and geometry together."""
    more = []
    for node in nodes:
        two = np.array(node.turns.of(node.label(TARGETS)).times)
        extra = two - np.array(node.turns.original)
        # What is left over beside the geometry, as a share of the original.
        beyond = (extra - np.array(node.turns.geometry)) / node.turns.original
        more.append(is_positive(median_interval(beyond)))
    dearer, cheaper = more.count(True), more.count(False)
    targets = np.median([node.share(TARGETS) for node in nodes]) - 1.0
    bare = np.median([node.turns.bare for node in nodes])
    words = (
        f"a second target costs {targets:+.1%} of the original, the geometry {bare:.1%}; "
        f"dearer for {dearer}, cheaper for {cheaper} of {len(nodes)}"
    )
    return dearer >= ALMOST_EVERY * len(nodes), words


def advantage_shrinks(nodes: Sequence[Point], _: float) -> Finding:
    """T6: there is an advantage at low P/T, and it falls as P/T rises."""
    both = [node for node in nodes if node.has("2-pass", "3-pass")]
    advantage = [node.share("2-pass") / node.share("3-pass") for node in both]
    falls = rank_correlation([node.ratio for node in both], advantage)
    third = max(1, len(both) // 3)
    low, high = (float(np.median(part)) for part in (advantage[:third], advantage[-third:]))
    words = (
        f"two passes' time over three's: {low:.2f} in the lowest third of P/T, {high:.2f} in the "
        f"highest; rank correlation with P/T {falls}"
    )
    return falls.high < 0.0 and low > 1.0, words


def outliers_overlap(nodes: Sequence[Point], _: float) -> Finding:
    """T7: most of the nodes that lie a tenth of the original above the trend do work twice."""
    three = [node for node in nodes if node.has("3-pass")]
    ratios, times = [n.ratio for n in three], [n.share("3-pass") for n in three]
    steep = slope(ratios, times).value
    # The median: outliers, which are looked for, would lift a mean.
    level = float(np.median(np.subtract(times, np.multiply(steep, ratios))))
    above = [time - level - steep * ratio for ratio, time in zip(ratios, times, strict=True)]
    outliers = [node for node, off in zip(three, above, strict=True) if off > 0.1]
    if not outliers:
        return None, "no node lies more than a tenth of the original's time above the trend"
    twice = sum(node.facts.overlap >= OVERLAP for node in outliers)
    words = (
        f"{twice} of {len(outliers)} outliers compute at least {OVERLAP:.0%} of the shader in both "
        f"passes; of the other nodes {sum(n.facts.overlap >= OVERLAP for n in three) - twice} of "
        f"{len(three) - len(outliers)}"
    )
    return twice >= GENERALLY * len(outliers), words


def table(data: Figure8) -> str:
    """A row for each node."""
    header = ("scene", "node", "paths", "P/T", "twice", *USUAL, "widest", "expression")
    rows = format_table(header, (row for scene in data.scenes for row in _rows(scene)))
    widest = max(batch.turns.widest for scene in data.scenes for batch in scene.batches)
    return f"{rows}\nwidest interval {widest:.1%}"


def _rows(scene: SceneTimes) -> Iterator[tuple[str, ...]]:
    for node in points(scene):
        shown = (
            f"{node.turns.speedup(node.label(name)).median:.2f}x" if node.has(name) else "-"
            for name in USUAL
        )
        facts = node.facts
        yield (
            *(scene.scene, facts.id, str(facts.stands_for), f"{node.ratio:.3f}"),
            *(f"{facts.overlap:.0%}", *shown, f"{node.turns.widest:.1%}", facts.text[:40]),
        )


def draw(data: Figure8) -> dict[str, bytes]:
    """A plot for each scene."""
    return {
        f"figure8-{scene.scene}": figure8_plot.plot(scene.scene, points(scene))
        for scene in data.scenes
    }


EXPERIMENT = Experiment(
    "FIG8", "Time of every value, in ascending P/T", Figure8, gather, judge, table, draw
)

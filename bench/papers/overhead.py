"""T4: what an algorithm costs beyond the work that is left, against what a hit saves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from bench.papers.rules import LITTLE, slope
from bench.papers.turns import as_in_the_papers
from shadercache.caching.algorithms import USUAL
from shadercache.linking.linker import Linker
from shadercache.measure.measure import outcome_curves
from shadercache.measure.subjects import subjects_of
from shadercache.render.render_scene import RenderScene

if TYPE_CHECKING:
    from bench.papers.figure8 import Finding, Point


def hit_rate(world: RenderScene, linker: Linker, node: str, frames: int) -> float:
    """The mean share of hits of a node; it is the same for all nodes and algorithms (law 4)."""
    subjects = subjects_of(linker, node, [as_in_the_papers([node])])
    [curve] = outcome_curves(world, subjects, frames)
    return curve.hit_rate


def overhead(node: Point, algorithm: str, hits: float) -> float:
    """A time less what has to be computed, as a share of the original's time.

    That is the geometry, once, and the shading, less the payload where it is a hit; what both
    passes compute is not saved by a hit.
    """
    bare = node.turns.bare
    return node.share(algorithm) - bare - (1.0 - bare) * (1.0 - hits * saved(node))


def saved(node: Point) -> float:
    """What a hit does not compute, as a share of the shader."""
    return max(0.0, node.ratio - node.facts.overlap)


def insensitive(nodes: Sequence[Point], hits: float) -> Finding:
    """Three passes' overhead rises by less than a tenth of the original's time from a hit that
    saves nothing to one that saves all, and by less than the others'."""
    steep = {}
    for name in USUAL:
        have = [node for node in nodes if node.has(name)]
        steep[name] = slope([saved(n) for n in have], [overhead(n, name, hits) for n in have])
    three = steep["3-pass"].value
    flat = abs(three) < LITTLE
    least = all(abs(three) < abs(steep[name].value) for name in USUAL[:2])
    parts = ", ".join(f"{name} {interval}" for name, interval in steep.items())
    return flat and least, f"overhead over what a hit saves, both as shares of the shader: {parts}"

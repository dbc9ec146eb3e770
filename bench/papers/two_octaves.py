"""The dragon's node of two of five octaves, which several experiments draw at many periods."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace

from bench.papers.turns import as_in_the_papers
from shadercache.caching.algorithms import USUAL
from shadercache.caching.configuration import Refresh
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.subjects import VariantSubject, subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene

SCENE, NODE = "dragon", "two octaves"
"""Node 32 of Sitthi-amorn et al. 2008, figure 9; two bands of five in Scherzer et al. 2010."""


@dataclass(frozen=True, eq=False)
class Bench:
    """The scene at one size, with what compiles its variants."""

    world: RenderScene
    linker: Linker
    node: str

    def variants(self, period: int, block: int) -> list[VariantSubject]:
        """One of each algorithm; programs are shared over periods and blocks."""
        kinds = [
            replace(as_in_the_papers([self.node], name), refresh=Refresh("random", period, block))
            for name in USUAL
        ]
        return subjects_of(self.linker, NODE, kinds)


@contextmanager
def two_octaves(gpu: Gpu, size: int, color: str = "rgba8") -> Iterator[Bench]:
    """The bench, at so many pixels across; ``color`` is the format of its pictures."""
    scene, analysis = open_scene(data_path("corpus", SCENE, "scene.toml"))
    linker = Linker(scene, analysis)
    with RenderScene(gpu, linker.scene, (size, size), color) as world:
        yield Bench(world, linker, scene.nodes[NODE])


def label(algorithm: str, period: int, block: int) -> str:
    """Of a series."""
    return f"{algorithm} n{period} k{block}"


def by_period(algorithm: str, periods: Sequence[int], block: int) -> list[str]:
    """The labels of a curve."""
    return [label(algorithm, period, block) for period in periods]

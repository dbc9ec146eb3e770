"""Full-screen shaders: how fast two passes are, at which error, beside showing old frames.

``python -m bench.full_screen [--size 1024] [--period 16]`` prints a table of the shaders in
``shaders/full_screen``. *Unchanged* is what a picture is off that shows the frame of a period ago
as it was: what is gained is not gained by a scene that does not change.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.configuration import Configuration, Refresh
from shadercache.cli.tables import format_table
from shadercache.gpu.context import open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.statistics import Ratio, StopRule
from shadercache.measure.subjects import OriginalSubject, subjects_of
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene

FOLDER = Path(__file__).parent / "shaders" / "full_screen"


@dataclass(frozen=True)
class Case:
    """A shader, how values are found again in it, and what is cached."""

    file: str
    mapping: MappingKind
    node: str


CASES = (
    Case("canyon.frag", "screen", "seen(along)"),
    Case("weather.frag", "screen", "clouds(at, u_time)"),
    Case("mosaic.frag", "user", "smooth_material(p.xz, right, right.yx * away / HEIGHT)"),
)


@dataclass(frozen=True)
class Row:
    """What was measured of a case. ``unchanged`` is the error of showing old frames."""

    name: str
    original: float
    speedup: Ratio
    hits: float
    rmse: float
    unchanged: float


class OldFrames(OriginalSubject):
    """The original's frame of some frames ago, as it was then."""

    def __init__(self, ago: int, *bundles: Bundle) -> None:
        super().__init__("unchanged", *bundles)
        self._ago = ago

    def draw(self, frame: int) -> None:
        """Draw it."""
        super().draw(max(0, frame - self._ago))


def run(case: Case, size: tuple[int, int], period: int, how: MeasureOptions) -> Row:
    """Measure a case beside its original."""
    scene, analysis = open_scene(FOLDER / case.file, mapping=case.mapping)
    node = next(node for node in analysis.nodes if node.legal and node.text == case.node)
    linker = Linker(scene, analysis)
    chosen = Configuration((node.id,), "2-pass", Refresh(period=period))
    subjects = subjects_of(linker, scene.name, [chosen])
    old = OldFrames(period, *linker.originals())
    with open_context() as gpu, RenderScene(gpu, scene, size) as world:
        [group] = measure(world, linker.originals(), [*subjects, old], how).groups
    [variant] = group.nodes[0].variants
    return Row(
        scene.name,
        group.original.median,
        variant.speedup,
        variant.hit_rate,
        variant.error.rmse,
        group.others[0].error.rmse,
    )


def table(rows: Sequence[Row]) -> str:
    """All rows, as text."""
    return format_table(
        ("shader", "original ms", "two passes", "interval", "hits", "RMSE", "unchanged"),
        [
            (
                row.name,
                f"{row.original * 1e3:.1f}",
                f"{row.speedup.median:.2f}x",
                f"{row.speedup.low:.2f}-{row.speedup.high:.2f}",
                f"{row.hits:.1%}",
                f"{row.rmse:.4f}",
                f"{row.unchanged:.4f}",
            )
            for row in rows
        ],
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--period", type=int, default=16)
    parser.add_argument("--frames", type=int, default=48)
    parser.add_argument("--seconds", type=float, default=40.0)
    options = parser.parse_args()
    how = MeasureOptions(options.frames, stop=StopRule(0.03, options.seconds))
    size = (options.size, options.size)
    print(table([run(case, size, options.period, how) for case in CASES]))


if __name__ == "__main__":
    main()

"""``shadercache demo``: the main job on both corpus scenes, with pictures and a table.

It measures the costliest value of each scene, and ends as soon as the ratios are known well enough.
``--full`` measures three values for all frames and prints every column.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.caching.configuration import (
    CacheFormat,
    Configuration,
    Storage,
    by_every_algorithm,
)
from shadercache.cli.io import folder
from shadercache.cli.measuring import (
    HEADER,
    SHORT_HEADER,
    parse_size,
    result_table,
    step_progress,
    summary,
)
from shadercache.cli.scenes import choose_nodes, find_scene
from shadercache.cli.write_pictures import write_pictures
from shadercache.diagnostics import input_error

if TYPE_CHECKING:
    from shadercache.linking.linker import Linker
    from shadercache.measure.measurement import Measurement, MeasureOptions, NodeResult, Shot
    from shadercache.measure.subjects import VariantSubject
    from shadercache.report.contact_sheet import SheetRow
    from shadercache.scene.description import Demo, Scene

SCENES = ("dragon", "trashcan")
HALF_WIDTH, SECONDS = 0.03, 30.0
"""The short demo ends a scene when its ratios are known to 3 %, or after so long."""


def command(
    full: Annotated[
        bool, typer.Option("--full", help="Three values of each scene, all frames, every column.")
    ] = False,
    size: Annotated[str, typer.Option(metavar="W[xH]", help="Picture size.")] = "1024",
    frames: Annotated[int, typer.Option(min=2, help="Frames of each run, at most.")] = 64,
    cache_format: Annotated[
        CacheFormat, typer.Option("--format", help="Texel format of the cache.")
    ] = "rgba16f",
    mesh: Annotated[
        Path | None, typer.Option(metavar="FILE", help="A mesh (.npz) for the dragon's scene.")
    ] = None,
    out: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="DIR", parser=folder, help="Folder for results."),
    ] = Path("out/demo"),
) -> None:
    """Rewrite both scenes' shaders, run every variant beside the original, print the table.

    Writes, for each scene, a contact sheet and the raw numbers; with --full all pictures as well.
    """
    from shadercache.gpu.context import open_context
    from shadercache.measure.measure import measure
    from shadercache.measure.result_files import environment, to_json, write_json
    from shadercache.render.render_scene import RenderScene
    from shadercache.scene.description import load_scene
    from shadercache.scene.mesh import load_mesh

    extent = parse_size(size)
    dragon = load_mesh(mesh) if mesh else None
    with open_context() as gpu:
        for name in SCENES:
            scene = load_scene(find_scene(name))
            if scene.demo is None:
                raise input_error("SC508", f"{scene.path} has no [demo]")
            how = _options(frames, full)
            labels = scene.demo.nodes if full else scene.demo.nodes[-1:]
            replaced = dragon if name == "dragon" else None
            linker, subjects = _subjects(scene, scene.demo, labels, cache_format)
            with (
                RenderScene(gpu, linker.scene, extent, mesh=replaced) as world,
                step_progress(f"measuring {scene.name}") as tell,
            ):
                found = measure(world, linker.originals(), subjects, how, tell)
            write_json(out / f"{name}.json", to_json(found, environment(gpu)))
            _write_pictures(out, scene, found, full)
            print(f"{scene.title}\nthe picture: {out / name}.png")
            print(f"{summary(found)}\ncache {cache_format}; {_precision(found)}\n")
            columns = HEADER if full else SHORT_HEADER
            print(result_table(found, lambda node: node.label, columns) + "\n", flush=True)


def _options(frames: int, full: bool) -> MeasureOptions:
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.measure.stopping import StopRule

    how = MeasureOptions(frames, curves=0)
    if full:
        return replace(how, picture_frame=frames - 1)
    stop = StopRule(HALF_WIDTH, SECONDS)
    return replace(how, picture_frame=how.first_compared, stop=stop)


def _subjects(
    scene: Scene, demo: Demo, labels: Sequence[str], cache_format: CacheFormat
) -> tuple[Linker, list[VariantSubject]]:
    """Every variant of the values with these names."""
    from shadercache.linking.linker import Linker
    from shadercache.linking.scene_shaders import analyse_scene
    from shadercache.measure.subjects import subjects_of

    linker = Linker(*analyse_scene(scene))
    base = Configuration(storage=Storage(cache_format)).with_refresh(demo.period, demo.block)
    subjects = []
    for label, nodes in choose_nodes(scene, linker.analysis, labels):
        chosen = replace(base, nodes=tuple(item.id for item in nodes))
        subjects += subjects_of(linker, label, by_every_algorithm(chosen))
    return linker, subjects


def _precision(found: Measurement) -> str:
    from shadercache.measure.stopping import widest

    ratios = (variant.speedup for node in found.nodes for variant in node.variants)
    return f"every ratio to within {widest(ratios):.1%} (95 % interval)"


def _write_pictures(out: Path, scene: Scene, found: Measurement, full: bool) -> None:
    """A sheet with the fastest variant of each node; if ``full`` all pictures of all variants."""
    from shadercache.report.contact_sheet import contact_sheet
    from shadercache.report.images import write_png

    if full:
        for shot in found.shots:
            write_pictures(out / scene.name, shot, ["all"])
    shots = {(shot.label, shot.configuration.algorithm): shot for shot in found.shots}
    rows = [_sheet_row(node, shots) for node in found.nodes]
    write_png(out / f"{scene.name}.png", contact_sheet(scene.title, rows))


def _sheet_row(node: NodeResult, shots: dict[tuple[str, str], Shot]) -> SheetRow:
    from shadercache.report.contact_sheet import SheetRow

    best = max(node.variants, key=lambda variant: variant.speedup.median)
    caption = (
        f"P/T {node.ratio or 0.0:.2f}, {best.timing.median * 1e3:.1f} ms, "
        f"{best.speedup.median:.2f}x the original's speed "
        f"({best.speedup.low:.2f}-{best.speedup.high:.2f}), hits {best.hit_rate:.1%}, "
        f"RMSE {best.error.rmse:.4f}, PSNR {best.error.psnr:.1f} dB"
    )
    algorithm = best.configuration.algorithm
    heading = f"{node.label}, {algorithm}: {node.text}"
    return SheetRow(shots[node.label, algorithm], heading, caption)

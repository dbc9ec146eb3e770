"""``shadercache demo``: the main job on both corpus scenes, with pictures and a table."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.cli.io import folder
from shadercache.cli.measuring import parse_size, result_table, step_progress, summary
from shadercache.cli.scenes import choose_nodes, find_scene
from shadercache.cli.write_pictures import write_pictures
from shadercache.diagnostics import input_error
from shadercache.options import CacheFormat, Options

if TYPE_CHECKING:
    from shadercache.gpu.context import Gpu
    from shadercache.measure.measurement import Measurement, NodeResult, Shot
    from shadercache.report.contact_sheet import SheetRow
    from shadercache.scene.description import Scene

SCENES = ("dragon", "trashcan")


def command(
    size: Annotated[str, typer.Option(metavar="W[xH]", help="Picture size.")] = "1024",
    frames: Annotated[int, typer.Option(min=2, help="Frames of each run.")] = 64,
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
    """Rewrite both scenes' shaders at three nodes each, run every variant beside the original.

    Prints the table and writes, for each scene, the pictures, a contact sheet and the raw numbers.
    """
    from shadercache.gpu.context import open_context
    from shadercache.measure.result_files import environment, to_json, write_json
    from shadercache.scene.description import load_scene

    extent = parse_size(size)
    with open_context() as gpu:
        for name in SCENES:
            scene = load_scene(find_scene(name))
            found = _measure(
                gpu, scene, extent, frames, cache_format, mesh if name == "dragon" else None
            )
            print(f"{scene.title}\n{summary(found)}; cache {cache_format}\n")
            print(result_table(found, lambda node: node.label) + "\n", flush=True)
            write_json(out / f"{name}.json", to_json(found, environment(gpu)))
            _write_pictures(out, scene, found)
            print(f"pictures and {out / name}.png written", file=sys.stderr)


def _measure(
    gpu: Gpu,
    scene: Scene,
    extent: tuple[int, int],
    frames: int,
    cache_format: CacheFormat,
    mesh: Path | None,
) -> Measurement:
    from shadercache.linking.scene_shaders import analyse_scene
    from shadercache.measure.entries import make_entry
    from shadercache.measure.measure import measure
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.scene.mesh import load_mesh

    demo = scene.demo
    if demo is None:
        raise input_error("SC508", f"{scene.path} has no [demo]")
    scene, analysis = analyse_scene(scene)
    options = Options(cache_format=cache_format)
    entries = [
        make_entry(analysis, label, node, options)
        for label, node in choose_nodes(scene, analysis, demo.nodes)
    ]
    how = MeasureOptions(
        extent,
        frames,
        period=demo.period,
        block=demo.block,
        picture_frame=frames - 1,
        curves=0,
    )
    with step_progress(f"measuring {scene.name}") as tell:
        return measure(gpu, scene, entries, how, tell, load_mesh(mesh) if mesh else None)


def _write_pictures(out: Path, scene: Scene, found: Measurement) -> None:
    """All pictures of all variants, and a sheet with the fastest variant of each node."""
    from shadercache.report.contact_sheet import contact_sheet
    from shadercache.report.images import write_png

    for shot in found.shots:
        write_pictures(out / scene.name, shot, ["all"])
    shots = {(shot.label, shot.algorithm): shot for shot in found.shots}
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
    heading = f"{node.label}, {best.algorithm}: {node.text}"
    return SheetRow(shots[node.label, best.algorithm], heading, caption)

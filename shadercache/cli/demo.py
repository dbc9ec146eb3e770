"""``shadercache demo``: the main job on both corpus scenes, with pictures and a table.

It measures the costliest value of each scene, until the ratios are known well enough. ``--full``
measures three values over more frames and prints every column.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.caching import configuration as cached
from shadercache.cli import options
from shadercache.cli.measuring import FEW_FIGURES, FIGURES, measured, result_table, summary
from shadercache.cli.scenes import choose_nodes, find_scene
from shadercache.diagnostics import input_error

if TYPE_CHECKING:
    from shadercache.linking.linker import Linker
    from shadercache.measure.measurement import Measurement, MeasureOptions
    from shadercache.measure.subjects import VariantSubject
    from shadercache.scene.description import Scene

SCENES = ("dragon", "trashcan")
FRAMES, FULL_FRAMES = 40, 64
"""The short demo compares the last eight images, which are as wrong as those of more frames."""


@dataclass(frozen=True, kw_only=True)
class DemoPictures(options.PictureOptions):
    """As for other commands, but a mesh replaces that of one scene only."""

    mesh: Annotated[
        Path | None, typer.Option(metavar="FILE", help="A mesh (.npz) for the dragon's scene.")
    ] = None


@dataclass(frozen=True, kw_only=True)
class Effort:
    """How much is measured."""

    full: Annotated[
        bool, typer.Option("--full", help="Three values of each scene, 64 frames, every column.")
    ] = False
    frames: Annotated[
        int | None,
        typer.Option(
            min=2,
            help=f"Frames of each run. [default: {FRAMES}, and again until ratios are known to "
            f"3 %, at most 30 s; {FULL_FRAMES} with --full]",
        ),
    ] = None

    @property
    def how(self) -> MeasureOptions:
        from shadercache.measure.measurement import MeasureOptions
        from shadercache.measure.statistics import StopRule

        how = MeasureOptions(self.frames or (FULL_FRAMES if self.full else FRAMES), curves=0)
        return replace(how, picture_frame=how.frames - 1, stop=None if self.full else StopRule())


WHOLE, PICTURES = Effort(), DemoPictures()


def command(
    effort: Effort = WHOLE,
    drawn: DemoPictures = PICTURES,
    cache_format: options.FormatOption = "rgba16f",
    out: Annotated[Path, options.output("Folder for results.")] = Path("out/demo"),
) -> None:
    """Rewrite both scenes' shaders, run every variant beside the original, print the table.

    Writes, for each scene, a contact sheet and the raw numbers; with --full all pictures as well.
    """
    from shadercache.measure.result_files import to_json, write_json

    for name in SCENES:
        linker, subjects = _subjects(name, effort.full, cache_format)
        scene = linker.scene
        shown = drawn if name == "dragon" else replace(drawn, mesh=None)
        results, where = measured(linker, subjects, effort.how, shown, f"measuring {scene.name}")
        write_json(out / f"{name}.json", to_json(results, where))
        _write_pictures(out, scene, results, effort.full)
        print(f"{scene.title}\nthe picture: {out / name}.png")
        print(f"{summary(results)}\ncache {cache_format}\n")
        figures = FIGURES if effort.full else FEW_FIGURES
        print(result_table(results, lambda node: node.label, figures) + "\n", flush=True)


def _subjects(
    name: str, full: bool, cache_format: cached.CacheFormat
) -> tuple[Linker, list[VariantSubject]]:
    """Every variant of the values that a scene's ``[demo]`` names, or of the last of them."""
    from shadercache.linking.linker import Linker
    from shadercache.linking.scene_shaders import open_scene
    from shadercache.measure.subjects import subjects_of

    scene, analysis = open_scene(find_scene(name))
    if scene.demo is None:
        raise input_error("SC508", f"{scene.path} has no [demo]")
    linker, subjects = Linker(scene, analysis), []
    base = cached.Configuration(storage=cached.Storage(cache_format))
    base = base.with_refresh(scene.demo.period, scene.demo.block)
    # The costliest stands last.
    labels = scene.demo.nodes if full else scene.demo.nodes[-1:]
    for payload in choose_nodes(scene, analysis, labels):
        chosen = cached.by_every_algorithm(replace(base, nodes=payload.ids))
        subjects += subjects_of(linker, payload.label, chosen)
    return linker, subjects


def _write_pictures(out: Path, scene: Scene, results: Measurement, full: bool) -> None:
    """A sheet with the fastest variant of each node; if ``full`` all pictures of all variants."""
    from shadercache.report.contact_sheet import SheetRow, contact_sheet
    from shadercache.report.images import write_png
    from shadercache.report.variant_pictures import write_pictures

    if full:
        for shot in results.shots:
            write_pictures(out / scene.name, shot, ["all"])
    shots = {(shot.label, shot.configuration.algorithm): shot for shot in results.shots}
    rows = []
    for node in results.nodes:
        best = max(node.variants, key=lambda variant: variant.speedup.median)
        algorithm = best.configuration.algorithm
        caption = (
            f"P/T {node.ratio or 0.0:.2f}, {best.timing.median * 1e3:.1f} ms, "
            f"{best.speedup.median:.2f}x the original's speed "
            f"({best.speedup.low:.2f}-{best.speedup.high:.2f}), hits {best.hit_rate:.1%}, "
            f"RMSE {best.error.rmse:.4f}, PSNR {best.error.psnr:.1f} dB"
        )
        heading = f"{node.label}, {algorithm}: {node.text}"
        rows.append(SheetRow(shots[node.label, algorithm], heading, caption))
    write_png(out / f"{scene.name}.png", contact_sheet(scene.title, rows))

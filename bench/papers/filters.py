"""FILTERS: what repeated resampling blurs, by filter (N9).

The fine detail of a picture is what a 3 x 3 mean takes away; blur is the share of the original's
energy in it that is missing after some frames of motion without refresh. On the dragon, whose whole
noise is cached.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from bench.jitter import Image, fine
from bench.papers.claims import Verdict
from bench.papers.drawing import PALETTE, panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.turns import as_in_the_papers
from shadercache.caching.configuration import Filter, FilterKind, Refresh
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.pass_runners import CoverageRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner

KINDS: tuple[FilterKind, ...] = ("bilinear", "lanczos2", "mitchell")
LESS = 1.0 / 3.0
"""How much less the higher orders have to blur, as a share of what bilinear weights do."""

RESAMPLED = 8
"""So many frames after a reset."""


@dataclass(frozen=True, slots=True)
class Blurs:
    """What is stored, in the order of the filters: shares of the fine detail, and RMSE."""

    filters: tuple[str, ...]
    blurs: tuple[float, ...]
    errors: tuple[float, ...]


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Blurs:
    """Resample with each filter, and compare the last frame; nothing is timed."""
    scene, analysis = open_scene(data_path("corpus", "dragon", "scene.toml"))
    linker = Linker(scene, analysis)
    # A refresh would bring back the detail whose loss is looked for.
    chosen = replace(as_in_the_papers([scene.nodes["whole noise"]]), refresh=Refresh("none"))
    found = []
    with RenderScene(gpu, linker.scene, (options.size, options.size), "rgba32f") as world:
        with CoverageRunner(world, *linker.originals()) as cover:
            covered = cover.coverage(RESAMPLED)
        [truth] = _colors(*render_original(world, linker.originals(), [RESAMPLED]))
        for number, kind in enumerate(KINDS):
            tell(number, len(KINDS))
            linked = linker.link(linker.assign(replace(chosen, filter=Filter(kind))))
            with VariantRunner(world, *linked) as runner:
                images = _colors(*(runner.image(frame) for frame in range(RESAMPLED + 1)))
            found.append(_blur(truth, images[-1], covered))
    blurs, errors = zip(*found, strict=True)
    return Blurs(KINDS, blurs, errors)


def _colors(*images: NDArray[np.float32]) -> list[Image]:
    """Without alpha."""
    return [image[..., :3].astype(np.float64) for image in images]


def _blur(truth: Image, image: Image, covered: NDArray[np.bool_]) -> tuple[float, float]:
    """The share of the energy of fine detail that is missing, and the RMSE."""
    inner = covered[1:-1, 1:-1]
    whole, kept = (float((fine(of)[inner] ** 2).sum()) for of in (truth, image))
    off = (image - truth)[covered]
    return 1.0 - kept / whole, float(np.sqrt(np.mean(off * off)))


def judge(data: Blurs) -> list[Verdict]:
    """N9: each filter of a higher order blurs so much less."""
    blurs = dict(zip(data.filters, data.blurs, strict=True))
    bilinear = blurs.pop("bilinear")
    if bilinear <= 0.0:
        return [Verdict("N9", None, "bilinear look-ups blur nothing here")]
    less = {kind: 1.0 - blur / bilinear for kind, blur in blurs.items()}
    each = ", ".join(f"{kind} {share:.0%} less" for kind, share in less.items())
    lost = f"bilinear look-ups lose {bilinear:.1%} of the fine detail in {RESAMPLED} frames"
    return [Verdict("N9", min(less.values()) >= LESS, f"{lost}; {each}")]


def table(data: Blurs) -> str:
    """A row for each filter."""
    rows = [
        (kind, f"{blur:.1%}", f"{error:.4f}")
        for kind, blur, error in zip(data.filters, data.blurs, data.errors, strict=True)
    ]
    return format_table(("filter", "detail lost", "RMSE"), rows)


def draw(data: Blurs) -> dict[str, bytes]:
    """Bars of blur and of error."""
    figure, (blur, error) = panels(1, 2, (8.0, 4.0))
    for axes, values, words in (
        (blur, [100.0 * each for each in data.blurs], "fine detail lost (%)"),
        (error, data.errors, "RMSE over covered pixels (0-1)"),
    ):
        axes.bar(data.filters, values, color=PALETTE[: len(data.filters)])
        axes.set_ylabel(words)
        axes.set_ylim(min(0.0, *values), 1.1 * max(values))
    blur.set_title(
        f"dragon, whole noise, {RESAMPLED} frames without refresh", loc="left", fontsize=11
    )
    return {"filters": png(figure)}


EXPERIMENT = Experiment(
    "FILTERS", "Blur by the filter of look-ups", Blurs, gather, judge, table, draw
)

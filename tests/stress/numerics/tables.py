"""What the cache's options gain and cost: the tables of docs/lab/reuse.md.

``python -m tests.stress.numerics.tables filters`` (or ``guards``, ``tolerances``, ``depths``). Hits
and stale hits are judged by law 5's ground truth, the error is that of a scene's own node beside
the original, and the time is the CPU's, frame against frame in one process, so that other work on
the machine changes little.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.description import Scene
from tests.configured import DEFAULT, configured, rewritten, variant

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # as pytest has it

from laws.ground_truth import body_mesh, body_scene, true_frames
from laws.look_ups import LawFive

TRUE_SIZE = (256, 256)
TRUE_FRAMES = 13
PERIOD, BLOCK = 32, 4
SCENES = {"dragon": "whole noise", "trashcan": "24 of 25 samples"}

ROWS: Mapping[str, Sequence[str]] = {
    "filters": (
        "filter=bilinear",
        "filter=nearest",
        "filter=bilinear,fallback",
        "filter=bilateral",
        "filter=lanczos2",
        "filter=mitchell",
        "filter=lanczos2,fallback",
        "magnification",
    ),
    "guards": ("guard=off", "guard=miss", "guard=clamp"),
    "tolerances": ("tolerance=relative", "tolerance=akeley-su", "tolerance=fixed"),
    "depths": ("depth=inverse-w", "depth=linear", "depth=ndc"),
}
"""The options that are compared, the first of a table with the others."""


@dataclass(frozen=True)
class Soundness:
    """Hits as a share of what is covered, and stale hits as a share of hits, of two runs."""

    hit_rate: float
    stale: float
    carried_rate: float
    carried_stale: float


def soundness(
    gpu: Gpu, name: str, degrees: float, form: CacheFormat, options: Sequence[Configuration]
) -> list[Soundness]:
    """Each look-up by itself, and runs of period 32 that go on from their own cache."""
    with RenderScene(
        gpu, body_scene(name, degrees), TRUE_SIZE, "rgba32f", body_mesh(name)
    ) as world:
        truth = true_frames(world, range(TRUE_FRAMES))
        found: list[Soundness] = []
        for cached in options:
            runs = [
                LawFive(world, truth, form, PERIOD, carried, cached=cached).findings()
                for carried in (False, True)
            ]
            shares = [
                share
                for run in runs
                for share in (run.hits / run.covered, len(run.stale) / max(run.hits, 1))
            ]
            found.append(Soundness(*shares))
        return found


def open_node(name: str) -> tuple[Scene, Analysis, str]:
    """A corpus scene, its shader, and the id of a telling node."""
    scene, analysis = open_scene(data_path("corpus", name, "scene.toml"))
    return scene, analysis, scene.nodes[SCENES[name]]


def bundle(analysis: Analysis, node: str, form: CacheFormat, cached: Configuration) -> Bundle:
    """The variants of a node."""
    chosen = next(item for item in analysis.nodes if item.id == node)
    emission = rewritten(analysis, chosen, configured(cached, form=form))
    return Bundle(emission.manifest, emission.files)


def errors(
    gpu: Gpu, name: str, form: CacheFormat, options: Sequence[Configuration], frames: int = 33
) -> list[float]:
    """Root of the mean square error beside the original, of the last frames of a run."""
    scene, analysis, node = open_node(name)
    with RenderScene(gpu, scene, TRUE_SIZE, "rgba32f") as world:
        bundles = [bundle(analysis, node, form, cached) for cached in options]
        with OriginalRunner(world, bundles[0]) as original:
            true = {at: original.image(at).copy() for at in range(frames - 8, frames)}
        found: list[float] = []
        for made in bundles:
            with variant(world, made, "2-pass", period=PERIOD, block=BLOCK) as runner:
                squares = []
                for at in range(frames):
                    image = runner.image(at)
                    if at in true:
                        squares.append(((image - true[at])[..., :3] ** 2).mean())
            found.append(float(np.sqrt(np.mean(squares))))
        return found


def seconds(
    gpu: Gpu,
    name: str,
    form: CacheFormat,
    options: Sequence[Configuration],
    algorithm: str = "2-pass",
    size: int = 512,
    frames: int = 40,
) -> list[float]:
    """CPU time of each frame relative to the first of the options, in the median."""
    scene, analysis, node = open_node(name)
    with ExitStack() as stack:
        world = stack.enter_context(RenderScene(gpu, scene, (size, size)))
        runners = [
            stack.enter_context(
                variant(
                    world,
                    bundle(analysis, node, form, cached),
                    algorithm,
                    period=PERIOD,
                    block=BLOCK,
                )
            )
            for cached in options
        ]
        times = np.array([[_timed(gpu, runner, at) for runner in runners] for at in range(frames)])
        ratios: list[float] = list(np.median(times[8:] / times[8:, :1], axis=0))
        return ratios


def _timed(gpu: Gpu, runner: VariantRunner, frame: int) -> float:
    gpu.ctx.finish()
    start = time.process_time()
    runner.draw(frame)
    gpu.ctx.finish()
    return time.process_time() - start


def lines(gpu: Gpu, table: str, form: CacheFormat, scenes: Sequence[str]) -> Iterator[str]:
    """The rows of a table, in Markdown."""
    words = ROWS[table]
    options = [with_settings(DEFAULT, [text]) for text in words]
    yield "| scene | options | hits | stale | hits, 32 | stale, 32 | RMSE | time, 2 | time, 3 |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for name in scenes:
        sound = soundness(gpu, name, 1.0, form, options)
        error = errors(gpu, name, form, options)
        two = seconds(gpu, name, form, options)
        three = seconds(gpu, name, form, options, "3-pass")
        for row in zip(words, sound, error, two, three, strict=True):
            text, found, rmse, second, third = row
            yield (
                f"| {name} | `{text}` | {found.hit_rate:.4f} | {found.stale:.1e} "
                f"| {found.carried_rate:.4f} | {found.carried_stale:.1e} | {rmse:.5f} "
                f"| {second:.3f} | {third:.3f} |"
            )


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("table", choices=sorted(ROWS))
    parser.add_argument("--format", choices=("rgba16f", "rgba32f"), default="rgba16f")
    parser.add_argument("--scene", choices=sorted(SCENES), action="append")
    chosen = parser.parse_args(arguments)
    with open_context() as gpu:
        for line in lines(gpu, chosen.table, chosen.format, chosen.scene or sorted(SCENES)):
            print(line, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Refresh schedules and the guard of ages, measured: ``python -m bench.refresh``.

Three tables: how even the frames are, how old payloads get under constant motion, and what both
cost and save on corpus scenes. ``docs/NUMERICS.md`` has them with what follows.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from time import process_time

import numpy as np

from bench.pan import ages, pan
from shadercache.cli.tables import format_table
from shadercache.compiler import rewrite
from shadercache.gpu.clock import no_collection
from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.options import CacheOptions, Options, RefreshSchedule
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import OriginalRunner, RunOptions, VariantRunner
from shadercache.scene.description import load_scene

SCHEDULES: tuple[RefreshSchedule, ...] = ("stratified", "random", "tiled", "surface", "none")
ON_SCREEN: tuple[RefreshSchedule, ...] = ("stratified", "random", "tiled")
SIZES = ((128, 128), (256, 256), (500, 350), (1024, 1024))
PERIODS = (4, 7, 16, 32, 64)
VELOCITIES = (
    *((0.0, 0.0), (0.1, 0.03), (0.5, 0.2), (0.5, 0.5), (1.0, 0.0), (0.0, -1.0), (1.7, 0.9)),
    *((2.0, 0.0), (4.0, 0.0), (0.0, 4.0), (4.0, 4.0), (6.3, 2.1), (8.0, 0.0)),
)


def evenness(gpu: Gpu) -> Iterator[tuple[str, ...]]:
    """The most blocks that a frame of a period refreshes, as a share of an even one."""
    for schedule in ON_SCREEN:
        for size in SIZES:
            shares = []
            for period in PERIODS:
                how = RunOptions(period=period)
                with pan(gpu, (0.0, 0.0), CacheOptions(refresh=schedule), how, size) as runner:
                    due = runner.bundle.mask_values["refresh"]
                    runner.draw(0)
                    counts = [
                        int((runner.hit_mask(clock)[::4, ::4] == due).sum())
                        for clock in range(period)
                    ]
                shares.append(max(counts) * period / sum(counts))
            yield schedule, f"{size[0]} x {size[1]}", *(f"{share:.3f}" for share in shares)


def growing_old(gpu: Gpu, period: int, frames: int) -> Iterator[tuple[str, ...]]:
    """Mean and greatest age, and what is refreshed, at each velocity and over all."""
    for guarded in (False, True):
        for schedule in (*ON_SCREEN, *(("none",) if guarded else ())):
            cache = CacheOptions(refresh=schedule, age=guarded)
            rows = []
            for velocity in VELOCITIES:
                with pan(gpu, velocity, cache, RunOptions(period=period), (192, 192)) as runner:
                    found = ages(runner, frames)
                share = float(np.mean(found.refreshed)) * period / (1.0 - found.missed)
                burst = max(found.refreshed) * period
                rows.append((found.mean, found.worst, found.over, share, burst))
                yield _row(schedule, guarded, str(velocity), *rows[-1])
            mean, _, over, share, _ = np.mean(rows, axis=0)
            _, worst, _, _, burst = np.max(rows, axis=0)
            yield _row(schedule, guarded, "all", mean, worst, over, share, burst)


def _row(schedule: str, guarded: bool, velocity: str, *values: float) -> tuple[str, ...]:
    mean, worst, over, share, burst = values
    numbers = f"{mean:.1f}", f"{worst:.0f}", f"{over:.1%}", f"{share:.2f}", f"{burst:.2f}"
    return schedule, "on" if guarded else "off", velocity, *numbers


def on_scenes(gpu: Gpu, size: int, frames: int) -> Iterator[tuple[str, ...]]:
    """Processor time against the random schedule's, what is refreshed, and the error, in turns."""
    for name in ("dragon", "trashcan"):
        scene, analysis = analyse_scene(load_scene(data_path("corpus", name)))
        assert scene.demo is not None
        label = scene.demo.nodes[-1]
        node = analysis.nodes_of(scene.nodes.get(label, label))
        chosen = [CacheOptions(refresh=s) for s in SCHEDULES]
        chosen += [CacheOptions(refresh=s, age=True) for s in ("stratified", "random", "none")]
        with RenderScene(gpu, scene, (size, size)) as world:
            bundles = []
            for cache in chosen:
                found = rewrite(analysis, node, Options(cache=cache), (2,), unprofitable=True)
                bundles.append(Bundle(found.manifest, found.files))
            runs = [VariantRunner(world, bundle, "2-pass", RunOptions(32)) for bundle in bundles]
            with OriginalRunner(world, bundles[0]) as original:
                table = _drawn(gpu, runs, original, frames)
            for runner in runs:
                runner.release()
        for cache, row in zip(chosen, table, strict=True):
            guard = "on" if cache.age else "off"
            yield name, cache.refresh, guard, *row


def _drawn(
    gpu: Gpu, runs: Sequence[VariantRunner], original: OriginalRunner, frames: int
) -> list[tuple[str, ...]]:
    times: list[list[float]] = [[] for _ in runs]
    shares: list[list[float]] = [[] for _ in runs]
    hits: list[list[float]] = [[] for _ in runs]
    errors: list[list[float]] = [[] for _ in runs]
    with no_collection():
        for frame in range(frames):
            image = original.image(frame)[..., :3].astype(np.float64)
            covered = original.image(frame)[..., 3] > 0.0
            for place, runner in enumerate(runs):
                if frame >= frames // 2:
                    mask = runner.hit_mask(frame)
                    values = runner.bundle.mask_values
                    due = [values[word] for word in ("refresh", "old") if word in values]
                    shares[place].append(float(np.isin(mask[mask > 0], due).mean()))
                    hits[place].append(float((mask[mask > 0] == values["hit"]).mean()))
                times[place].append(_processor_time(gpu, partial(runner.draw, frame)))
                off = runner.world.targets.image()[..., :3] - image
                errors[place].append(float((off[covered] ** 2).mean()))
    base = np.array(times[SCHEDULES.index("random")][2:])
    return [
        (
            f"{np.median(np.array(times[i][2:]) / base):.3f}",
            f"{np.mean(hits[i]):.4f}",
            f"{32 * np.mean(shares[i]):.3f}",
            f"{32 * max(shares[i]):.3f}",
            f"{np.sqrt(np.mean(errors[i][frames // 2 :])):.4f}",
        )
        for i in range(len(runs))
    ]


def _processor_time(gpu: Gpu, draw: Callable[[], None]) -> float:
    """Seconds of all cores: on a renderer that runs on them no other work disturbs that."""
    gpu.ctx.finish()
    start = process_time()
    draw()
    gpu.ctx.finish()
    return process_time() - start


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(prog="python -m bench.refresh", description=__doc__)
    parser.add_argument("tables", nargs="*", default=["even", "old", "scenes"])
    parser.add_argument("--period", type=int, default=32)
    parser.add_argument("--frames", type=int, default=320, help="of each run under motion")
    parser.add_argument("--size", type=int, default=512, help="of the scenes")
    options = parser.parse_args()
    with open_context() as gpu:
        if "even" in options.tables:
            header = ("schedule", "picture", *(f"period {n}" for n in PERIODS))
            print(format_table(header, evenness(gpu)), flush=True)
        if "old" in options.tables:
            header = (
                "schedule",
                "guard",
                "velocity",
                "mean age",
                "oldest",
                "over",
                "share",
                "worst",
            )
            print(
                format_table(header, growing_old(gpu, options.period, options.frames)), flush=True
            )
        if "scenes" in options.tables:
            header = ("scene", "schedule", "guard", "time", "hits", "share", "worst", "RMSE")
            print(format_table(header, on_scenes(gpu, options.size, 96)), flush=True)


if __name__ == "__main__":
    main()

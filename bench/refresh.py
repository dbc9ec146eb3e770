"""Refresh schedules and the guard of ages, measured: ``python -m bench.refresh``.

Three tables: how even the frames are, how old payloads get under constant motion, and what both
cost and save on corpus scenes. ``docs/lab/refresh.md`` has them with what follows.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence

import numpy as np

from bench.pan import ages, pan
from shadercache.caching.configuration import Configuration, Refresh, RefreshSchedule
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions, VariantResult
from shadercache.measure.statistics import paired_ratio
from shadercache.measure.subjects import subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
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
                chosen = Configuration(refresh=Refresh(schedule, period))
                with pan(gpu, (0.0, 0.0), chosen, size) as runner:
                    due = runner.bundle.mask_values["refresh"]
                    runner.draw(0)
                    # One pixel of each block, whose edge is 4 by default.
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
            chosen = Configuration(refresh=Refresh(schedule, period, age=guarded))
            rows = []
            for velocity in VELOCITIES:
                with pan(gpu, velocity, chosen, (192, 192)) as runner:
                    run = ages(runner, frames)
                share = float(np.mean(run.refreshed)) * period / (1.0 - run.missed)
                burst = max(run.refreshed) * period
                rows.append((run.mean, run.worst, run.over, share, burst))
                yield _row(schedule, guarded, str(velocity), *rows[-1])
            mean, _, over, share, _ = np.mean(rows, axis=0)
            _, worst, _, _, burst = np.max(rows, axis=0)
            yield _row(schedule, guarded, "all", mean, worst, over, share, burst)


def _row(schedule: str, guarded: bool, velocity: str, *values: float) -> tuple[str, ...]:
    mean, worst, over, share, burst = values
    numbers = f"{mean:.1f}", f"{worst:.0f}", f"{over:.1%}", f"{share:.2f}", f"{burst:.2f}"
    return schedule, "on" if guarded else "off", velocity, *numbers


def on_scenes(gpu: Gpu, size: int, frames: int) -> Iterator[tuple[str, ...]]:
    """Time against the random schedule's, what is refreshed, and the error, in turns."""
    chosen = [Refresh(schedule) for schedule in SCHEDULES]
    chosen += [Refresh(schedule, age=True) for schedule in ("stratified", "random", "none")]
    for name in ("dragon", "trashcan"):
        scene, analysis = analyse_scene(load_scene(data_path("corpus", name)))
        assert scene.demo is not None
        label = scene.demo.nodes[-1]
        node = scene.nodes.get(label, label)
        linker = Linker(scene, analysis)
        originals = linker.originals()
        nodes = tuple(node.split("+"))
        subjects = [
            subject
            for refresh in chosen
            for subject in subjects_of(
                linker, str(refresh), [Configuration(nodes, refresh=refresh)]
            )
        ]
        # All in the same turns: their times are compared with one another, not with the original's.
        how = MeasureOptions(frames, frames // 2, probe_every=1, group=len(subjects), curves=0)
        with RenderScene(gpu, linker.scene, (size, size)) as world:
            variants = [node.variants[0] for node in measure(world, originals, subjects, how).nodes]
        base = variants[chosen.index(Refresh("random"))].timing.samples
        for refresh, variant in zip(chosen, variants, strict=True):
            yield name, refresh.schedule, "on" if refresh.age else "off", *_numbers(variant, base)


def _numbers(variant: VariantResult, base: Sequence[float]) -> tuple[str, ...]:
    period = variant.configuration.refresh.period
    share = variant.outcomes["refresh"] + variant.outcomes.get("old", 0.0)
    return (
        f"{1.0 / paired_ratio(base, variant.timing.samples).median:.3f}",
        f"{variant.hit_rate:.4f}",
        f"{period * share:.3f}",
        f"{period * variant.burst:.3f}",
        f"{variant.error.rmse:.4f}",
    )


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
            rows = growing_old(gpu, options.period, options.frames)
            print(format_table(header, rows), flush=True)
        if "scenes" in options.tables:
            header = ("scene", "schedule", "guard", "time", "hits", "share", "worst", "RMSE")
            print(format_table(header, on_scenes(gpu, options.size, 96)), flush=True)


if __name__ == "__main__":
    main()

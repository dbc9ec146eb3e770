"""What leaving out idle passes saves: a scene at rest, nothing refreshed on purpose.

``python -m bench.idle [--scene dragon] [--size 512]``: two runs of each algorithm take turns, and
one of them draws all of its passes.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from functools import partial

from shadercache.gpu.clock import no_collection, pick_clock
from shadercache.gpu.context import open_context
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.entries import make_entry
from shadercache.measure.statistics import paired_ratio
from shadercache.options import Options, read_cache_options
from shadercache.paths import data_path
from shadercache.render.empty_passes import EmptyPasses
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import RunOptions, VariantRunner

FRAMES, SETTLED = 28, 4


def main() -> None:
    """Print the ratio for each algorithm."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scene", default="dragon")
    parser.add_argument("--node", default="whole noise")
    parser.add_argument("--size", type=int, default=512)
    given = parser.parse_args()
    scene, analysis = open_scene(data_path("corpus", given.scene, "scene.toml"))
    options = Options(cache=read_cache_options(["refresh=none"]))
    entry = make_entry(analysis, given.node, analysis.node(scene.nodes[given.node]), options)
    still = replace(scene, motion=replace(scene.motion, degrees_per_frame=0.0))
    with open_context() as gpu, RenderScene(gpu, still, (given.size, given.size)) as world:
        clock = pick_clock(gpu)
        for algorithm in entry.chosen:
            run = RunOptions(moving=False)
            with (
                VariantRunner(world, entry.bundle, algorithm, run) as idle,
                VariantRunner(world, entry.bundle, algorithm, run) as busy,
            ):
                busy._idle = EmptyPasses({}, world.sample_counter)  # one that leaves nothing out
                times: tuple[list[float], list[float]] = ([], [])
                with no_collection():
                    for frame in range(FRAMES):
                        for runner, kept in zip((busy, idle), times, strict=True):
                            kept.append(clock.time(partial(runner.draw, frame)))
                ratio = paired_ratio(times[0][SETTLED:], times[1][SETTLED:])
                print(f"{algorithm}: {ratio.median:.2f}x [{ratio.low:.2f}-{ratio.high:.2f}]")


if __name__ == "__main__":
    main()

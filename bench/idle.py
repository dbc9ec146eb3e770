"""What leaving out empty passes saves: a scene at rest, nothing refreshed on purpose.

``python -m bench.idle [--scene dragon] [--size 512]``: each algorithm is drawn as it is and with
all of its passes, in turns.
"""

from __future__ import annotations

import argparse
from dataclasses import replace

from shadercache.caching.configuration import Configuration, Refresh, by_every_algorithm
from shadercache.gpu.context import open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.statistics import paired_ratio
from shadercache.measure.subjects import VariantSubject, subjects_of
from shadercache.paths import data_path
from shadercache.render.empty_passes import EmptyPasses
from shadercache.render.render_scene import RenderScene

SETTLED = 4
"""The first frames, in which all passes are drawn."""


class Busy(VariantSubject):
    """A variant that leaves nothing out."""

    def prepare(self, world: RenderScene) -> None:
        """As if something might always be due."""
        super().prepare(world)
        self.runner.idle = EmptyPasses(Refresh(), world.sample_counter)


def main() -> None:
    """Print the ratio for each algorithm."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scene", default="dragon")
    parser.add_argument("--node", default="whole noise")
    parser.add_argument("--size", type=int, default=512)
    options = parser.parse_args()
    scene, analysis = open_scene(data_path("corpus", options.scene, "scene.toml"))
    resting = replace(scene.common.motion, degrees_per_frame=0.0)
    still = replace(scene, common=replace(scene.common, motion=resting))
    linker = Linker(still, analysis)
    chosen = Configuration((scene.nodes[options.node],), refresh=Refresh("none"))
    idle = subjects_of(linker, options.node, by_every_algorithm(chosen))
    busy = [Busy("all passes", subject.configuration, subject.objects) for subject in idle]
    with open_context() as gpu, RenderScene(gpu, still, (options.size, options.size)) as world:
        how = MeasureOptions(28, curves=0)
        nodes = measure(world, linker.originals(), [*idle, *busy], how).nodes
    for fast, slow in zip(nodes[0].variants, nodes[1].variants, strict=True):
        ratio = paired_ratio(slow.timing.samples[SETTLED:], fast.timing.samples[SETTLED:])
        name = fast.configuration.algorithm
        print(f"{name}: {ratio.median:.2f}x [{ratio.low:.2f}-{ratio.high:.2f}]")


if __name__ == "__main__":
    main()

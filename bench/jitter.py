"""A cache under a jittered projection (TAA): hits, error and blur.

``python -m bench.jitter [--scene dragon] [--size 384]`` prints a table. The scene moves as it does,
or rests. The jitter is *known* where the previous matrices carry it too. Errors are against the
original of the same frame, and against the means of as many frames as the jitter has places (what
an integration over time makes of them). Blur is the share of the original's fine detail (what a
3 x 3 mean takes away) that is missing in the cached image.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import DEFAULT_EPSILON, Configuration, HitTest, Refresh
from shadercache.caching.settings import with_settings
from shadercache.gpu.context import open_context
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.measure import measure
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.subjects import VariantSubject
from shadercache.paths import data_path
from shadercache.render.pass_runners import CoverageRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.graphics_state import GraphicsState

PLACES = 8
CASES = {
    "no jitter": GraphicsState(),
    "jitter known": GraphicsState(jitter=PLACES),
    "jitter unknown": GraphicsState(jitter=PLACES, jitter_told=False),
}

Image = NDArray[np.float64]


@dataclass(frozen=True)
class CaseResult:
    """Of one case: shares, and errors in display units."""

    hits: float
    rmse: float
    rmse_of_mean: float
    blur: float


def fine(image: Image) -> Image:
    """What a 3 x 3 mean takes away, (h - 2, w - 2, 3)."""
    height, width = image.shape[:2]
    mean = sum(image[y : height - 2 + y, x : width - 2 + x] for y in range(3) for x in range(3))
    detail: Image = image[1:-1, 1:-1] - mean / 9.0
    return detail


class Watched(VariantSubject):
    """A variant whose images are kept from a frame on."""

    def watch(self, start: int) -> Self:
        """Keep images from then on."""
        self.start, self.images = start, list[Image]()
        return self

    def draw(self, frame: int) -> None:
        """Draw a frame, and keep it if it counts."""
        super().draw(frame)
        if frame >= self.start:
            self.images.append(self.runner.world.targets.image()[..., :3].astype(np.float64))


def run(world: RenderScene, linker: Linker, configuration: Configuration) -> CaseResult:
    """Draw until the age of payloads has settled, then over all places of the jitter."""
    start = 2 * configuration.refresh.period
    frames = range(start, start + PLACES)
    objects = linker.link(linker.assign(configuration))
    subject = Watched("cached", configuration, objects).watch(start)
    with CoverageRunner(world, *linker.originals()) as cover:
        # The jitter moves outlines: compared is what all of these frames cover.
        covered = cover.coverage(0)
        for frame in frames:
            covered &= cover.coverage(frame)
    truth = [
        image[..., :3].astype(np.float64)
        for image in render_original(world, linker.originals(), frames)
    ]
    how = MeasureOptions(frames.stop)
    [node] = measure(world, linker.originals(), [subject], how).nodes
    images = subject.images
    inner = covered[1:-1, 1:-1]
    whole, kept = (
        sum(float((fine(image)[inner] ** 2).sum()) for image in of) for of in (truth, images)
    )
    apart = [one - other for one, other in zip(truth, images, strict=True)]
    means = [np.mean([image[covered] for image in of], axis=0) for of in (truth, images)]
    return CaseResult(
        hits=float(np.mean(node.curves[0].hit[start:])),
        rmse=float(np.sqrt(np.mean([np.mean(off[covered] ** 2) for off in apart]))),
        rmse_of_mean=float(np.sqrt(np.mean((means[0] - means[1]) ** 2))),
        blur=1.0 - kept / whole,
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scene", default="dragon")
    parser.add_argument("--node", default="whole noise")
    parser.add_argument("--size", type=int, default=384)
    parser.add_argument("--period", type=int, default=32)
    parser.add_argument("--epsilon", type=float, default=DEFAULT_EPSILON)
    parser.add_argument("--cache", action="append", default=[])
    options = parser.parse_args()
    scene, analysis = open_scene(data_path("corpus", options.scene, "scene.toml"))
    linker = Linker(scene, analysis)
    chosen = Configuration(
        (scene.nodes[options.node],),
        refresh=Refresh(period=options.period),
        hit_test=HitTest(epsilon=options.epsilon),
    )
    chosen = with_settings(chosen, options.cache)
    resting = replace(scene.common.motion, degrees_per_frame=0.0)
    still = replace(scene, common=replace(scene.common, motion=resting))
    with open_context() as gpu:
        for way, moved in (("at rest", still), ("1 degree", scene)):
            for name, engine in CASES.items():
                jittered = replace(moved, view=replace(moved.view, engine=engine))
                size = (options.size, options.size)
                with RenderScene(gpu, jittered, size, "rgba32f") as world:
                    result = run(world, linker, chosen)
                print(
                    f"{way}, {name}: hits {result.hits:.1%}, RMSE {result.rmse:.4f}, "
                    f"of the mean {result.rmse_of_mean:.4f}, blur {result.blur:.1%}",
                    flush=True,
                )


if __name__ == "__main__":
    main()

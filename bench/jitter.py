"""A cache under a jittered projection (TAA): hits, error and blur, told of the jitter or not.

``python -m bench.jitter [--scene dragon] [--size 384]`` prints a table. The scene moves as it does,
or rests; errors are against the original of the same frame, and of the means of as many frames as
the jitter has places (what an integration over time makes of them). Blur is the share of the
original's fine detail (what a 3 x 3 mean takes away) that is missing in the cached image.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.entries import make_entry
from shadercache.options import DEFAULT_EPSILON, Options, read_cache_options
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import (
    CoverageRunner,
    OriginalRunner,
    RunOptions,
    VariantRunner,
)
from shadercache.scene.description import Scene
from shadercache.scene.graphics_state import GraphicsState

PLACES = 8
CASES = {
    "no jitter": GraphicsState(),
    "jitter, told": GraphicsState(jitter=PLACES),
    "jitter, not told": GraphicsState(jitter=PLACES, told=False),
}

Image = NDArray[np.float64]


@dataclass(frozen=True)
class Found:
    """Of one case: shares, and errors in display units."""

    hits: float
    rmse: float
    rmse_of_mean: float
    blur: float


def fine(image: Image) -> Image:
    """What a 3 x 3 mean takes away, (h - 2, w - 2, 3)."""
    height, width = image.shape[:2]
    mean = sum(image[y : height - 2 + y, x : width - 2 + x] for y in range(3) for x in range(3))
    found: Image = image[1:-1, 1:-1] - mean / 9.0
    return found


def run(
    gpu: Gpu, scene: Scene, bundle: Bundle, size: int, engine: GraphicsState, period: int
) -> Found:
    """Draw until the age of payloads has settled, then over all places of the jitter."""
    frames = range(2 * period, 2 * period + PLACES)
    hits: list[float] = []
    pairs: list[tuple[Image, Image]] = []
    with (
        RenderScene(gpu, replace(scene, engine=engine), (size, size), "rgba32f") as world,
        OriginalRunner(world, bundle) as original,
        CoverageRunner(world, bundle) as cover,
        VariantRunner(world, bundle, "2-pass", RunOptions(period)) as runner,
    ):
        covered = cover.coverage(0)
        for frame in range(frames.stop):
            if frame in frames:
                mask = runner.hit_mask(frame)
                hits.append(float((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum()))
                covered &= cover.coverage(frame)
                image = original.image(frame)[..., :3].astype(np.float64)
                pairs.append((image, runner.image(frame)[..., :3].astype(np.float64)))
            else:
                runner.draw(frame)
    inner = covered[1:-1, 1:-1]
    detail = [[float((fine(image)[inner] ** 2).sum()) for image in pair] for pair in pairs]
    whole, kept = np.sum(detail, axis=0)
    apart = [np.mean((a[covered] - b[covered]) ** 2) for a, b in pairs]
    means = [np.mean([pair[side][covered] for pair in pairs], axis=0) for side in (0, 1)]
    return Found(
        hits=float(np.mean(hits)),
        rmse=float(np.sqrt(np.mean(apart))),
        rmse_of_mean=float(np.sqrt(np.mean((means[0] - means[1]) ** 2))),
        blur=float(1.0 - kept / whole),
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
    given = parser.parse_args()
    scene, analysis = open_scene(data_path("corpus", given.scene, "scene.toml"))
    node = analysis.node(scene.nodes[given.node])
    options = Options(epsilon=given.epsilon, cache=read_cache_options(given.cache))
    bundle = make_entry(analysis, given.node, node, options).bundle
    still = replace(scene, motion=replace(scene.motion, degrees_per_frame=0.0))
    with open_context() as gpu:
        for way, made in (("at rest", still), ("1 degree", scene)):
            for name, engine in CASES.items():
                found = run(gpu, made, bundle, given.size, engine, given.period)
                print(
                    f"{way}, {name}: hits {found.hits:.1%}, RMSE {found.rmse:.4f}, "
                    f"of the mean {found.rmse_of_mean:.4f}, blur {found.blur:.1%}",
                    flush=True,
                )


if __name__ == "__main__":
    main()

"""What becomes of the pixels in every frame of a run, and what a scene does without.

Nothing is timed here but what objects outside of the picture would cost.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from shadercache.measure.measurement import Curve, Entry, MeasureOptions, Skipped
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import RunOptions, VariantRunner


def outcome_curve(world: RenderScene, entry: Entry, options: MeasureOptions) -> Curve | None:
    """The shares of hits and refreshed pixels by frame; None for an entry without variants.

    The algorithms agree on them (law 4), so one of them is run. Raises as ``VariantRunner``.
    """
    if not entry.chosen:
        return None
    run = RunOptions(options.period, options.block, options.epsilon, options.cache_format)
    values = entry.bundle.mask_values
    hit: list[float] = []
    refresh: list[float] = []
    with VariantRunner(world, entry.bundle, entry.chosen[-1], run) as runner:
        for frame in range(options.frames):
            mask = runner.hit_mask(frame)
            seen = max(1, int(np.count_nonzero(mask)))
            hit.append(float(np.count_nonzero(mask == values["hit"]) / seen))
            refresh.append(float(np.count_nonzero(mask == values["refresh"]) / seen))
            runner.draw(frame)
    return Curve(tuple(hit), tuple(refresh))


def skipped_of(
    world: RenderScene, frames: Sequence[int], slowed: Callable[[int], float]
) -> Skipped | None:
    """What the render scene does without at some frames; None of a scene of one object.

    Args:
        slowed: how many times as long a frame of the original takes with all objects.
    """
    if not world.scene.objects:
        return None
    outside = [len(world.drawables) - len(world.drawn(frame)) for frame in frames]
    ratios = [slowed(frame) for frame, out in zip(frames, outside, strict=True) if out]
    return Skipped(
        objects=len(world.drawables),
        outside=float(np.mean(outside)),
        uncached=sum(not drawable.item.cached for drawable in world.drawables),
        saved=float(np.median(ratios)) - 1.0 if ratios else 0.0,
    )

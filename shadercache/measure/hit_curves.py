"""What becomes of the pixels in every frame of a run, and what a scene does without.

Nothing is timed here but what objects outside of the picture would cost.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from shadercache.measure.measurement import Curve, Skipped
from shadercache.measure.subjects import VariantSubject
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner


def outcome_curves(
    world: RenderScene, subjects: Sequence[VariantSubject], frames: int
) -> Iterator[Curve]:
    """The shares of hits and refreshed pixels by frame, for each period and block of one payload.

    The algorithms agree on them (law 4), so one of them is run. Raises as ``VariantRunner``.
    """
    chosen = {
        (item.configuration.refresh.period, item.configuration.refresh.block): item
        for item in subjects
    }
    for (period, block), subject in chosen.items():
        hit: list[float] = []
        refresh: list[float] = []
        values = subject.bundle.mask_values
        with VariantRunner(world, *subject.objects) as runner:
            for frame in range(frames):
                mask = runner.hit_mask(frame)
                seen = max(1, int(np.count_nonzero(mask)))
                hit.append(float(np.count_nonzero(mask == values["hit"]) / seen))
                refresh.append(float(np.count_nonzero(mask == values["refresh"]) / seen))
                runner.draw(frame)
        yield Curve(period, block, tuple(hit), tuple(refresh))


def skipped_of(
    world: RenderScene, uncached: int, frames: Sequence[int], slowed: Callable[[int], float]
) -> Skipped | None:
    """What the render scene does without at some frames; None of a scene of one object.

    Args:
        uncached: how many objects are drawn by their originals.
        slowed: how many times as long a frame of the original takes with all objects.
    """
    if not world.scene.objects:
        return None
    outside = [len(world.drawables) - len(world.drawn(frame)) for frame in frames]
    ratios = [slowed(frame) for frame, out in zip(frames, outside, strict=True) if out]
    return Skipped(
        objects=len(world.drawables),
        outside=float(np.mean(outside)),
        uncached=uncached,
        saved=float(np.median(ratios)) - 1.0 if ratios else 0.0,
    )

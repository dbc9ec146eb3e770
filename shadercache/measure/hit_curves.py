"""What becomes of the pixels in every frame of a run; nothing is timed here."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from shadercache.measure.measurement import Curve
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
        (subject.configuration.refresh.period, subject.configuration.refresh.block): subject
        for subject in subjects
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

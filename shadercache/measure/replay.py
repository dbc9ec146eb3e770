"""A run drawn once more, untimed, for metrics that cost more than a frame does.

Frames are as they were: the same ones in the same order, from a reset on. So nothing that is costly
disturbs the clock, and no image is kept for longer than a frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from shadercache.gpu.resource import Resource
from shadercache.measure.image_error import Floats, Mask, Pixels, encoded_pair
from shadercache.measure.measurement import MeasureOptions
from shadercache.measure.metrics.perceived import PerceivedSum
from shadercache.measure.metrics.pixel_motion import PixelMotion, motion_between
from shadercache.measure.metrics.texel_age import Ages, next_ages
from shadercache.measure.timed_runs import TimedOriginal, TimedSubject, TimedVariant
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.render.surfaces import Surface, Surfaces


@dataclass(frozen=True, eq=False)
class Seen:
    """What a frame shows by the originals, and what is done with it.

    ``original`` and ``covered`` are given where the frame is ``measured``, or the next one is
    (``kept``). ``motion``: None at the first frame.
    """

    frame: int
    measured: bool
    kept: bool
    original: Pixels
    covered: Mask
    motion: PixelMotion | None


class Replay(Resource):
    """Draws a batch again."""

    def __init__(
        self, world: RenderScene, original: Sequence[Bundle], options: MeasureOptions
    ) -> None:
        """Args: ``original``: one for all objects, or as many. Raises as ``Surfaces``."""
        self._world, self._options = world, options
        several = len(original) == len(world.drawables)
        each = original if several else [original[0]] * len(world.drawables)
        self._surfaces = Surfaces(world, each)
        self._before: Surface | None = None

    def frames(self, reference: TimedOriginal, subjects: Sequence[TimedSubject]) -> Iterator[int]:
        """Draw all frames; says before each which it is. What is found is given to the subjects.

        Raises :class:`InputError` SC604: an image holds NaN or infinity.
        """
        watched = [Watched(self._world, timed) for timed in subjects]
        for frame in range(self._options.frames):
            yield frame
            seen = self._seen(frame, reference)
            for one in watched:
                one.draw(seen)
        for one in watched:
            one.timed.perceived = one.sum.result()

    def _seen(self, frame: int, reference: TimedOriginal) -> Seen:
        surface = self._surfaces.frame(frame)
        self._surfaces.forget()
        motion = None if self._before is None else motion_between(surface, self._before)
        self._before = surface
        measured, kept = (self._options.is_perceived(at) for at in (frame, frame + 1))
        if measured or kept:
            reference.show(frame)
        return Seen(frame, measured, kept, reference.pixels, reference.covered, motion)

    def release(self) -> None:
        """Give the programs back."""
        self._surfaces.release()


class Watched:
    """A subject, the error of its last image, and how old what it reuses is."""

    def __init__(self, world: RenderScene, timed: TimedSubject) -> None:
        self.timed = timed
        self._world = world
        self._variant = timed.variant if isinstance(timed, TimedVariant) else None
        chosen = None if self._variant is None else self._variant.configuration
        self.sum = PerceivedSum(None if chosen is None else chosen.refresh.block * chosen.divisor)
        self._error: Floats | None = None
        self._ages: Ages | None = None

    def draw(self, seen: Seen) -> None:
        """Draw the next frame, and look at it."""
        if seen.frame == 0:
            self.timed.forget()
        # In every frame, though few images are looked at: ages follow from the last frame's.
        mask = None if self._variant is None else self._variant.runner.outcomes(seen.frame)
        self.timed.subject.draw(seen.frame)
        image = self._world.targets.shown() if seen.measured or seen.kept else None
        if mask is not None:
            self._ages = self._next_ages(mask, seen.motion)
        if image is not None:
            self._look(seen, image)

    def _look(self, seen: Seen, image: Pixels) -> None:
        original, shown = encoded_pair(seen.original, image)
        error, before = shown - original, self._error
        self._error = error if seen.kept else None
        if not seen.measured:
            return
        self.sum.add(original, shown, seen.covered)
        if self._ages is not None:
            self.sum.ages.add(self._ages, error, seen.covered)
        if before is not None and seen.motion is not None:
            self.sum.add_change(error, before, seen.motion, seen.covered)

    def _next_ages(self, mask: NDArray[np.uint8], motion: PixelMotion | None) -> Ages | None:
        """The ages of the frame that was drawn, whose hit mask is given; None if nobody knows."""
        assert self._variant is not None
        # Ages that a cache keeps are no help: after a reset they begin at different numbers.
        bundle = self._variant.bundle
        if bundle.mapping == "user":
            return None
        if self._ages is None or motion is None:
            return np.where(mask > 0, 0, -1)
        return next_ages(self._ages, mask == bundle.mask_values["hit"], mask > 0, motion)

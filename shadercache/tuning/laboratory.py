"""Draws assignments beside the original, in turns, for a few frames: the measurements of tuning.

Leaner than :func:`measure.measure`: nothing is timed or looked at that the search does not ask for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from typing import Protocol, TypeAlias

import numpy as np

from shadercache.caching.configuration import Assignment
from shadercache.diagnostics import usage_error
from shadercache.gpu.clock import no_collection, pick_clock
from shadercache.gpu.resource import Resource
from shadercache.linking.linker import Linker
from shadercache.measure.metrics.frame_errors import Compared, FrameErrors, Metric
from shadercache.measure.metrics.pixel_motion import PixelMotion, motion_between
from shadercache.measure.statistics import Ratio, paired_ratio
from shadercache.render.bundle import LinkedObject
from shadercache.render.pass_runners import CoverageRunner, OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.surfaces import Surface, Surfaces
from shadercache.render.variant_runner import VariantRunner

Timer: TypeAlias = Callable[[Callable[[], None]], float]

DIVISOR = 2
"""How many times smaller the small picture is in each direction."""


@dataclass(frozen=True, slots=True)
class Run:
    """How assignments are drawn: ``frames`` from a reset on, of which some are ``compared`` with
    the original in a ``metric``; with ``hits`` those of the first assignment are counted there.
    ``small``: in the small picture. ``start`` and ``step``: as ``Playback``."""

    frames: int
    compared: tuple[int, ...] = ()
    metric: Metric = "rmse"
    small: bool = False
    start: int = 0
    step: int = 1
    hits: bool = False


@dataclass(frozen=True, slots=True)
class Drawn:
    """What an assignment came to: how many times as fast as the original it was, ``errors`` and hit
    rates of the frames that were compared, as far as they were asked for; ``original`` in
    seconds."""

    speedup: Ratio
    errors: tuple[float, ...]
    hit_rates: tuple[float, ...]
    original: float

    @property
    def share(self) -> float:
        """Its time over the original's."""
        return 1.0 / self.speedup.median

    @property
    def worst(self) -> float:
        """The largest error of any frame."""
        return max(self.errors, default=0.0)

    @property
    def mean(self) -> float:
        """The mean error of the frames."""
        return float(np.mean(self.errors)) if self.errors else 0.0


class Measures(Protocol):
    """What the search asks: a laboratory, or a table of what one has found before."""

    def draw(self, assignments: Sequence[Assignment], run: Run) -> list[Drawn]:
        """Draw them in turns with the original."""
        ...


class Laboratory(Resource):
    """Measures on a scene that is open, at its size and at a smaller one."""

    def __init__(self, world: RenderScene, linker: Linker) -> None:
        """Raises :class:`GraphicsError` SC603 for a size that the driver cannot give."""
        self._linker = linker
        self._clock = pick_clock(world.gpu)
        width, height = (max(1, edge // DIVISOR) for edge in world.size)
        self._small = world.drawn_apart((width, height), world.scene.view.engine)
        self._worlds = {False: world, True: self._small}
        self.size = world.size

    def originals(self, small: bool) -> float:
        """Seconds that a frame of the original takes, after the first."""
        run = Run(4, small=small)
        world = self._worlds[small]
        with OriginalRunner(world, *self._linker.originals()) as runner:
            runner.draw(0)
            times = [self._clock.time(partial(runner.draw, frame)) for frame in range(run.frames)]
        return float(np.median(times))

    def draw(self, assignments: Sequence[Assignment], run: Run) -> list[Drawn]:
        """Draw them in turns with the original.

        Raises as ``Linker.link`` and ``BoundPass``; :class:`InputError` SC604 where an image holds
        NaN or infinity.
        """
        base = self._worlds[run.small]
        world = base.showing(base.scene.played(run.start, run.step))
        with ExitStack() as held, no_collection():
            turns = _Turns(world, self._linker, assignments, run, held)
            turns.warm_up()
            for frame in range(run.frames):
                turns.draw(frame, self._clock.time)
            return turns.results()

    def release(self) -> None:
        """Free the small picture."""
        self._small.release()


class _Turns:
    """The original and the assignments, frame by frame."""

    def __init__(
        self,
        world: RenderScene,
        linker: Linker,
        assignments: Sequence[Assignment],
        run: Run,
        held: ExitStack,
    ) -> None:
        self._world, self._run = world, run
        originals = linker.originals()
        self._original = held.enter_context(OriginalRunner(world, *originals))
        self._coverage = held.enter_context(CoverageRunner(world, *originals))
        self._runners = [
            held.enter_context(VariantRunner(world, *_linked(linker, one), short_reset=True))
            for one in assignments
        ]
        self._errors = [FrameErrors(run.metric) for _ in assignments]
        self._surfaces: Surfaces | None = None
        if self._errors and self._errors[0].needs_motion:
            self._surfaces = held.enter_context(Surfaces(world, originals))
        self._before: Surface | None = None
        self._original_times: list[float] = []
        self._times: list[list[float]] = [[] for _ in assignments]
        self._hits: list[list[float]] = [[] for _ in assignments]

    def warm_up(self) -> None:
        """Draw everything once: the first draw of a program compiles it."""
        self._original.draw(0)
        if self._run.compared:
            self._coverage.draw(0)
        for runner in self._runners:
            # A frame after a reset takes other passes than the later ones.
            runner.draw(0)
            runner.draw(1)
            runner.reset()

    def draw(self, frame: int, time: Timer) -> None:
        """Draw a frame by all."""
        run = self._run
        compared = frame in run.compared
        motion = self._motion(frame) if compared or frame + 1 in run.compared else None
        self._world.prepare(frame)  # what changes in a frame is uploaded before the clock runs
        self._original_times.append(time(partial(self._original.draw, frame)))
        if compared:
            originals = self._world.targets.output_pixels()
            covered = self._coverage.coverage(frame)
        for number, runner in enumerate(self._runners):
            if compared and run.hits and number == 0:
                self._hits[number].append(_hit_rate(runner, frame))
            self._times[number].append(time(partial(runner.draw, frame)))
            if compared:
                images = self._world.targets.output_pixels()
                self._errors[number].add(Compared(originals, images, covered, motion))

    def _motion(self, frame: int) -> PixelMotion | None:
        if self._surfaces is None:
            return None
        surface = self._surfaces.frame(frame)
        self._surfaces.forget()
        before, self._before = self._before, surface
        return None if before is None else motion_between(surface, before)

    def results(self) -> list[Drawn]:
        """What each came to, its reset frame left out."""
        original = self._original_times[1:]
        return [
            Drawn(
                paired_ratio(original, times[1:]),
                tuple(errors.values),
                tuple(hits),
                float(np.median(original)),
            )
            for times, errors, hits in zip(self._times, self._errors, self._hits, strict=True)
        ]


def _linked(linker: Linker, assignment: Assignment) -> tuple[LinkedObject, ...]:
    """The programs of an assignment. Raises :class:`UsageError` SC026 where an object would be
    drawn by another algorithm than is said: what was measured would be something else."""
    objects = linker.link(assignment)
    for (name, chosen), linked in zip(assignment.objects, objects, strict=True):
        drawn = linked.configuration
        if chosen is not None and (drawn is None or drawn.algorithm != chosen.algorithm):
            raise usage_error("SC026", f"{name} has no {chosen.algorithm} variant here")
    return objects


def _hit_rate(runner: VariantRunner, frame: int) -> float:
    """The share of hits of the frame that is about to be drawn, among what is cached."""
    mask = runner.hit_mask(frame)
    seen = max(1, int(np.count_nonzero(mask)))
    return float(np.count_nonzero(mask == runner.bundle.mask_values["hit"]) / seen)

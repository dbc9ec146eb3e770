"""Measure what can be drawn against the original: in turns, frame by frame, in one process
(DESIGN §7).

In every frame the original and then each subject is drawn and timed (A B C A B C ...), so that all
see the same drift of the machine. Nothing is printed; progress goes to a callback.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import groupby
from time import monotonic

import numpy as np

from shadercache.diagnostics import usage_error
from shadercache.gpu.clock import Clock, no_collection, pick_clock
from shadercache.measure.hit_curves import outcome_curves, skipped_of
from shadercache.measure.measurement import Group, Measurement, MeasureOptions, NodeResult, Shot
from shadercache.measure.statistics import timing
from shadercache.measure.stopping import COMPARED
from shadercache.measure.subjects import Subject, VariantSubject
from shadercache.measure.timed_runs import TimedOriginal, TimedParts, TimedSubject, TimedVariant
from shadercache.measure.worth_caching import weigh
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene

RESETS = 6
"""About how many frames after a reset are timed."""

Progress = Callable[[int, int, str], None]
"""Called with (steps done, steps in all, what is being done)."""


def measure(
    world: RenderScene,
    original: Sequence[Bundle],
    subjects: Sequence[Subject],
    options: MeasureOptions,
    progress: Progress | None = None,
) -> Measurement:
    """Draw and time every subject beside the original.

    Args:
        original: what all are compared with, as ``Linker.originals`` gives it; one stands for all
            objects.
        subjects: those of one label are drawn in the same turns.
        progress: told after each frame; there is nothing to see otherwise for minutes.

    Raises:
        UsageError: SC027, nothing to measure or too few frames; else as ``Subject.prepare`` and
            ``BoundPass``.
    """
    if not subjects or options.frames < 2:
        raise usage_error("SC027", "a measurement needs a node with a variant, and two frames")
    clock = pick_clock(world.gpu)
    variants = [item for item in subjects if isinstance(item, VariantSubject)]
    gains = weigh(world, variants, clock) if options.weigh else ()
    dropped = {name for gain in gains if not gain.pays for name in gain.objects}
    drawn = [
        item.with_originals(world, dropped) if isinstance(item, VariantSubject) else item
        for item in subjects
    ]
    curves = len({item.label for item in variants}) <= options.curves
    runs: list[_GroupRun] = []
    groups: list[Group] = []
    batches = list(_batches(drawn, options.group))
    for number, batch in enumerate(batches):
        run = _GroupRun(world, original, batch, options, clock)
        runs.append(run)
        try:
            run.draw_all(_teller(progress, number, len(batches), options))
            groups.append(run.result(curves))
        finally:
            run.release()
    covered = [share for run in runs for share in run.covered]
    return Measurement(
        scene=world.scene.name,
        size=world.size,
        options=options,
        clock=clock.name,
        covered=float(np.mean(covered)) if covered else 0.0,
        groups=tuple(groups),
        shots=tuple(shot for run in runs for shot in run.shots),
        notes=tuple(dict.fromkeys(note for run in runs for note in run.notes)),
        gains=gains,
        assignments={
            item.configuration: item.assignment
            for item in drawn
            if isinstance(item, VariantSubject) and item.assignment is not None
        },
    )


def _batches(subjects: Sequence[Subject], most: int) -> Iterator[list[Subject]]:
    """Split so that no batch has more than ``most`` subjects, but at least those of one label."""
    batch: list[Subject] = []
    for _, same in groupby(subjects, key=lambda item: item.label):
        found = list(same)
        if batch and len(batch) + len(found) > most:
            yield batch
            batch = []
        batch = batch + found
    yield batch


def _teller(
    progress: Progress | None, number: int, batches: int, options: MeasureOptions
) -> Callable[[int, str], None]:
    steps = options.frames + 1  # one for the warm-up

    def tell(step: int, what: str) -> None:
        if progress is not None:
            progress(number * steps + step, batches * steps, what)

    return tell


class _GroupRun:
    """One batch of subjects, drawn together."""

    def __init__(
        self,
        world: RenderScene,
        original: Sequence[Bundle],
        subjects: list[Subject],
        options: MeasureOptions,
        clock: Clock,
    ) -> None:
        self._world = world
        self._options = options
        self._clock = clock
        self.shots: list[Shot] = []
        self.covered: list[float] = []
        self._parts: dict[str, TimedParts] = {}
        self._lanes: list[TimedSubject] = []
        self._reference = TimedOriginal(world, original)
        try:
            for subject in subjects:
                self._add(subject)
        except BaseException:
            subject.release()
            self.release()
            raise

    def _add(self, subject: Subject) -> None:
        if not isinstance(subject, VariantSubject):
            self._lanes.append(TimedSubject(self._world, subject))
            return
        if subject.label not in self._parts:
            self._parts[subject.label] = TimedParts(self._world, subject)
        self._lanes.append(TimedVariant(self._world, subject))

    @property
    def _variants(self) -> list[TimedVariant]:
        return [lane for lane in self._lanes if isinstance(lane, TimedVariant)]

    def draw_all(self, tell: Callable[[int, str], None]) -> None:
        """Warm up, then run all frames."""
        tell(0, "compiling programs")
        self._reference.warm_up(0)
        for lane in self._lanes:
            lane.warm_up(0)
        for parts in self._parts.values():
            parts.warm_up(0, self._clock)
        tell(1, "timing")
        begun = monotonic()
        with no_collection():
            for frame in range(self._options.frames):
                self._draw(frame)
                tell(frame + 2, "timing")
                if self._may_stop(frame, monotonic() - begun):
                    break
            for frame in self._few_frames:
                for lane in self._variants:
                    lane.time_reset(self._clock, frame, self._reference)

    def _draw(self, frame: int) -> None:
        compared = frame >= self._options.first_compared
        shown = frame == self._options.picture_frame
        self._reference.time_geometry(self._clock, frame)
        self._reference.time_original(self._clock, frame)
        if compared or shown:
            self._reference.keep_image(frame)
            self.covered.append(float(self._reference.covered.mean()))
        for lane in self._lanes:
            self._draw_lane(lane, frame)
            if compared:
                lane.compare(self._reference)
            if shown and isinstance(lane, TimedVariant):
                self.shots.append(self._shot(lane))
        for parts in self._parts.values():
            if self._options.times_payload(frame):
                parts.time_payload(self._clock, frame)
            if self._options.is_probed(frame):
                parts.probe(self._clock, frame)

    def _may_stop(self, frame: int, elapsed: float) -> bool:
        stop = self._options.stop
        if stop is None or frame + 1 < self._options.first_compared + COMPARED:
            return False
        return stop.is_met(elapsed, (lane.speedup(self._reference) for lane in self._lanes))

    def _draw_lane(self, lane: TimedSubject, frame: int) -> None:
        if isinstance(lane, TimedVariant):
            if self._options.is_probed(frame):
                lane.probe(frame)
            elif frame == self._options.picture_frame:
                lane.look(frame)
        lane.time(self._clock, frame)

    def _shot(self, lane: TimedVariant) -> Shot:
        cached, original = self._world.targets.pixels(), self._reference.pixels
        subject = lane.variant
        return Shot(subject.label, subject.configuration, original, cached, lane.outcome)

    @property
    def _few_frames(self) -> list[int]:
        """Some frames of the second half, for what need not be timed at all of them."""
        first, end = self._options.first_compared, self._options.frames
        return list(range(first, end, max(1, (end - first) // RESETS)))

    def result(self, curves: bool) -> Group:
        """What was measured; with ``curves`` the outcomes of every frame are counted now."""
        reference, lanes = self._reference, self._variants
        original = [seconds for frame, seconds in reference.original.items() if frame > 0]
        others = [lane for lane in self._lanes if not isinstance(lane, TimedVariant)]
        uncached = sum(role.caches is None for role in lanes[0].runner.roles) if lanes else 0
        with no_collection():
            slowed = partial(reference.time_all_objects, self._clock)
            skipped = skipped_of(self._world, uncached, self._few_frames, slowed)
        return Group(
            timing(original),
            timing(list(reference.geometry.values())),
            tuple(self._node(label, curves) for label in self._parts),
            tuple(lane.beside(reference) for lane in others),
            skipped,
        )

    def _node(self, label: str, curves: bool) -> NodeResult:
        lanes = [lane for lane in self._variants if lane.variant.label == label]
        subjects = [lane.variant for lane in lanes] if curves else []
        counted = list(outcome_curves(self._world, subjects, self._options.frames))
        return self._parts[label].result(self._reference, lanes, counted)

    @property
    def notes(self) -> list[str]:
        """What the runs gave away."""
        return [str(seen) for lane in self._variants for seen in lane.runner.cuts.suspicions]

    def release(self) -> None:
        """Give everything back to the render scene."""
        for lane in self._lanes:
            lane.subject.release()
        for parts in self._parts.values():
            parts.release()
        self._reference.release()

"""Measure what can be drawn against the original: in turns, frame by frame, in one process
(docs/why/measuring.md).

In every frame the original and then each subject is drawn and timed (A B C A B C ...), so that all
see the same drift of the machine. Nothing is printed; progress goes to a callback.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from functools import partial
from itertools import count, groupby
from time import monotonic

import numpy as np

from shadercache.diagnostics import usage_error
from shadercache.gpu.clock import Clock, no_collection, pick_clock
from shadercache.gpu.resource import Resource
from shadercache.measure import measurement as results
from shadercache.measure.image_error import Pixels
from shadercache.measure.metrics.perceived import missing_extras
from shadercache.measure.replay import Replay
from shadercache.measure.statistics import FEWEST, LOOK_EVERY, Reached, StopRule, timing, widest
from shadercache.measure.subjects import Subject, VariantSubject
from shadercache.measure.timed_runs import TimedOriginal, TimedParts, TimedSubject, TimedVariant
from shadercache.measure.worth_caching import weigh
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner

RESETS = 6
"""About how many frames after a reset are timed."""

Progress = Callable[[int, int, str], None]
"""Called with (steps done, steps in all, what is being done)."""


def measure(
    world: RenderScene,
    original: Sequence[Bundle],
    subjects: Sequence[Subject],
    options: results.MeasureOptions,
    progress: Progress | None = None,
) -> results.Measurement:
    """Draw and time every subject beside the original.

    Args:
        original: what all are compared with, as ``Linker.originals`` gives it; one stands for all
            objects.
        subjects: those of one label are drawn in the same turns.
        progress: called after each frame; there is nothing to see otherwise for minutes.

    Raises:
        UsageError: SC027, nothing to measure or too few frames; else as ``Subject.prepare`` and
            ``BoundPass``.
    """
    if not subjects or options.frames < 2:
        raise usage_error("SC027", "a measurement needs a node with a variant, and two frames")
    clock = pick_clock(world.gpu)
    variants = [subject for subject in subjects if isinstance(subject, VariantSubject)]
    gains = weigh(world, variants, clock) if options.weigh else ()
    dropped = {name for gain in gains if not gain.pays for name in gain.objects}
    drawn = [
        subject.with_originals(world, dropped) if isinstance(subject, VariantSubject) else subject
        for subject in subjects
    ]
    with_curves = len({subject.label for subject in variants}) <= options.curves
    runs: list[_GroupRun] = []
    groups: list[results.Group] = []
    batches = list(_batches(drawn, options.group))
    # One for the warm-up, and as many for all repetitions: nobody knows how many there will be.
    steps = (options.frames + 1) * (1 + (options.stop is not None) + options.perceptual)
    for number, batch in enumerate(batches, start=1):
        with _GroupRun(world, original, batch, options, clock) as run:
            for step, what in run.draw_all():
                if progress is not None:
                    progress((number - 1) * steps + step, len(batches) * steps, what)
            if progress is not None:
                progress(number * steps, len(batches) * steps, "timing")
            groups.append(run.result(with_curves))
            runs.append(run)
    covered = [share for run in runs for share in run.covered]
    return results.Measurement(
        scene=world.scene.name,
        size=world.size,
        options=options,
        clock=clock.name,
        covered=float(np.mean(covered)) if covered else 0.0,
        groups=tuple(groups),
        shots=tuple(shot for run in runs for shot in run.shots),
        pictures={label: image for run in runs for label, image in run.pictures.items()},
        notes=(
            *dict.fromkeys(note for run in runs for note in run.notes),
            *_beyond(world, options.frames),
        ),
        gains=gains,
        assignments={
            subject.configuration: subject.assignment
            for subject in drawn
            if isinstance(subject, VariantSubject) and subject.assignment is not None
        },
    )


def _beyond(world: RenderScene, frames: int) -> Iterator[str]:
    """What is said of frames behind the end of a recording."""
    recording, last = world.scene.recording, world.scene.view.playback.at(frames - 1)
    if recording is not None and last >= recording.frames:
        yield f"{recording.path.name} has {recording.frames} frames: those behind show its last one"


def _batches(subjects: Sequence[Subject], most: int) -> Iterator[list[Subject]]:
    """Split so that no batch has more than ``most`` subjects, but at least those of one label."""
    batch: list[Subject] = []
    for _, group in groupby(subjects, key=lambda subject: subject.label):
        same = list(group)
        # A label is never split: its P/T and floor are timed once, in turns with all its variants.
        if batch and len(batch) + len(same) > most:
            yield batch
            batch = []
        batch = batch + same
    yield batch


class _GroupRun(Resource):
    """One batch of subjects, drawn together."""

    def __init__(
        self,
        world: RenderScene,
        original: Sequence[Bundle],
        subjects: list[Subject],
        options: results.MeasureOptions,
        clock: Clock,
    ) -> None:
        self._world, self._options, self._clock = world, options, clock
        self._begun = self._seconds = 0.0
        self.shots: list[results.Shot] = []
        self.pictures: dict[str, Pixels] = {}
        self.covered: list[float] = []
        self._parts: dict[str, TimedParts] = {}
        self._subjects: list[TimedSubject] = []
        self._held = ExitStack()
        self._original, self._reference = original, TimedOriginal(world, original)
        self._held.callback(self._reference.release)
        try:
            for subject in subjects:
                self._held.callback(subject.release)  # also of one that cannot be prepared
                self._add(subject)
        except BaseException:
            self.release()
            raise

    def _add(self, subject: Subject) -> None:
        if not isinstance(subject, VariantSubject):
            self._subjects.append(TimedSubject(self._world, subject))
            return
        if subject.label not in self._parts:
            parts = self._parts[subject.label] = TimedParts(self._world, subject)
            self._held.callback(parts.release)
        self._subjects.append(TimedVariant(self._world, subject))

    @property
    def _variants(self) -> list[TimedVariant]:
        return [timed for timed in self._subjects if isinstance(timed, TimedVariant)]

    @property
    def notes(self) -> list[str]:
        """What the runs gave away."""
        missing = missing_extras() if self._options.perceptual else []
        return [
            *(str(seen) for timed in self._variants for seen in timed.runner.cuts.suspicions),
            *missing,
        ]

    def draw_all(self) -> Iterator[tuple[int, str]]:
        """Warm up, then run all frames; says before each step which it is and what it does."""
        yield 0, "compiling programs"
        self._reference.warm_up(0)
        for timed in self._subjects:
            timed.warm_up(0)
        for parts in self._parts.values():
            parts.warm_up(0, self._clock)
        yield 1, "timing"
        self._begun = monotonic()
        with no_collection():  # Python's garbage collector would stop some frame for milliseconds.
            for frame in range(self._options.frames):
                self._draw(frame)
                yield frame + 1, "timing"
            if self._options.stop is not None:
                yield from self._time_on(self._options.stop)
            self._seconds = monotonic() - self._begun
            # After the run: a reset empties the cache that its frames build on.
            for frame in self._few_frames:
                for variant in self._variants:
                    variant.time_reset(self._clock, frame, self._reference)
        if self._options.perceptual:
            yield from self._look_again()

    def _draw(self, frame: int) -> None:
        options, reference = self._options, self._reference
        compared, probed = frame >= options.first_compared, options.is_probed(frame)
        shown = frame == options.picture_frame
        # The geometry first, so that the colour target holds the original's image afterwards.
        reference.time_geometry(self._clock, frame, frame)
        reference.time_original(self._clock, frame, frame)
        if compared or shown:
            reference.keep_image(frame)
            self.covered.append(float(reference.covered.mean()))
        if shown:
            self.pictures[results.ORIGINAL] = reference.pixels
        for timed in self._subjects:
            if isinstance(timed, TimedVariant):
                # Before the frame: a mask tells what the draw that follows is going to do.
                if probed:
                    timed.probe(frame)
                elif shown:
                    timed.look(frame)
            timed.time(self._clock, frame, frame)
            if compared:
                timed.compare(reference)
            if shown and isinstance(timed, TimedVariant):
                self.shots.append(timed.shot(reference))
            elif shown:
                self.pictures[timed.subject.label] = self._world.targets.shown()
        for parts in self._parts.values():
            if options.times_payload(frame):
                parts.time_payload(self._clock, frame)
            if probed:
                parts.probe(self._clock, frame)

    def _look_again(self) -> Iterator[tuple[int, str]]:
        """Draw the frames once more, for the metrics that cost more than a frame does."""
        before = (self._options.frames + 1) * (1 if self._options.stop is None else 2)
        with Replay(self._world, self._original, self._options) as replay:
            for frame in replay.frames(self._reference, self._subjects):
                yield before + frame, "looking at images"

    def _time_on(self, stop: StopRule) -> Iterator[tuple[int, str]]:
        """Repeat the run, only to time it, until the rule is met."""
        frames = self._options.frames
        for further in count():
            elapsed = monotonic() - self._begun
            if stop.is_over(elapsed):
                return
            # More than FEWEST: the reset frame is among these times, but in no ratio.
            timed_enough = len(self._subjects[0].times) > FEWEST
            if further % LOOK_EVERY == 0 and timed_enough and stop.is_met(self._half_width):
                return
            # Steps count on: a repetition's samples stand beside the run's, paired as those are.
            self._time(frames + further)
            # Of the steps set aside for all repetitions, the share of the time that is up.
            yield frames + 1 + int(frames * elapsed / stop.seconds), "timing again"

    def _time(self, step: int) -> None:
        """Time one frame of a repetition, which begins with a reset as the run did."""
        frame = step % self._options.frames
        if frame == 0:
            # No ratio counts a reset frame, so it is drawn without the clock.
            for timed in self._subjects:
                timed.forget()
                timed.subject.draw(0)
            return
        self._reference.time_geometry(self._clock, frame, step)
        self._reference.time_original(self._clock, frame, step)
        for timed in self._subjects:
            timed.time(self._clock, frame, step)

    @property
    def _half_width(self) -> float:
        return widest(timed.speedup(self._reference) for timed in self._subjects)

    @property
    def _reached(self) -> Reached:
        stop, width = self._options.stop, self._half_width
        capped = stop is not None and not stop.is_met(width)
        return Reached(width, len(self._subjects[0].times) - 1, self._seconds, capped)

    @property
    def _few_frames(self) -> list[int]:
        """Some frames of the second half, for what need not be timed at all of them."""
        first, end = self._options.first_compared, self._options.frames
        return list(range(first, end, max(1, (end - first) // RESETS)))

    def result(self, with_curves: bool) -> results.Group:
        """What was measured; with curves the outcomes of every frame are counted now."""
        reference, variants = self._reference, self._variants
        nodes = []
        for label, parts in self._parts.items():
            of_node = [timed for timed in variants if timed.variant.label == label]
            subjects = [timed.variant for timed in of_node] if with_curves else []
            curves = tuple(outcome_curves(self._world, subjects, self._options.frames))
            nodes.append(parts.result(reference, of_node, curves))
        return results.Group(
            original=timing([time for frame, time in reference.original.items() if frame > 0]),
            geometry=timing([time for frame, time in reference.geometry.items() if frame > 0]),
            reached=self._reached,
            nodes=tuple(nodes),
            others=tuple(
                timed.beside(reference)
                for timed in self._subjects
                if not isinstance(timed, TimedVariant)
            ),
            skipped=self._skipped() if self._world.scene.objects else None,
        )

    def _skipped(self) -> results.Skipped:
        """What a scene of several objects does without, at a few frames."""
        world, variants = self._world, self._variants
        outside = {
            frame: len(world.drawables) - len(world.drawn(frame)) for frame in self._few_frames
        }
        slowed = partial(self._reference.time_all_objects, self._clock)
        with no_collection():
            ratios = [slowed(frame) for frame, count in outside.items() if count]
        roles = variants[0].runner.roles if variants else ()
        return results.Skipped(
            objects=len(world.drawables),
            outside=float(np.mean(list(outside.values()))),
            uncached=sum(role.caches is None for role in roles),
            saved=float(np.median(ratios)) - 1.0 if ratios else 0.0,
        )

    def release(self) -> None:
        """Give everything back to the render scene."""
        self._held.close()


def outcome_curves(
    world: RenderScene, subjects: Sequence[VariantSubject], frames: int
) -> Iterator[results.Curve]:
    """The shares of hits and refreshed pixels by frame, for each period and block of one payload.

    The algorithms agree on them (law 4), so one of them is run. Raises as ``VariantRunner``.
    """
    chosen = {
        (subject.configuration.refresh.period, subject.configuration.refresh.block): subject
        for subject in subjects
        if subject.configuration.payload_rate == subjects[0].configuration.payload_rate
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
        yield results.Curve(period, block, tuple(hit), tuple(refresh))

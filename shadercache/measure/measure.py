"""Measure variants against the original: interleaved, frame by frame, in one process (DESIGN §7).

In every frame the original and then each variant is drawn and timed (A B C A B C ...), so that all
see the same drift of the machine. Nothing is printed; progress goes to a callback.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from time import monotonic

import numpy as np

from shadercache.diagnostics import usage_error
from shadercache.gpu.clock import Clock, no_collection, pick_clock
from shadercache.gpu.context import Gpu
from shadercache.linking.object_programs import ObjectPrograms
from shadercache.measure.hit_curves import outcome_curve, skipped_of
from shadercache.measure.measurement import Entry, Group, Measurement, MeasureOptions, Shot
from shadercache.measure.probe import Probe
from shadercache.measure.statistics import timing
from shadercache.measure.stopping import COMPARED
from shadercache.measure.timed_runs import TimedOriginal, TimedParts, TimedVariant
from shadercache.measure.worth_caching import weigh
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.mesh import Mesh

RESETS = 6
"""About how many frames after a reset are timed."""

Progress = Callable[[int, int, str], None]
"""Called with (steps done, steps in all, what is being done)."""


def measure(
    gpu: Gpu,
    scene: Scene,
    entries: Sequence[Entry],
    options: MeasureOptions,
    progress: Progress | None = None,
    mesh: Mesh | None = None,
) -> Measurement:
    """Draw and time the chosen variants of every entry beside the original.

    Args:
        entries: nodes of one shader; the first one's original is the original for all.
        progress: told after each frame; there is nothing to see otherwise for minutes.
        mesh: drawn in place of the scene's own.

    Raises:
        UsageError: SC027, nothing to measure or too few frames; InputError and GraphicsError as
            ``RenderScene`` and ``BoundPass``.
    """
    if not entries or options.frames < 2:
        raise usage_error("SC027", "a measurement needs at least one node and two frames")
    clock = pick_clock(gpu)
    groups: list[Group] = []
    shots: list[Shot] = []
    covered: list[float] = []
    notes: dict[str, None] = {}
    batches = list(_batches(entries, options.group))
    with RenderScene(gpu, scene, options.size, mesh=mesh, programs=ObjectPrograms()) as whole:
        gains = weigh(whole, entries[0], options, clock) if options.weigh else ()
        world = whole.without_caching({name for g in gains if not g.pays for name in g.objects})
        for number, batch in enumerate(batches):
            tell = _teller(progress, number, len(batches), options)
            run = _GroupRun(world, batch, options, clock)
            try:
                run.draw_all(tell)
                groups.append(run.result(len(entries) <= options.curves))
            finally:
                run.release()
            shots += run.shots
            covered += run.covered
            notes |= dict.fromkeys(run.notes)
    share = float(np.mean(covered)) if covered else 0.0
    return Measurement(
        scene.name, options, clock.name, share, tuple(groups), tuple(shots), (*notes,), gains
    )


def _batches(entries: Sequence[Entry], most: int) -> Iterator[list[Entry]]:
    """Split so that no batch has more than ``most`` variants, but at least one node."""
    batch: list[Entry] = []
    size = 0
    for entry in entries:
        if batch and size + len(entry.chosen) > most:
            yield batch
            batch, size = [], 0
        batch.append(entry)
        size += len(entry.chosen)
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
    """One batch of nodes, drawn together."""

    def __init__(
        self, world: RenderScene, entries: list[Entry], options: MeasureOptions, clock: Clock
    ) -> None:
        self._world = world
        self._options = options
        self._clock = clock
        self._entries = entries
        self.shots: list[Shot] = []
        self.covered: list[float] = []
        self._parts: list[TimedParts] = []
        self._lanes: list[TimedVariant] = []
        self._reference = TimedOriginal(world, entries[0])
        try:
            for entry in entries:
                self._parts.append(TimedParts(world, entry, options))
                for algorithm in entry.chosen:
                    self._lanes.append(TimedVariant(world, entry, algorithm, options))
        except BaseException:
            self.release()
            raise

    def draw_all(self, tell: Callable[[int, str], None]) -> None:
        """Warm up, then run all frames."""
        tell(0, "compiling programs")
        self._reference.warm_up(0)
        for lane in self._lanes:
            lane.warm_up(0)
        for parts in self._parts:
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
                for lane in self._lanes:
                    lane.time_reset(self._clock, frame, self._reference)

    def _draw(self, frame: int) -> None:
        compared = frame >= self._options.first_compared
        probed = self._options.is_probed(frame)
        shown = frame == self._options.picture_frame
        self._reference.time_geometry(self._clock, frame)
        self._reference.time_original(self._clock, frame)
        if compared or shown:
            self._reference.keep_image(frame)
            self.covered.append(float(self._reference.covered.mean()))
        for lane in self._lanes:
            if probed:
                lane.probe(frame)
            elif shown:
                lane.look(frame)
            lane.time(self._clock, frame)
            if compared:
                lane.compare(self._reference)
            if shown:
                self.shots.append(self._shot(lane))
        for parts in self._parts:
            if self._options.times_payload(frame):
                parts.time_payload(self._clock, frame)
            if probed:
                parts.probe(self._clock, frame)

    def _may_stop(self, frame: int, elapsed: float) -> bool:
        stop = self._options.stop
        if stop is None or frame + 1 < self._options.first_compared + COMPARED:
            return False
        return stop.is_met(elapsed, (lane.speedup(self._reference) for lane in self._lanes))

    def _shot(self, lane: TimedVariant) -> Shot:
        probe = Probe(
            lane.mask, lane.entry.bundle.mask_values, lane.runner.ages(), self._options.period
        )
        cached = lane.runner.world.targets.pixels()
        original = self._reference.pixels
        return Shot(lane.entry.label, lane.runner.algorithm, original, cached, probe)

    @property
    def _few_frames(self) -> list[int]:
        """Some frames of the second half, for what need not be timed at all of them."""
        first, end = self._options.first_compared, self._options.frames
        return list(range(first, end, max(1, (end - first) // RESETS)))

    def result(self, curves: bool) -> Group:
        """What was measured; with ``curves`` the outcomes of every frame are counted now."""
        reference, world = self._reference, self._world
        nodes = []
        for entry, parts in zip(self._entries, self._parts, strict=True):
            lanes = [lane for lane in self._lanes if lane.entry is entry]
            curve = outcome_curve(world, entry, self._options) if curves else None
            nodes.append(parts.result(reference, entry, lanes, curve))
        original = [seconds for frame, seconds in reference.original.items() if frame > 0]
        geometry = timing(list(reference.geometry.values()))
        with no_collection():
            slowed = partial(reference.time_all_objects, self._clock)
            skipped = skipped_of(world, self._few_frames, slowed)
        return Group(timing(original), geometry, tuple(nodes), skipped)

    @property
    def notes(self) -> list[str]:
        """What the runs gave away."""
        return [str(seen) for lane in self._lanes for seen in lane.runner.cuts.suspicions]

    def release(self) -> None:
        """Give everything back to the render scene."""
        for lane in self._lanes:
            lane.runner.release()
        for parts in self._parts:
            parts.release()
        self._reference.release()

"""What runs side by side in a measurement: the original, each subject, each part of the floor.

Each draws, keeps its samples, and turns them into a result in the end.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from shadercache.gpu.clock import Clock
from shadercache.gpu.color_targets import first_seen, shown
from shadercache.measure import measurement as results
from shadercache.measure.image_error import Pixels
from shadercache.measure.metrics.perceived import Perceived
from shadercache.measure.output_errors import OutputErrors
from shadercache.measure.statistics import Ratio, Timing, paired_ratio, timing
from shadercache.measure.subjects import Subject, VariantSubject
from shadercache.render import pass_runners
from shadercache.render.bundle import Bundle
from shadercache.render.draw_items import OLDEST_IN_HALF
from shadercache.render.memory import bytes_per_pixel
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER, VariantRunner


class TimedOriginal:
    """The original, its geometry and its coverage: what every variant is compared with."""

    def __init__(self, world: RenderScene, bundles: Sequence[Bundle]) -> None:
        """Raises as ``BoundPass``."""
        self._original = pass_runners.OriginalRunner(world, *bundles)
        self._geometry = pass_runners.GeometryRunner(world, *bundles)
        self._coverage = pass_runners.CoverageRunner(world, *bundles)
        self._runners = (self._original, self._geometry, self._coverage)
        self._world = world
        self.original: dict[int, float] = {}
        self.geometry: dict[int, float] = {}
        self.pixels: Pixels = np.zeros((0, 0, 4), np.uint8)
        self.outputs: tuple[Pixels, ...] = ()
        self.output_names = bundles[0].output_names
        self.covered: NDArray[np.bool_] = np.zeros((0, 0), np.bool_)

    def warm_up(self, frame: int) -> None:
        """Draw everything once: the first draw of a program compiles it."""
        for runner in self._runners:
            runner.draw(frame)

    def time_original(self, clock: Clock, frame: int, step: int) -> None:
        """Time the original; its image stays in the colour target. ``step`` numbers the sample."""
        self.original[step] = self.time_again(clock, frame)

    def time_again(self, clock: Clock, frame: int) -> float:
        """The time of the original, which is not kept."""
        self._world.prepare(frame)  # What changes in a frame is uploaded before the clock runs.
        return clock.time(partial(self._original.draw, frame))

    def time_all_objects(self, clock: Clock, frame: int) -> float:
        """How many times as long the original takes with objects outside of the picture."""
        alone = self.time_again(clock, frame)
        self._world.culling = False
        try:
            return self.time_again(clock, frame) / alone
        finally:
            self._world.culling = True

    def time_geometry(self, clock: Clock, frame: int, step: int) -> None:
        """Time the bare geometry. ``step`` numbers the sample."""
        self._world.prepare(frame)
        self.geometry[step] = clock.time(partial(self._geometry.draw, frame))

    def show(self, frame: int) -> None:
        """Draw the original, untimed, and keep its image."""
        self._original.draw(frame)
        self.keep_image(frame)

    def keep_image(self, frame: int) -> None:
        """Keep the original's pixels, which were just drawn, and the mask of covered pixels."""
        self.outputs = self._world.targets.output_pixels()
        self.pixels = shown(self.outputs[first_seen(self._world.targets.outputs)])
        self.covered = self._coverage.coverage(frame)

    def share(self, seconds: dict[int, float]) -> float:
        """What was timed as a share of the original: the median over the frames of both."""
        # The drift of the machine leaves shares of the same frame alone.
        ratios = [time / self.original[frame] for frame, time in seconds.items()]
        return float(np.median(ratios))

    def release(self) -> None:
        """Give the programs back."""
        for runner in self._runners:
            runner.release()


class TimedSubject:
    """A subject with its samples."""

    def __init__(self, world: RenderScene, subject: Subject) -> None:
        """Raises as ``Subject.prepare``."""
        self.subject = subject
        self.times: dict[int, float] = {}
        self._world = world
        self._error = OutputErrors()
        self._frame_rmse: list[float] = []
        self.perceived: Perceived | None = None
        subject.prepare(world)

    def warm_up(self, frame: int) -> None:
        """Draw twice: the first draw of a program compiles it."""
        # A frame after a reset takes other passes than the later ones: both are to be compiled.
        for _ in range(2):
            self.subject.draw(frame)

    def forget(self) -> None:
        """Frame 0 is drawn next, once more."""

    def time(self, clock: Clock, frame: int, step: int) -> None:
        """Time the next frame of the run; its image stays in the colour target. ``step`` numbers
        the sample."""
        # No world.prepare here: the original was timed at this frame just before, which did that.
        self.times[step] = clock.time(partial(self.subject.draw, frame))

    def compare(self, reference: TimedOriginal) -> None:
        """Add the image in the colour target to the error."""
        outputs = self._world.targets.output_pixels()
        self._frame_rmse.append(self._error.add(reference.outputs, outputs, reference.covered))

    def speedup(self, reference: TimedOriginal) -> Ratio:
        """The original's time over this one's, without the reset frame."""
        frames = [frame for frame in self.times if frame > 0]
        original = [reference.original[frame] for frame in frames]
        return paired_ratio(original, [self.times[frame] for frame in frames])

    def beside(self, reference: TimedOriginal) -> results.OtherResult:
        """What was measured of it, beside the original."""
        return results.OtherResult(
            label=self.subject.label,
            timing=timing([time for frame, time in self.times.items() if frame > 0]),
            speedup=self.speedup(reference),
            error=self._error.stats(),
            frame_rmse=tuple(self._frame_rmse),
            perceived=self.perceived,
            outputs=self._error.each(reference.output_names),
        )


class TimedVariant(TimedSubject):
    """One variant with its samples, and what became of its pixels."""

    def __init__(self, world: RenderScene, subject: VariantSubject) -> None:
        """Raises as ``VariantRunner``."""
        super().__init__(world, subject)
        self.variant = subject
        self.mask: NDArray[np.uint8] = np.zeros((0, 0), np.uint8)
        self._outcomes: list[dict[str, float]] = []
        self._work: list[dict[str, int]] = []
        self._resets: list[float] = []

    @property
    def runner(self) -> VariantRunner:
        """What draws it."""
        return self.variant.runner

    @property
    def _outcome(self) -> results.Probe:
        """What the frame that was looked at last shows."""
        values, period = self.variant.bundle.mask_values, self.variant.configuration.refresh.period
        return results.Probe(self.mask, values, self.runner.ages(), period)

    @property
    def _hit_rates(self) -> list[float]:
        return [shares.get("hit", 0.0) for shares in self._outcomes]

    def shot(self, reference: TimedOriginal) -> results.Shot:
        """The pictures of the frame that was just drawn and looked at."""
        subject, cached = self.variant, self._world.targets.shown()
        return results.Shot(
            subject.label, subject.configuration, reference.pixels, cached, self._outcome
        )

    def warm_up(self, frame: int) -> None:
        """Draw a reset frame and one more, so that every pass has been drawn, then forget."""
        super().warm_up(frame)
        # The mask's own program would otherwise be compiled in the middle of the run.
        self.runner.hit_mask(frame)
        self.runner.reset()

    def forget(self) -> None:
        """Forget what is cached: frame 0 is drawn next, once more."""
        self.runner.reset()

    def time_reset(self, clock: Clock, frame: int, reference: TimedOriginal) -> None:
        """Time the frame after a reset, beside the original of the same frame."""
        original = reference.time_again(clock, frame)
        self.runner.reset()
        self._resets.append(clock.time(partial(self.runner.draw, frame)) / original)

    def look(self, frame: int) -> None:
        """Take the hit mask of the frame that is about to be drawn."""
        self.mask = self.runner.outcomes(frame)

    def probe(self, frame: int) -> None:
        """Count outcomes and work of the frame that is about to be drawn."""
        self.look(frame)
        self._outcomes.append(self._outcome.shares)
        self.runner.note_hits(frame, self._hit_rates[-1])
        self._work.append(self.runner.work(frame))

    def result(self, reference: TimedOriginal, hit: dict[int, float]) -> results.VariantResult:
        """What was measured; ``hit`` are the seconds of the hit part at the probed frames."""
        whole = self.beside(reference)
        original = np.median([reference.original[frame] for frame in self.times if frame > 0])
        floor = self._floor(reference, hit)
        return results.VariantResult(
            configuration=self.variant.configuration,
            timing=whole.timing,
            speedup=whole.speedup,
            reset=float(np.median(self._resets)),
            outcomes=_mean(self._outcomes),
            burst=max((shares.get("refresh", 0.0) for shares in self._outcomes), default=0.0),
            hit_rates=tuple(self._hit_rates),
            work=_mean(self._work),
            error=whole.error,
            frame_rmse=whole.frame_rmse,
            perceived=whole.perceived,
            outputs=whole.outputs,
            floor=None if floor is None else floor * float(original),
            # The floor is a share of the original: times original / time, it is floor / time.
            efficiency=None if floor is None else floor * whole.speedup.median,
            bytes_per_pixel=bytes_per_pixel(
                self.variant.bundle, self.variant.configuration.algorithm
            ),
        )

    def _floor(self, reference: TimedOriginal, hit: dict[int, float]) -> float | None:
        """Geometry + rate * T_hit + (1 - rate) * T_miss as a share of the original: see
        docs/why/measuring.md."""
        if not hit or not self._hit_rates:
            return None
        bare = reference.share(reference.geometry)
        # A miss costs what the original costs: 1, of which the geometry is drawn in either case.
        rate = float(np.mean(self._hit_rates))
        return bare + rate * (reference.share(hit) - bare) + (1.0 - rate) * (1.0 - bare)


class TimedParts:
    """The payload alone and the hit alone, each at its frames (``MeasureOptions``)."""

    def __init__(self, world: RenderScene, subject: VariantSubject) -> None:
        """Args: ``subject``: one of those of the payload. Raises as ``VariantRunner``."""
        self.payload: dict[int, float] = {}
        self.hit: dict[int, float] = {}
        self.subject = subject
        # Ages in half floats count no further, so the period may be no longer.
        never = NEVER if subject.bundle.cache.age_channel is None else OLDEST_IN_HALF
        objects = subject.at_rest(never)
        self._payload = pass_runners.PayloadRunner(world, *subject.objects)
        self._hit = VariantRunner(world, *objects) if objects else None

    def warm_up(self, frame: int, clock: Clock) -> None:
        """Draw both once, then forget what was timed."""
        self.time_payload(clock, frame)
        self.probe(clock, frame)
        self.payload.clear()
        self.hit.clear()

    def time_payload(self, clock: Clock, frame: int) -> None:
        """Time the payload alone."""
        self.payload[frame] = clock.time(partial(self._payload.draw, frame))

    def probe(self, clock: Clock, frame: int) -> None:
        """Time the pass that shades hits alone, at rest."""
        hit_pass = self.subject.bundle.hit_pass
        if self._hit is not None and hit_pass is not None:
            # The cache is filled at the same frame, so that every pixel is a hit.
            self._hit.reset()
            self._hit.draw(frame)
            self.hit[frame] = clock.time(partial(self._hit.draw_pass, frame, hit_pass[1]))

    def release(self) -> None:
        """Give programs and caches back."""
        self._payload.release()
        if self._hit is not None:
            self._hit.release()

    def result(
        self,
        reference: TimedOriginal,
        variants: Sequence[TimedVariant],
        curves: tuple[results.Curve, ...],
    ) -> results.NodeResult:
        """The payload with all its variants."""
        bundle = self.subject.bundle
        return results.NodeResult(
            label=self.subject.label,
            node_id=bundle.node("id"),
            path=bundle.node("path"),
            text=bundle.node("text"),
            type=bundle.node("type"),
            mode=bundle.manifest.mode,
            ratio=self._ratio(reference),
            payload=_timing(self.payload),
            hit=_timing(self.hit),
            variants=tuple(timed.result(reference, self.hit) for timed in variants),
            equal=self.subject.facts.equal,
            static_ratio=self.subject.facts.static_ratio,
            curves=curves,
        )

    def _ratio(self, reference: TimedOriginal) -> float | None:
        if not self.payload:
            return None
        bare = reference.share(reference.geometry)
        # The geometry is drawn with the payload and with the original, so both go without.
        if bare == 1.0:  # a clock too coarse for the scene sees no shading
            return None
        return (reference.share(self.payload) - bare) / (1.0 - bare)


def _timing(samples: dict[int, float]) -> Timing | None:
    return timing(list(samples.values())) if samples else None


def _mean(counts: list[dict[str, float]] | list[dict[str, int]]) -> dict[str, float]:
    if not counts:
        return {}
    return {name: float(np.mean([count[name] for count in counts])) for name in counts[0]}

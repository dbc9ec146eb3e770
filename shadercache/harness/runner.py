"""Draw the original, its bare geometry, and variants, frame by frame, as the manifest says.

Arrays that are read back have row 0 at the bottom, as in OpenGL.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import DiagnosticError
from shadercache.harness.bundle import Bundle, PassSpec
from shadercache.harness.cache import as_precise_as
from shadercache.harness.camera import Values
from shadercache.harness.owner import Owner
from shadercache.harness.passes import NO_NAMES, BoundPass, FrameInputs, Naming
from shadercache.harness.stage import Stage

NEVER = 65535
"""The longest refresh period that manifests allow: next to nothing is refreshed on purpose."""


@dataclass(frozen=True, slots=True)
class RunOptions:
    """How a variant is run. ``None`` means what the manifest says.

    ``period`` in frames (1 refreshes everything), ``block`` in pixels (even), ``epsilon`` relative
    to 1/w; without ``moving`` every frame shows the scene of frame 0, while the clock runs on.
    """

    period: int = 32
    block: int = 4
    epsilon: float | None = None
    cache_format: str | None = None
    moving: bool = True


class _Runner(Owner):
    """What all runners share: a stage, and the right to its colour target after a draw."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self._bound: list[BoundPass] = []

    def _bind(self, spec: PassSpec, naming: Naming) -> BoundPass:
        bound = BoundPass(self.stage, spec, naming)
        self._bound.append(bound)
        return bound

    @abstractmethod
    def draw(self, frame: int) -> None:
        """Draw one frame (counted from 0) into the stage's colour target."""

    def image(self, frame: int) -> NDArray[np.float32]:
        """Draw one frame and read it: (h, w, 4), display-encoded."""
        self.draw(frame)
        return self.stage.targets.image()

    def release(self) -> None:
        """Give programs and caches back to the stage."""
        for bound in self._bound:
            bound.release()
        self._bound.clear()


class PassRunner(_Runner):
    """Draws one program that holds nothing but the user's own inputs."""

    def __init__(self, stage: Stage, spec: PassSpec) -> None:
        """Raises as ``BoundPass``."""
        super().__init__(stage)
        self._pass = self._bind(spec, NO_NAMES)

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target."""
        self.stage.begin()
        self._pass.draw(_plain(self.stage.values(frame)), None)


class OriginalRunner(PassRunner):
    """Draws the unchanged shader."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``BoundPass``."""
        super().__init__(stage, bundle.original)


class GeometryRunner(PassRunner):
    """Draws the bare geometry: the part of a frame's time that no cache can save."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``BoundPass``."""
        super().__init__(stage, bundle.geometry)


class PayloadRunner(PassRunner):
    """Draws the payload alone in place of the colour: P of P/T."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``BoundPass``."""
        super().__init__(stage, bundle.payload)


class CoverageRunner(PassRunner):
    """Tells which pixels the mesh covers, and where two fragments tie for the front."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``BoundPass``."""
        super().__init__(stage, bundle.coverage)

    def coverage(self, frame: int) -> NDArray[np.bool_]:
        """Which pixels the mesh covers, (h, w)."""
        self.draw(frame)
        covered: NDArray[np.bool_] = self.stage.targets.pixels()[..., 3] != 0
        return covered

    def ties(self, frame: int) -> NDArray[np.bool_]:
        """Pixels where two fragments share the smallest depth (DESIGN §4, law 4), (h, w).

        Which of the two is seen depends on the order of drawing and the depth function.
        """
        self.draw(frame)
        self.stage.targets.clear_color()
        ctx = self.stage.gpu.ctx
        ctx.enable(moderngl.BLEND)
        ctx.blend_func = (moderngl.ONE, moderngl.ONE)
        self._pass.draw(_plain(self.stage.values(frame)), None, depth_test="==")
        ctx.disable(moderngl.BLEND)
        return self.stage.targets.image()[..., 0] > 0.375


class VariantRunner(_Runner):
    """Runs one variant as its manifest says. Frames are drawn in order; the cache carries over.

    ``hit_mask`` and ``work`` look at the frame that is about to be drawn, with the caches as they
    are then, and leave the run as it was: call them before ``draw`` of the same frame.
    """

    def __init__(
        self, stage: Stage, bundle: Bundle, algorithm: str, options: RunOptions | None = None
    ) -> None:
        """Compile the passes and take a pair of caches; the first frame is a reset frame.

        Raises:
            UsageError: SC026 for an algorithm that the manifest lacks; InputError as ``BoundPass``.
        """
        super().__init__(stage)
        self.bundle = bundle
        self.algorithm = algorithm
        self.options = RunOptions() if options is None else options
        self._naming = Naming(bundle.roles, bundle.twins)
        self._debug: BoundPass | None = None
        self._before: Values | None = None
        self._clear = bundle.cache.clear
        specs = bundle.passes(algorithm)
        formats = as_precise_as(bundle.cache.formats, self.options.cache_format)
        self._caches = stage.targets.lend_cache(formats)
        self._holds_caches = True
        try:
            self._caches.set_filter(bundle.cache.filter)
            self._passes = [self._bind(spec, self._naming) for spec in specs]
        except DiagnosticError:
            self.release()
            raise
        self._on_reset = [
            bound for bound, spec in zip(self._passes, specs, strict=True) if spec.on_reset
        ]
        self.reset()

    @property
    def pass_names(self) -> tuple[str, ...]:
        """The passes, in order."""
        return tuple(bound.name for bound in self._passes)

    def reset(self) -> None:
        """Forget everything (first frame, camera cut, resize): the next frame is a reset frame."""
        self._caches.clear(self._clear)
        self._before = None

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target and the cache, and swap the caches."""
        inputs = self._inputs(frame)
        self._begin()
        for bound in self._due():
            bound.draw(inputs, self._caches)
            self.stage.gpu.submit()
        self._caches.swap()
        self._before = inputs.now

    def draw_pass(self, frame: int, name: str) -> None:
        """Draw one pass alone on cleared targets; the caches are not swapped (for measuring)."""
        inputs = self._inputs(frame)
        self._begin()
        for bound in self._passes:
            if bound.name == name:
                bound.draw(inputs, self._caches)

    def work(self, frame: int) -> dict[str, int]:
        """Fragments that pass the depth test and are not discarded, by pass, in this frame.

        Occlusion queries count overdraw. What a pass of the frame would skip counts as 0.
        """
        inputs = self._inputs(frame)
        counts = dict.fromkeys(self.pass_names, 0)
        self._begin()
        query = self.stage.sample_counter
        for bound in self._due():
            with query:
                bound.draw(inputs, self._caches)
            counts[bound.name] = int(query.samples)
        return counts

    def hit_mask(self, frame: int) -> NDArray[np.uint8]:
        """What becomes of each pixel in this frame, (h, w): 0 uncovered, else ``mask_values``."""
        if self._debug is None:
            self._debug = self._bind(self.bundle.debug, self._naming)
        self.stage.begin()
        self.stage.targets.clear_mask()
        self._debug.draw(self._inputs(frame), self._caches)
        return self.stage.targets.mask_values()

    def cache(self) -> NDArray[np.float32]:
        """What the last drawn frame stored, (h, w, channels): the next frame will read it.

        Channels of unsigned integers come as the floats of the same bits.
        """
        return self._caches.read_previous()

    def restore(self, cache: NDArray[np.float32], frame: int) -> None:
        """Go on as if ``frame`` had been the last one drawn and had stored ``cache``."""
        self._caches.write_previous(cache)
        self._before = self._values(frame)

    def release(self) -> None:
        """Give programs and caches back to the stage."""
        super().release()
        if self._holds_caches:
            self.stage.targets.take_back(self._caches)
            self._holds_caches = False

    def _due(self) -> list[BoundPass]:
        return self._on_reset if self._before is None else self._passes

    def _begin(self) -> None:
        self.stage.begin()
        self._caches.clear_current(self._clear)

    def _inputs(self, frame: int) -> FrameInputs:
        now = self._values(frame)
        period = self.options.period
        epsilon = self.options.epsilon
        if epsilon is None:
            epsilon = self.bundle.defaults.get("epsilon", 0.0)
        numbers = {
            "clock": np.array([frame % period], np.float64),
            "period": np.array([period], np.float64),
            "block": np.array([self.options.block], np.float64),
            "epsilon": np.array([epsilon], np.float64),
            "object": np.array([1.0], np.float64),
            "reset": np.array([self._before is None], np.float64),
        }
        return FrameInputs(now, now if self._before is None else self._before, numbers)

    def _values(self, frame: int) -> Values:
        return self.stage.values(frame if self.options.moving else 0)


def _plain(values: Values) -> FrameInputs:
    return FrameInputs(values, values, {})


def render_original(
    stage: Stage, bundle: Bundle, frames: Iterable[int], moving: bool = True
) -> list[NDArray[np.float32]]:
    """The original's images, (h, w, 4) each; a stage at rest is drawn once.

    Raises as ``BoundPass``.
    """
    with OriginalRunner(stage, bundle) as runner:
        if moving:
            return [runner.image(frame) for frame in frames]
        still = runner.image(0)
        return [still for _ in frames]


def render_variant(
    stage: Stage,
    bundle: Bundle,
    algorithm: str,
    frames: Iterable[int],
    options: RunOptions | None = None,
) -> list[NDArray[np.float32]]:
    """A variant's images, (h, w, 4) each, drawn in order from a reset.

    Raises as ``VariantRunner``.
    """
    with VariantRunner(stage, bundle, algorithm, options) as runner:
        return [runner.image(frame) for frame in frames]

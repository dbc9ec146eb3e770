"""Draw the originals, their bare geometry or their payloads, frame by frame.

Arrays that are read back have row 0 at the bottom, as in OpenGL.
"""

from __future__ import annotations

from abc import abstractmethod

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import DiagnosticError
from shadercache.harness.bundle import Bundle, PassSpec
from shadercache.harness.engine import ORIGINALS
from shadercache.harness.owner import Owner
from shadercache.harness.passes import NO_NAMES, BoundPass, FrameInputs, Naming
from shadercache.harness.prop import Prop
from shadercache.harness.stage import Stage


class Runner(Owner):
    """What all runners share: a stage, and the right to its colour target after a draw."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self._bound: list[BoundPass] = []

    def _bind(self, prop: Prop, spec: PassSpec, naming: Naming) -> BoundPass:
        bound = BoundPass(self.stage, prop, spec, naming)
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


class PassRunner(Runner):
    """Draws programs that hold nothing but the user's own inputs, one for each object."""

    def __init__(self, stage: Stage, *specs: PassSpec, naming: Naming = NO_NAMES) -> None:
        """Args: ``specs`` are one for all objects, or as many. Raises as ``BoundPass``."""
        super().__init__(stage)
        many = specs * len(stage.props) if len(specs) == 1 else specs
        self._passes: dict[Prop, BoundPass] = {}
        try:
            for prop, spec in zip(stage.props, many, strict=True):
                self._passes[prop] = self._bind(prop, spec, naming)
        except DiagnosticError:
            self.release()
            raise

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target."""
        self.stage.begin()
        self._draw_objects(frame)

    def _draw_objects(self, frame: int, depth_test: str | None = None) -> None:
        viewport = self.stage.viewport(frame)
        for prop in self.stage.drawn(frame):
            values = prop.values(frame)
            inputs = FrameInputs(values, values, object_numbers(prop), viewport)
            self._passes[prop].draw(inputs, None, depth_test)


class OriginalRunner(PassRunner):
    """Draws the unchanged shaders."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``BoundPass`` and, for other objects' shaders, ``Cast.bundle``."""
        self._before: CoverageRunner | None = None
        super().__init__(stage, *(found.original for found in _bundles(stage, bundle)))
        if stage.scene.engine.depth == "equal":
            self._before = CoverageRunner(stage, bundle)

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target, with the application's own depth function."""
        engine = self.stage.scene.engine
        if self._before is None:
            self.stage.begin()
        else:
            self._before.draw(frame)
        self._draw_objects(frame, ORIGINALS[engine.depth])

    def release(self) -> None:
        """Give programs back to the stage."""
        super().release()
        if self._before is not None:
            self._before.release()


class GeometryRunner(PassRunner):
    """Draws the bare geometry: the part of a frame's time that no cache can save."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``OriginalRunner``."""
        super().__init__(stage, *(found.geometry for found in _bundles(stage, bundle)))


class PayloadRunner(PassRunner):
    """Draws the payload alone in place of the colour: P of P/T.

    Of objects without a payload it draws the bare geometry.
    """

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``OriginalRunner``."""
        found = zip(stage.props, _bundles(stage, bundle), strict=True)
        super().__init__(
            stage,
            *(
                item.payload if prop.item.cached and "payload" in item.manifest else item.geometry
                for prop, item in found
            ),
            naming=Naming(bundle.roles, {}),
        )


class CoverageRunner(PassRunner):
    """Tells which pixels the objects cover, and where two fragments tie for the front."""

    def __init__(self, stage: Stage, bundle: Bundle) -> None:
        """Raises as ``OriginalRunner``."""
        super().__init__(stage, *(found.coverage for found in _bundles(stage, bundle)))

    def coverage(self, frame: int) -> NDArray[np.bool_]:
        """Which pixels the objects cover, (h, w)."""
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
        self._draw_objects(frame, depth_test="==")
        ctx.disable(moderngl.BLEND)
        return self.stage.targets.image()[..., 0] > 0.375


def _bundles(stage: Stage, bundle: Bundle) -> list[Bundle]:
    """The programs of each object."""
    return [stage.cast.bundle(prop.item, bundle) for prop in stage.props]


def object_numbers(prop: Prop) -> dict[str, NDArray[np.float64]]:
    """The numbers that are an object's own, by role."""
    return {
        "object": np.array([prop.number], np.float64),
        "mask": np.array([prop.item.mask], np.float64),
    }

"""Draw the originals, their bare geometry or their payloads, frame by frame.

Arrays that are read back have row 0 at the bottom, as in OpenGL.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Sequence

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.color_targets import as_floats
from shadercache.gpu.resource import Resource
from shadercache.render.bound_pass import BoundPass, plain_inputs
from shadercache.render.bundle import NO_NAMES, Bundle, LinkedObject, Naming
from shadercache.render.drawable import Drawable
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene
from shadercache.scene.graphics_state import ORIGINALS


class Runner(Resource):
    """What all runners share: a render scene, and the right to its colour target after a draw."""

    def __init__(self, world: RenderScene) -> None:
        self.world = world
        self._bound: list[BoundPass] = []

    def bind(self, drawable: Drawable, spec: PassSpec, naming: Naming) -> BoundPass:
        """A pass that is given back with this runner. Raises as ``BoundPass``."""
        bound = BoundPass(self.world, drawable, spec, naming)
        self._bound.append(bound)
        return bound

    @abstractmethod
    def draw(self, frame: int) -> None:
        """Draw one frame (counted from 0) into the render scene's colour target."""

    def image(self, frame: int) -> NDArray[np.float32]:
        """Draw one frame and read it: (h, w, 4 for each output), as :meth:`Targets.image`."""
        self.draw(frame)
        return self.world.targets.image()

    def release(self) -> None:
        """Give programs and caches back to the render scene."""
        for bound in self._bound:
            bound.release()
        self._bound.clear()


class PassRunner(Runner):
    """Draws programs that hold nothing but the user's own inputs, one for each object."""

    def __init__(self, world: RenderScene, *specs: PassSpec, naming: Naming = NO_NAMES) -> None:
        """Args: ``specs`` are one for all objects, or as many. Raises as ``BoundPass``."""
        super().__init__(world)
        many = specs * len(world.drawables) if len(specs) == 1 else specs
        self._passes: dict[Drawable, BoundPass] = {}
        try:
            for drawable, spec in zip(world.drawables, many, strict=True):
                self._passes[drawable] = self.bind(drawable, spec, naming)
        except DiagnosticError:
            self.release()
            raise

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target."""
        self.world.begin()
        self._draw_objects(frame)

    def _draw_objects(self, frame: int, depth_test: str | None = None) -> None:
        for drawable in self.world.drawn(frame):
            inputs = plain_inputs(self.world, drawable, frame)
            self._passes[drawable].draw(inputs, None, depth_test)


class OriginalRunner(PassRunner):
    """Draws the unchanged shaders, with the application's own depth function."""

    def __init__(self, world: RenderScene, *bundles: Bundle) -> None:
        """Args: ``bundles`` are one for all objects, or as many. Raises as ``BoundPass``."""
        self._before: CoverageRunner | None = None
        super().__init__(world, *(bundle.original for bundle in bundles))
        # An application that tests for equal depth has drawn depth first.
        if world.scene.view.engine.depth == "equal":
            self._before = CoverageRunner(world, *bundles)

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target."""
        if self._before is None:
            self.world.begin()
        else:
            self._before.draw(frame)
        self._draw_objects(frame, ORIGINALS[self.world.scene.view.engine.depth])

    def release(self) -> None:
        """Give programs back to the render scene."""
        super().release()
        if self._before is not None:
            self._before.release()


class GeometryRunner(PassRunner):
    """Draws the bare geometry: the part of a frame's time that no cache can save."""

    def __init__(self, world: RenderScene, *bundles: Bundle) -> None:
        """As ``OriginalRunner``."""
        super().__init__(world, *(bundle.geometry for bundle in bundles))


class PayloadRunner(PassRunner):
    """Draws the payload alone in place of the colour: P of P/T.

    Of objects without a payload it draws the bare geometry.
    """

    def __init__(self, world: RenderScene, *objects: LinkedObject) -> None:
        """Args: ``objects`` are one for all, or as many. Raises as ``BoundPass``."""
        named = next(linked.bundle for linked in objects if linked.bundle.has_variants)
        specs = (
            linked.bundle.payload
            if linked.configuration is not None and linked.bundle.has_variants
            else linked.bundle.geometry
            for linked in objects
        )
        super().__init__(world, *specs, naming=Naming(named.naming.roles))


class CoverageRunner(PassRunner):
    """Tells which pixels the objects cover, and where two fragments tie for the front."""

    def __init__(self, world: RenderScene, *bundles: Bundle) -> None:
        """As ``OriginalRunner``."""
        super().__init__(world, *(bundle.coverage for bundle in bundles))

    def coverage(self, frame: int) -> NDArray[np.bool_]:
        """Which pixels the objects cover, (h, w)."""
        self.draw(frame)
        covered: NDArray[np.bool_] = self.world.targets.pixels()[..., 3] != 0
        return covered

    def ties(self, frame: int) -> NDArray[np.bool_]:
        """Pixels where two fragments share the smallest depth (law 4 of CONTRIBUTING.md), (h, w).

        Which of the two is seen depends on the order of drawing and the depth function.
        """
        self.draw(frame)
        targets, context = self.world.targets, self.world.gpu.ctx
        targets.clear(targets.color, keep_depth=True)
        # Fragments at the smallest depth are all that passes, and each is added to the pixel.
        context.enable(moderngl.BLEND)
        context.blend_func = (moderngl.ONE, moderngl.ONE)
        self._draw_objects(frame, depth_test="==")
        context.disable(moderngl.BLEND)
        # Each fragment adds 1/4: more than 3/8 is two at least.
        return as_floats(targets.pixels())[..., 0] > 0.375


def render_original(
    world: RenderScene, bundles: Sequence[Bundle], frames: Iterable[int], moving: bool = True
) -> list[NDArray[np.float32]]:
    """The original's images, (h, w, 4) each; a render scene at rest is drawn once.

    Raises as ``OriginalRunner``.
    """
    with OriginalRunner(world, *bundles) as runner:
        if moving:
            return [runner.image(frame) for frame in frames]
        still = runner.image(0)
        return [still for _ in frames]

"""Clip-space positions of vertices, captured: what the user's own vertex shader makes of them.

A vertex shader runs alone, by transform feedback. So it is known where the vertices of a frame are,
and whether what a variant takes for their places in the last frame is where they were.
"""

from __future__ import annotations

from dataclasses import replace

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.render.bound_pass import BoundPass, FrameInputs
from shadercache.render.bundle import Naming, PassSpec
from shadercache.render.drawable import Drawable
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import Values

Positions = NDArray[np.float32]

POSITION = "gl_Position"

EXACT = 1e-5
"""How far two positions may be apart and count as the same, relative to their size: programs that
are compiled by themselves may round in other ways."""

_SHAKEN = (0.03, 0.01)
"""By how much of themselves, and by how much besides, uniforms are changed."""


class PositionPass(BoundPass):
    """A vertex shader of which one varying is kept, for all corners of an object's triangles."""

    def __init__(
        self,
        world: RenderScene,
        drawable: Drawable,
        spec: PassSpec,
        naming: Naming,
        captured: str = POSITION,
    ) -> None:
        """Raises as ``BoundPass``; SC602 also where the shader does not write the varying."""
        super().__init__(world, drawable, replace(spec, targets=("color",)), naming, captured)
        self._count = int(drawable.mesh.index.size)

    def captured(self, inputs: FrameInputs) -> Positions:
        """The varying, (n, 4), in the order in which the corners are drawn."""
        context = self._world.gpu.ctx
        # A draw wants a complete framebuffer, also where nothing is rasterised.
        self._world.targets.framebuffer(self._targets(None), depth_write=False).use()
        self._load(inputs, None)
        buffer = context.buffer(reserve=16 * self._count)
        self._array.transform(buffer, moderngl.POINTS)
        positions = np.frombuffer(buffer.read(), np.float32).reshape(self._count, 4)
        buffer.release()
        return positions

    def fault(self, inputs: FrameInputs, truth: Positions) -> str:
        """What is wrong with the varying as the vertices' places in the last frame; or nothing.

        ``truth`` is where the last frame drew the vertices.
        """
        positions = self.captured(inputs)
        # Both may be infinite or NaN, where only the bits can be compared.
        with np.errstate(invalid="ignore", over="ignore"):
            size = np.abs(truth).max(axis=-1)
            away = np.abs(positions - truth).max(axis=-1)
            bits = positions.view(np.uint32), truth.view(np.uint32)
            same = (away <= EXACT * size) | (bits[0] == bits[1]).all(-1)
        # What is not finite was drawn nowhere, so nothing is reused of it.
        wrong = ~same & np.isfinite(truth).all(-1)
        if not wrong.any():
            return ""
        return (
            f"{self._spec.vertex.name} takes {int(np.count_nonzero(wrong)):,} of {len(truth):,} "
            "vertices to have been elsewhere in the last frame than they were, by up to "
            f"{float(np.max(away[wrong] / size[wrong])):.2g} of their clip-space position"
        )


def shaken(values: Values) -> Values:
    """The uniforms, every number of them changed: what a frame before might have had."""
    random = np.random.default_rng(20)
    share, more = _SHAKEN
    return {
        name: value * (1.0 + share * random.uniform(-1.0, 1.0, value.shape))
        + more * random.uniform(0.5, 1.0, value.shape)
        for name, value in values.items()
    }

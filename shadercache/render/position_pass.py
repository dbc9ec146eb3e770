"""Clip-space positions of vertices, captured: what the user's own vertex shader makes of them.

A vertex shader runs alone, by transform feedback. So it is known where the vertices of a frame are.
"""

from __future__ import annotations

from dataclasses import replace

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.render.bound_pass import BoundPass, FrameInputs
from shadercache.render.bundle import Naming
from shadercache.render.drawable import Drawable
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene

Positions = NDArray[np.float32]

POSITION = "gl_Position"


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
        self._instances = drawable.instances.number
        self._count = int(drawable.mesh.index.size) * self._instances
        self.shader = spec.vertex.name

    def captured(self, inputs: FrameInputs) -> Positions:
        """The varying, (n, 4), in the order in which the corners are drawn."""
        context = self._world.gpu.ctx
        # A draw wants a complete framebuffer, also where nothing is rasterised.
        self._world.targets.framebuffer(self._targets(None), depth_write=False).use()
        self._load(inputs, None)
        buffer = context.buffer(reserve=16 * self._count)
        # As points nothing is assembled: each index gives one vertex, in the order of drawing.
        self._array.transform(buffer, moderngl.POINTS, instances=self._instances)
        positions = np.frombuffer(buffer.read(), np.float32).reshape(self._count, 4)
        buffer.release()
        return positions

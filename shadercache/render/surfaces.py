"""What each pixel of a frame shows, and where that was in the frame before: told by the originals.

Nothing of the variants is asked: positions are captured from the user's vertex shader, and drawn
where the user's shaders have left the nearest depth, so that what they discard is not seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.gpu.programs import Program
from shadercache.gpu.resource import Resource
from shadercache.render.bound_pass import FrameInputs, plain_inputs
from shadercache.render.bundle import NO_NAMES, Bundle
from shadercache.render.drawable import Drawable
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.position_pass import PositionPass, Positions
from shadercache.render.render_scene import RenderScene
from shadercache.source import Source

Mask = NDArray[np.bool_]
Floats = NDArray[np.float64]

_GLSL = Path(__file__).parent / "glsl"


@dataclass(frozen=True, eq=False)
class Surface:
    """Arrays (h, w), row 0 at the bottom.

    ``number``: of the object that is seen, 0 where none is. ``inverse_w``: 1/w. ``place``
    (h, w, 2): where its point was in the frame before, in pixels of that; ``before``: its 1/w then.
    """

    number: NDArray[np.int64]
    inverse_w: Floats
    place: Floats
    before: Floats


class Surfaces(Resource):
    """The surfaces of one scene, frame by frame."""

    def __init__(self, world: RenderScene, originals: Sequence[Bundle]) -> None:
        """Args: ``originals``: one for each object. Raises as ``OriginalRunner``."""
        self.world = world
        self._original = OriginalRunner(world, *originals)
        self._captures = {
            drawable: PositionPass(world, drawable, bundle.original, NO_NAMES)
            for drawable, bundle in zip(world.drawables, originals, strict=True)
        }
        sources = [
            Source(name, (_GLSL / name).read_text(encoding="utf-8"))
            for name in ("motion.vert", "motion.frag")
        ]
        self._program: Program = world.programs.acquire(sources[0], sources[1])
        self._frames: dict[int, Surface] = {}
        self._positions: dict[tuple[Drawable, int, int], Positions] = {}

    def frame(self, frame: int) -> Surface:
        """What a frame shows."""
        if frame not in self._frames:
            self._draw(frame)
            self._frames[frame] = self._read(frame)
        return self._frames[frame]

    def forget(self) -> None:
        """Keep the last frame that was asked for and nothing else: a long run would fill memory."""
        last = max(self._frames, default=0)
        self._frames = {frame: seen for frame, seen in self._frames.items() if frame == last}
        self._positions = {key: at for key, at in self._positions.items() if key[1] == last}

    def release(self) -> None:
        """Give the programs back."""
        self._original.release()
        for capture in self._captures.values():
            capture.release()
        self.world.programs.release(self._program)

    def before(self, drawable: Drawable, frame: int) -> Positions:
        """Where the frame before drew the corners of an object."""
        was = max(frame - 1, 0)
        jitter_told = self.world.scene.view.engine.jitter_told
        # Told of the jitter, passes take the last frame's points with this frame's jitter.
        return self._captured(drawable, was, frame if jitter_told else was)

    def at(self, drawable: Drawable, inputs: FrameInputs) -> Positions:
        """Where the user's shader draws the corners with these uniforms."""
        return self._captures[drawable].captured(inputs)

    def lay_depth(self, frame: int) -> None:
        """Draw a frame by the originals, so that its depth is there."""
        self._original.draw(frame)
        targets = self.world.targets
        targets.clear(targets.color, keep_depth=True)

    def _captured(self, drawable: Drawable, frame: int, jittered: int) -> Positions:
        key = (drawable, frame, jittered)
        if key not in self._positions:
            inputs = plain_inputs(self.world, drawable, frame, jittered)
            self._positions[key] = self.at(drawable, inputs)
        return self._positions[key]

    def _draw(self, frame: int) -> None:
        context, uniforms = self.world.gpu.ctx, self._program.uniforms
        # Captured first, since a capture binds a framebuffer of its own.
        parts = [
            (drawable, self._captured(drawable, frame, frame), self.before(drawable, frame))
            for drawable in self.world.drawn(frame)
        ]
        self.lay_depth(frame)
        targets = self.world.targets
        targets.clear(targets.surface, keep_depth=True)
        framebuffer = targets.framebuffer((targets.surface, targets.mask), depth_write=False)
        framebuffer.viewport = self.world.viewport(frame)
        framebuffer.use()
        # Captured positions are the originals' to the bit, and so are their depths.
        context.depth_func = "=="
        for drawable, now, was in parts:
            self.world.set_culling(drawable)
            corners = drawable.mesh.index.size
            for name, value in {"u_number": drawable.number, "u_corners": corners}.items():
                uniforms[name].write(uniforms[name].encode(np.array([value], np.float64), name))
            buffer = context.buffer(np.concatenate([now, was], axis=-1).tobytes())
            content = [(buffer, "4f 4f", "a_now", "a_before")]
            array = context.vertex_array(self._program.gl, content)
            array.render(moderngl.TRIANGLES)
            array.release()
            buffer.release()

    def _read(self, frame: int) -> Surface:
        # As motion.frag writes them: red and green the place in -1 to 1, blue the 1/w before, alpha
        # the number; the mask holds 1/w.
        width, height = self.world.size
        targets = self.world.targets
        seen = np.frombuffer(targets.surface.read(), np.float32).reshape(height, width, 4)
        color = seen.astype(np.float64)
        raw = np.frombuffer(targets.mask.read(), np.float32)
        x, y, w, h = self.world.viewport(max(frame - 1, 0))
        place = np.array([x, y]) + (0.5 + 0.5 * color[..., :2]) * np.array([w, h])
        return Surface(
            number=np.rint(color[..., 3]).astype(np.int64),
            inverse_w=raw.reshape(height, width).astype(np.float64),
            place=place,
            before=color[..., 2],
        )

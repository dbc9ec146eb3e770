"""What each pixel of a frame shows, and where that was in the frame before: told by the originals.

Nothing of the variants is asked: positions are captured from the user's vertex shader, and drawn
where the user's shaders have left the nearest depth, so that what they discard is not seen.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.harness.bundle import Bundle
from shadercache.harness.owner import Owner
from shadercache.harness.pass_runners import OriginalRunner, object_numbers
from shadercache.harness.passes import NO_NAMES, FrameInputs
from shadercache.harness.positions import PositionPass, Positions
from shadercache.harness.programs import Program
from shadercache.harness.prop import Prop
from shadercache.harness.stage import Stage
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


class Surfaces(Owner):
    """The surfaces of one scene, frame by frame."""

    def __init__(self, stage: Stage, original: Bundle) -> None:
        """Raises as ``OriginalRunner``."""
        self.stage = stage
        self._original = OriginalRunner(stage, original)
        self._captures = {
            prop: PositionPass(
                stage, prop, stage.cast.bundle(prop.item, original).original, NO_NAMES
            )
            for prop in stage.props
        }
        sources = [
            Source(name, (_GLSL / name).read_text(encoding="utf-8"))
            for name in ("motion.vert", "motion.frag")
        ]
        self._program: Program = stage.programs.acquire(sources[0], sources[1])
        self._frames: dict[int, Surface] = {}
        self._positions: dict[tuple[Prop, int, int], Positions] = {}

    def frame(self, frame: int) -> Surface:
        """What a frame shows."""
        if frame not in self._frames:
            self._frames[frame] = self._drawn(frame)
        return self._frames[frame]

    def before(self, prop: Prop, frame: int) -> Positions:
        """Where the frame before drew the corners of an object, by this frame's jitter if the
        engine tells of it."""
        was = max(frame - 1, 0)
        told = self.stage.scene.engine.told
        return self._captured(prop, was, frame if told else was)

    def at(self, prop: Prop, inputs: FrameInputs) -> Positions:
        """Where the user's shader draws the corners with these uniforms."""
        return self._captures[prop].captured(inputs)

    def lay_depth(self, frame: int) -> None:
        """Draw a frame by the originals, so that its depth is there."""
        self._original.draw(frame)
        self.stage.targets.clear_color()

    def release(self) -> None:
        """Give the programs back."""
        self._original.release()
        self.stage.programs.release(self._program)
        for capture in self._captures.values():
            capture.release()

    def _captured(self, prop: Prop, frame: int, jittered: int) -> Positions:
        key = (prop, frame, jittered)
        if key not in self._positions:
            values = prop.values(frame, jittered)
            viewport = self.stage.viewport(frame)
            inputs = FrameInputs(values, values, object_numbers(prop), viewport)
            self._positions[key] = self.at(prop, inputs)
        return self._positions[key]

    def _drawn(self, frame: int) -> Surface:
        parts = [
            (prop, self._captured(prop, frame, frame), self.before(prop, frame))
            for prop in self.stage.drawn(frame)
        ]
        self.lay_depth(frame)
        targets = self.stage.targets
        framebuffer = targets.framebuffer((targets.color, targets.mask), depth_write=False)
        framebuffer.viewport = self.stage.viewport(frame)
        framebuffer.use()
        self.stage.gpu.ctx.depth_func = "=="
        for prop, now, was in parts:
            self._draw(prop, now, was)
        return self._surface(frame)

    def _draw(self, prop: Prop, now: Positions, was: Positions) -> None:
        self.stage.set_culling(prop)
        number = self._program.uniforms["u_number"]
        number.write(number.encode(np.array([prop.number], np.float64), "u_number"))
        context = self.stage.gpu.ctx
        buffer = context.buffer(np.concatenate([now, was], axis=-1).tobytes())
        content = [(buffer, "4f 4f", "a_now", "a_before")]
        array = context.vertex_array(self._program.gl, content)
        array.render(moderngl.TRIANGLES)
        array.release()
        buffer.release()

    def _surface(self, frame: int) -> Surface:
        color = self.stage.targets.image().astype(np.float64)
        width, height = self.stage.size
        raw = np.frombuffer(self.stage.targets.mask.read(), np.float32)
        x, y, w, h = self.stage.viewport(max(frame - 1, 0))
        place = np.array([x, y]) + (0.5 + 0.5 * color[..., :2]) * np.array([w, h])
        return Surface(
            number=np.rint(color[..., 3]).astype(np.int64),
            inverse_w=raw.reshape(height, width).astype(np.float64),
            place=place,
            before=color[..., 2],
        )

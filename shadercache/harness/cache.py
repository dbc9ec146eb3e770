"""The two cache textures of a variant: one is read, one is written, and they swap each frame."""

from __future__ import annotations

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error

_DTYPES = {"rgba16f": "f2", "rgba32f": "f4"}
_FILTERS = {"linear": moderngl.LINEAR, "nearest": moderngl.NEAREST}


class CachePair:
    """``previous`` holds the last frame's payloads, ``current`` receives this frame's."""

    def __init__(self, ctx: moderngl.Context, size: tuple[int, int], form: str) -> None:
        """Make both textures, clamped to the edge.

        Raises:
            InputError: SC603, a format other than rgba16f or rgba32f.
        """
        if form not in _DTYPES:
            known = ", ".join(_DTYPES)
            raise input_error("SC603", f"unknown cache format {form!r}", hint=f"one of {known}")
        self.format = form
        self.previous = self._texture(ctx, size)
        self.current = self._texture(ctx, size)
        self._frames = {
            texture: ctx.framebuffer([texture]) for texture in (self.previous, self.current)
        }

    def _texture(self, ctx: moderngl.Context, size: tuple[int, int]) -> moderngl.Texture:
        texture = ctx.texture(size, 4, dtype=_DTYPES[self.format])
        texture.repeat_x = texture.repeat_y = False
        return texture

    def set_filter(self, name: str) -> None:
        """How both are sampled between texels: ``linear`` or ``nearest`` (else SC021)."""
        if name not in _FILTERS:
            raise input_error("SC021", f"the manifest's cache filter {name!r} is not known")
        for texture in self._frames:
            texture.filter = (_FILTERS[name], _FILTERS[name])

    def clear_current(self, value: tuple[float, float, float, float]) -> None:
        """Fill the one to be written."""
        self._frames[self.current].clear(*value)

    def clear(self, value: tuple[float, float, float, float]) -> None:
        """Fill both, as on a reset."""
        for frame in self._frames.values():
            frame.clear(*value)

    def swap(self) -> None:
        """End the frame: what was written will be read."""
        self.previous, self.current = self.current, self.previous

    def read_previous(self) -> NDArray[np.float32]:
        """What the next frame will read, (h, w, 4), row 0 at the bottom."""
        width, height = self.previous.size
        dtype = np.dtype(_DTYPES[self.format])
        data = np.frombuffer(self.previous.read(), dtype).reshape(height, width, 4)
        return data.astype(np.float32)

    def write_previous(self, values: NDArray[np.float32]) -> None:
        """Replace what the next frame will read by (h, w, 4) values."""
        self.previous.write(values.astype(_DTYPES[self.format]).tobytes())

    def textures(self) -> tuple[moderngl.Texture, ...]:
        """Both textures, in no order."""
        return tuple(self._frames)

    def release(self) -> None:
        """Free the GL objects."""
        for texture, frame in self._frames.items():
            frame.release()
            texture.release()

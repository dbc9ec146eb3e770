"""The textures of a variant's cache: one set is read, one is written, and they swap each frame.

A set is one texture, or two where the payload is too wide for one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error

_KINDS = {"16f": "f2", "32f": "f4", "32ui": "u4"}
_FORMATS = {
    channels + kind: (len(channels), dtype)
    for kind, dtype in _KINDS.items()
    for channels in ("r", "rg", "rgba")
}
_FILTERS = {"linear": moderngl.LINEAR, "nearest": moderngl.NEAREST}

Textures = tuple[moderngl.Texture, ...]


def texel_bytes(form: str) -> int:
    """The bytes of a texel of a format of these textures (``rgba16f``)."""
    components, dtype = _FORMATS[form]
    return components * np.dtype(dtype).itemsize


@dataclass(eq=False)
class _Layer:
    """One texture, how it is cleared, and how its texels are stored."""

    texture: moderngl.Texture
    frame: moderngl.Framebuffer
    dtype: np.dtype[np.generic]
    empty: moderngl.Buffer | None = None

    def clear(self, value: Sequence[float]) -> None:
        if self.dtype.kind != "u":
            red, green, blue, alpha = value
            self.frame.clear(red, green, blue, alpha)
            return
        # The result of glClear is undefined for integers; empty texels are copied instead.
        if self.empty is None:
            width, height = self.texture.size
            texel = np.array(value[: self.texture.components], self.dtype)
            self.empty = self.texture.ctx.buffer(np.tile(texel, width * height).tobytes())
        self.texture.write(self.empty)

    def read(self) -> NDArray[np.float32]:
        width, height = self.texture.size
        data = np.frombuffer(self.texture.read(), self.dtype).reshape(height, width, -1)
        return data.view(np.float32) if self.dtype.kind == "u" else data.astype(np.float32)

    def release(self) -> None:
        if self.empty is not None:
            self.empty.release()
        self.frame.release()
        self.texture.release()


class CachePair:
    """``previous`` holds the last frame's payloads, ``current`` receives this frame's."""

    def __init__(
        self, ctx: moderngl.Context, size: tuple[int, int], formats: Sequence[str]
    ) -> None:
        """Make both sets, clamped to the edge.

        Raises:
            InputError: SC603, a format that is not known.
        """
        for form in formats:
            if form not in _FORMATS:
                hint = f"one of {', '.join(_FORMATS)}"
                raise input_error("SC603", f"unknown cache format {form!r}", hint=hint)
        self.formats, self.size = tuple(formats), size
        # Two sets: a pass that samples what it draws into reads undefined values (OpenGL 4.6
        # section 9.3.1).
        self._previous = [_layer(ctx, size, form) for form in formats]
        self._current = [_layer(ctx, size, form) for form in formats]

    @property
    def previous(self) -> Textures:
        """What this frame reads."""
        return tuple(layer.texture for layer in self._previous)

    @property
    def current(self) -> Textures:
        """What this frame writes."""
        return tuple(layer.texture for layer in self._current)

    def set_filter(self, name: str) -> None:
        """How all are sampled between texels: ``linear`` or ``nearest`` (else SC021)."""
        if name not in _FILTERS:
            raise input_error("SC021", f"the manifest's cache filter {name!r} is not known")
        for texture in self.previous + self.current:
            texture.filter = (_FILTERS[name], _FILTERS[name])

    def clear_current(self, values: Sequence[Sequence[float]]) -> None:
        """Fill those to be written, each with a value of its own."""
        for layer, value in zip(self._current, values, strict=True):
            layer.clear(value)

    def clear(self, values: Sequence[Sequence[float]]) -> None:
        """Fill all, as on a reset."""
        for layer, value in zip(self._previous + self._current, (*values, *values), strict=True):
            layer.clear(value)

    def swap(self) -> None:
        """End the frame: what was written will be read."""
        self._previous, self._current = self._current, self._previous

    def read_previous(self) -> NDArray[np.float32]:
        """What the next frame will read, (h, w, channels), row 0 at the bottom.

        Unsigned integers come as the floats of the same bits.
        """
        return np.concatenate([layer.read() for layer in self._previous], axis=-1)

    def write_previous(self, values: NDArray[np.float32]) -> None:
        """Replace what the next frame will read by what ``read_previous`` once gave."""
        start = 0
        for layer in self._previous:
            end = start + layer.texture.components
            part = np.ascontiguousarray(values[..., start:end], np.float32)
            stored = part.view(layer.dtype) if layer.dtype.kind == "u" else part.astype(layer.dtype)
            layer.texture.write(stored.tobytes())
            start = end

    def release(self) -> None:
        """Free the GL objects."""
        for layer in (*self._previous, *self._current):
            layer.release()


def cache_texture(ctx: moderngl.Context, size: tuple[int, int], form: str) -> moderngl.Texture:
    """A texture of one of the known formats, whose texels are fetched one by one."""
    components, dtype = _FORMATS[form]
    texture = ctx.texture(size, components, dtype=dtype)
    # One of integers with a linear filter is incomplete (OpenGL 4.6 section 8.17).
    texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
    texture.repeat_x = texture.repeat_y = False
    return texture


def _layer(ctx: moderngl.Context, size: tuple[int, int], form: str) -> _Layer:
    texture = cache_texture(ctx, size, form)
    return _Layer(texture, ctx.framebuffer([texture]), np.dtype(_FORMATS[form][1]))

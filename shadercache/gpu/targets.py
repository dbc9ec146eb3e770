"""Render targets of a picture, shared by every runner: colour, depth, mask, caches.

Caches and masks may be a fraction of the picture; each size has a depth buffer of its own.
"""

from __future__ import annotations

from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import Diagnostic, GraphicsError, input_error
from shadercache.gpu.cache_textures import CachePair, cache_texture
from shadercache.gpu.color_targets import (
    COLOR,
    ColorTarget,
    as_floats,
    first_seen,
    output_texture,
    read_output,
    shown,
)
from shadercache.gpu.fractions import WhichDepth, divided_size

COLOR_FORMATS = {"rgba8": "f1", "rgba32f": "f4"}
"""Colour formats: 8 bits for what is shown and timed, 32-bit floats for proofs."""


class Targets:
    """Colour, depth and mask of one size, the framebuffers over them, and a pool of caches.

    Runners take turns, so they share colour and depth; a cache outlives the frame and is lent.
    """

    def __init__(
        self,
        ctx: moderngl.Context,
        size: tuple[int, int],
        color: str,
        empty_depth: float = 1.0,
        sampled: bool = False,
    ) -> None:
        """Make the colour and depth targets; depth is cleared to ``empty_depth``.

        ``sampled``: shaders read them, depth as a texture of window depths, both clamped to the
        edge.

        Raises:
            InputError: SC603 for an unknown colour format; GraphicsError: SC603 for a size that
                the driver cannot give.
        """
        if color not in COLOR_FORMATS:
            known = ", ".join(COLOR_FORMATS)
            raise input_error("SC603", f"unknown colour format {color!r}", hint=f"one of {known}")
        self.ctx, self.size, self.color_format = ctx, size, color
        self._empty_depth = empty_depth
        self._framebuffers: dict[tuple[Any, ...], moderngl.Framebuffer] = {}
        self._idle: list[CachePair] = []
        self._pairs: list[CachePair] = []
        self._masks: dict[int, moderngl.Texture] = {}
        self._depths: dict[tuple[WhichDepth, tuple[int, int]], moderngl.Renderbuffer] = {}
        """Of what has another depth than the picture."""
        self._surface: moderngl.Texture | None = None
        self._parked: dict[tuple[str, str], moderngl.Texture] = {}
        self.outputs: tuple[ColorTarget, ...] = (COLOR,)
        """What is drawn in a frame."""
        self._outputs: dict[ColorTarget, moderngl.Texture] = {}
        try:
            self.color = ctx.texture(size, 4, dtype=COLOR_FORMATS[color])
            self.depth = _depth_texture(ctx, size) if sampled else ctx.depth_renderbuffer(size)
            if sampled:
                self.color.repeat_x = self.color.repeat_y = False
            self.framebuffer((self.color,), depth_write=True)
        except moderngl.Error as error:
            message = f"the driver cannot make a {size[0]}x{size[1]} {color} target: {error}"
            raise GraphicsError(Diagnostic("SC603", message)) from None

    @property
    def mask(self) -> moderngl.Texture:
        """One float channel for the debug program; made when first wanted."""
        return self.mask_of(1)

    def mask_of(self, divisor: int) -> moderngl.Texture:
        """The same a fraction of the picture in size."""
        if divisor not in self._masks:
            self._masks[divisor] = self.ctx.texture(divided_size(self.size, divisor), 1, dtype="f4")
        return self._masks[divisor]

    @property
    def surface(self) -> moderngl.Texture:
        """Four float channels for what a pixel shows; made when first wanted."""
        if self._surface is None:
            self._surface = self.ctx.texture(self.size, 4, dtype="f4")
        return self._surface

    def parked(self, name: str, form: str) -> moderngl.Texture:
        """A texture for what is parked within a frame, with undefined contents."""
        if (name, form) not in self._parked:
            self._parked[name, form] = cache_texture(self.ctx, self.size, form)
        return self._parked[name, form]

    @property
    def depth_texture(self) -> moderngl.Texture:
        """The window depths, of targets that are sampled."""
        assert isinstance(self.depth, moderngl.Texture)
        return self.depth

    def clear(self, texture: moderngl.Texture, keep_depth: bool = False) -> None:
        """Start drawing into colour or mask: all channels 0, depth empty."""
        # GL clears depth only in a framebuffer that may write it.
        framebuffer = self.framebuffer((texture,), None if keep_depth else True)
        framebuffer.clear(0.0, 0.0, 0.0, 0.0, depth=self._empty_depth)

    def clear_depth(self, divisor: int) -> None:
        """Empty the depth of targets that have another one than the picture."""
        framebuffer = self.framebuffer((self.mask_of(divisor),), True, "apart")
        framebuffer.clear(depth=self._empty_depth)

    def framebuffer(
        self,
        textures: tuple[moderngl.Texture, ...],
        depth_write: bool | None,
        buffer: WhichDepth = "shared",
    ) -> moderngl.Framebuffer:
        """The framebuffer with these attachments (in order) and the shared depth; None: without.

        ``buffer``: which depth it is; all share one that are of this size. That of marks has
        undefined contents at first.
        """
        # GL reuses the names of what is freed; these textures live as long as their framebuffers.
        key = (*(texture.glo for texture in textures), depth_write, buffer)
        if key not in self._framebuffers:
            size = textures[0].size if textures else self.size
            shared = self.depth if buffer == "shared" else self._other_depth(size, buffer)
            depth = None if depth_write is None else shared
            self._framebuffers[key] = self.ctx.framebuffer(textures, depth)
            # moderngl keeps this mask with the framebuffer, hence one for each.
            self._framebuffers[key].depth_mask = bool(depth_write)
        return self._framebuffers[key]

    def _other_depth(self, size: tuple[int, int], buffer: WhichDepth) -> moderngl.Renderbuffer:
        key = buffer, size
        if key not in self._depths:
            self._depths[key] = self.ctx.depth_renderbuffer(size)
        return self._depths[key]

    def lend_cache(self, formats: tuple[str, ...], divisor: int = 1) -> CachePair:
        """Cache textures with undefined contents, maybe a fraction of the picture in size; hand
        them back with ``take_back``."""
        size = divided_size(self.size, divisor)
        for pair in self._idle:
            if (pair.formats, pair.size) == (formats, size):
                self._idle.remove(pair)
                return pair
        pair = CachePair(self.ctx, size, formats)
        self._pairs.append(pair)
        return pair

    def take_back(self, pair: CachePair) -> None:
        """Keep a pair for the next runner."""
        self._idle.append(pair)

    def output(self, target: ColorTarget) -> moderngl.Texture:
        """The texture of one of the outputs; the first shares the colour target if it may.

        Further ones hold half floats where colours have 8 bits: a G-buffer's are not in 0-1.
        """
        if (target.name, target.base) == (COLOR.name, COLOR.base):
            return self.color
        if target not in self._outputs:
            floats = "f4" if self.color_format == "rgba32f" else "f2"
            self._outputs[target] = output_texture(self.ctx, self.size, target, floats)
        return self._outputs[target]

    def clear_outputs(self) -> None:
        """Start a frame: every output 0, depth empty."""
        textures = [self.output(target) for target in self.outputs]
        floats = [texture for texture in textures if texture.dtype[0] == "f"]
        # The colour target among them, for who draws something else into it.
        cleared = tuple(dict.fromkeys((self.color, *floats)))
        self.framebuffer(cleared, True).clear(0.0, 0.0, 0.0, 0.0, depth=self._empty_depth)
        for texture in textures:
            # What glClear does to integers is undefined (OpenGL 4.6 section 17.4.3.1).
            if texture.dtype[0] != "f":
                texture.write(bytes(4 * texture.components * self.size[0] * self.size[1]))

    def paint(self, value: float) -> None:
        """Fill the first output with the bits of a float."""
        first = self.output(self.outputs[0])
        first.write(np.full((*self.size[::-1], first.components), value, np.float32).tobytes())

    def painted(self, value: float) -> NDArray[np.bool_]:
        """Where nothing was drawn over that, (h, w). For 32-bit targets."""
        target = self.outputs[0]
        drawn = as_floats(read_output(self.output(target), target))[..., : target.channels]
        untouched: NDArray[np.bool_] = np.all(drawn == np.float32(value), axis=-1)
        return untouched

    def pixels(self) -> NDArray[np.generic]:
        """The colour target as it is stored, (h, w, 4) uint8 or float32, row 0 at the bottom."""
        return read_output(self.color, COLOR)

    def output_pixels(self) -> tuple[NDArray[np.generic], ...]:
        """Every output as it is stored, (h, w, 4) each (:func:`read_output`)."""
        return tuple(read_output(self.output(target), target) for target in self.outputs)

    def shown(self) -> NDArray[np.generic]:
        """What people see of the outputs, (h, w, 4) uint8 or floats, row 0 at the bottom."""
        seen = self.outputs[first_seen(self.outputs)]
        return shown(read_output(self.output(seen), seen))

    def image(self) -> NDArray[np.float32]:
        """The outputs side by side as float32 (h, w, 4 each), row 0 at the bottom.

        Floats are display-encoded 0-1; of integers these are the floats of the same bits.
        """
        images = [as_floats(pixels) for pixels in self.output_pixels()]
        return images[0] if len(images) == 1 else np.concatenate(images, axis=-1)

    def mask_values(self, divisor: int = 1) -> NDArray[np.uint8]:
        """The mask target, rounded to whole numbers, (h, w), row 0 at the bottom."""
        mask = self.mask_of(divisor)
        width, height = mask.size
        values = np.frombuffer(mask.read(), np.float32).reshape(height, width)
        return (values + 0.5).astype(np.uint8)

    def release(self) -> None:
        """Free every GL object, lent caches included."""
        for framebuffer in self._framebuffers.values():
            framebuffer.release()
        for pair in self._pairs:
            pair.release()
        for buffer in self._depths.values():
            buffer.release()
        parked = self._parked.values()
        for texture in (
            self.color,
            self.depth,
            self._surface,
            *self._masks.values(),
            *parked,
            *self._outputs.values(),
        ):
            if texture is not None:
                texture.release()


def _depth_texture(ctx: moderngl.Context, size: tuple[int, int]) -> moderngl.Texture:
    texture = ctx.depth_texture(size)
    texture.compare_func = ""  # the depths themselves, not what a comparison with them says
    texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
    texture.repeat_x = texture.repeat_y = False
    return texture

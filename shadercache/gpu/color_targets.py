"""The render targets of a shader's outputs: one for each location, of floats or integers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

import moderngl
import numpy as np
from numpy.typing import NDArray

Base: TypeAlias = Literal["float", "int", "uint"]

_INTEGERS: dict[Base, str] = {"int": "i4", "uint": "u4"}
_FLOATS = {"f1": np.uint8, "f2": np.float16, "f4": np.float32}


@dataclass(frozen=True, slots=True)
class ColorTarget:
    """What is drawn at one location: the target's name in the manifest, and the type that the
    shader writes. ``channels`` beyond those of the type are undefined (OpenGL 4.6 section 15.2.3).
    ``output``: the user's name; an array has several targets.
    """

    name: str
    base: Base = "float"
    channels: int = 4
    output: str = ""

    @property
    def stored(self) -> int:
        """The channels of its texture: three need not be a render target (OpenGL 4.6 8.5.1)."""
        return 4 if self.channels == 3 else self.channels


COLOR = ColorTarget("color")
"""One ``vec4``."""


def output_kind(glsl: str) -> tuple[Base, int]:
    """What an output of a type holds, and in how many channels: ``ivec2[3]`` two of integers."""
    name = glsl.partition("[")[0]
    base: Base = "uint" if name.startswith("u") else "int" if name.startswith("i") else "float"
    return base, int(name[-1]) if "vec" in name else 1


def output_texture(
    ctx: moderngl.Context, size: tuple[int, int], target: ColorTarget, floats: str
) -> moderngl.Texture:
    """A texture for an output; ``floats`` is the moderngl type of those that hold floats."""
    dtype = _INTEGERS.get(target.base, floats)
    texture = ctx.texture(size, target.stored, dtype=dtype)
    texture.repeat_x = texture.repeat_y = False
    return texture


def read_output(texture: moderngl.Texture, target: ColorTarget) -> NDArray[np.generic]:
    """What was drawn, as it is stored: (h, w, 4), row 0 at the bottom.

    Channels that the shader does not write are filled: of one channel all three colours are that,
    else they are 0; alpha is the largest (1).
    """
    width, height = texture.size
    kinds = {"i4": np.int32, "u4": np.uint32, **_FLOATS}
    dtype = np.dtype(kinds[texture.dtype])
    pixels = np.frombuffer(texture.read(), dtype).reshape(height, width, texture.components)
    if target.channels == 4:
        return pixels
    filled = np.zeros((height, width, 4), dtype)
    filled[..., : target.channels] = pixels[..., : target.channels]
    if target.channels == 1:
        filled[..., 1] = filled[..., 2] = pixels[..., 0]
    filled[..., 3] = 255 if dtype == np.uint8 else 1
    return filled


def holds_integers(pixels: NDArray[np.generic]) -> bool:
    """Does an output that was read hold integers, and not the bytes of floats?"""
    return pixels.dtype in (np.int32, np.uint32)


def first_seen(outputs: Sequence[ColorTarget]) -> int:
    """Which of the outputs people look at: the first of floats, or else the first."""
    return next((at for at, output in enumerate(outputs) if output.base == "float"), 0)


def shown(pixels: NDArray[np.generic]) -> NDArray[np.generic]:
    """An output for people to look at: integers by their lowest eight bits."""
    if not holds_integers(pixels):
        return pixels
    return (pixels.view(np.uint32) & 0xFF).astype(np.uint8)


def as_floats(pixels: NDArray[np.generic]) -> NDArray[np.float32]:
    """An output in single precision: bytes as 0-1, of 32-bit integers the floats of their bits."""
    if pixels.dtype == np.uint8:
        return pixels.astype(np.float32) / np.float32(255.0)
    if holds_integers(pixels):
        return pixels.view(np.float32)
    return pixels.astype(np.float32, copy=False)

"""The textures of the example: their arrays, smaller ones where they would take too much."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.gpu.textures import load_pixels, made_pixels
from shadercache.report.hand_over.example.code_lines import spread
from shadercache.scene.object_inputs import TextureSpec

SMALLEST = 64
"""Edge of textures that are left as they are, in texels."""

Array: TypeAlias = NDArray[Any]

_KINDS = {"float32": "f4", "float16": "f2", "uint8": "f1", "int32": "i4", "uint32": "u4"}
_MAKERS = {"faces": "texture_cube", "layers": "texture_array", "volume": "texture3d"}


@dataclass(eq=False)
class ExampleTexture:
    """A texture: its texels, what they are (as ``load_pixels`` says), and how it is sampled.

    ``shrunk``: how many times smaller than the scene's it is, in each direction.
    """

    pixels: Array
    what: str
    spec: TextureSpec
    shrunk: int = 1

    @classmethod
    def of(cls, spec: TextureSpec) -> ExampleTexture:
        """The scene's texture. Raises as ``load_pixels``."""
        made = made_pixels(spec.path.name) if spec.generated else load_pixels(spec.path)
        return cls(*made, spec)

    @property
    def integers(self) -> bool:
        """Does it hold integers, which are never mixed?"""
        return self.kind in ("i4", "u4")

    @property
    def linear(self) -> bool:
        """Are texels mixed?"""
        return self.spec.filter == "linear" and not self.integers

    @property
    def mipmaps(self) -> bool:
        """Has it smaller copies?"""
        return self.spec.mipmap and not self.integers

    @property
    def kind(self) -> str:
        """What moderngl calls the type of its texels."""
        return _KINDS[self.pixels.dtype.name]

    @property
    def size(self) -> tuple[int, ...]:
        """Width and height, and of layers or a volume how many."""
        *deep, height, width, _ = self.pixels.shape
        return (width, height) if self.what == "faces" else (width, height, *deep)

    @property
    def is_large(self) -> bool:
        """May it be made smaller?"""
        return all(edge > SMALLEST for edge in self.pixels.shape[-3:-1])

    def shrink(self) -> None:
        """Halve its edges: means of four texels, or of integers one of them."""
        height, width = (edge // 2 * 2 for edge in self.pixels.shape[-3:-1])
        even = self.pixels[..., :height, :width, :]
        if self.integers:
            self.pixels = np.ascontiguousarray(even[..., ::2, ::2, :])
        else:
            *depth, _, _, channels = even.shape
            blocks = even.reshape(*depth, height // 2, 2, width // 2, 2, channels)
            mean = blocks.mean(axis=(-4, -2), dtype=np.float64)
            rounded = np.rint(mean) if even.dtype == np.uint8 else mean
            self.pixels = rounded.astype(even.dtype)
        self.shrunk *= 2


def texture_function(textures: Collection[ExampleTexture]) -> list[str]:
    """A function that makes targets, and these textures; nothing in it that none of them needs."""
    flags = {
        "data=None": bool(textures),
        "linear=False": any(texture.linear for texture in textures),
        "repeat=False": any(texture.spec.wrap == "repeat" for texture in textures),
        "mipmaps=False": any(texture.mipmaps for texture in textures),
        "anisotropy=1.0": any(texture.spec.anisotropy > 1.0 for texture in textures),
        "make=ctx.texture": any(texture.what != "pixels" for texture in textures),
    }
    given = ["size", "channels", "kind", *(flag for flag, used in flags.items() if used)]
    make = "make" if flags["make=ctx.texture"] else "ctx.texture"
    data, about = "", "to draw into; its texels are fetched one by one"
    if textures:
        data = ', data and DATA[f"textures/{data}"].tobytes()'
        about = "of the engine's, or one to draw into"
    low = "moderngl.LINEAR if linear else moderngl.NEAREST"
    lines = [
        *spread("def texture(", given, "):"),
        f'    """A texture {about}."""',
        f"    made = {make}(size, channels{data}, dtype=kind)",
    ]
    pair = "(moderngl.NEAREST,) * 2"
    if flags["linear=False"] or flags["mipmaps=False"]:
        lines.append(f"    low = high = {low if flags['linear=False'] else 'moderngl.NEAREST'}")
        pair = "(low, high)"
    if flags["mipmaps=False"]:
        linear = {texture.linear for texture in textures if texture.mipmaps}
        small = "moderngl.LINEAR_MIPMAP_LINEAR"
        if linear != {True}:
            small = f"{small} if linear else moderngl.NEAREST_MIPMAP_NEAREST"
        lines += ["    if mipmaps:", "        made.build_mipmaps()", f"        low = {small}"]
    repeat = "repeat" if flags["repeat=False"] else "False"
    if any(texture.what == "volume" for texture in textures):
        lines.append(f"    made.repeat_z = {repeat}")
    lines.append(f"    made.filter, made.repeat_x, made.repeat_y = {pair}, {repeat}, {repeat}")
    if flags["anisotropy=1.0"]:
        lines.append("    made.anisotropy = min(anisotropy, ctx.max_anisotropy)")
    return [*lines, "    return made"]


def texture_table(textures: Mapping[str, ExampleTexture]) -> list[str]:
    """What makes them, by their names."""
    entries = []
    for key, one in textures.items():
        given = [repr(one.size), str(one.pixels.shape[-1]), f'"{one.kind}"', f'"{key}"']
        given += ["linear=True"] * one.linear + ["repeat=True"] * (one.spec.wrap == "repeat")
        given += ["mipmaps=True"] * one.mipmaps
        if one.spec.anisotropy > 1.0 and one.what != "volume":
            given.append(f"anisotropy={one.spec.anisotropy!r}")
        if one.what in _MAKERS:
            given.append(f"make=ctx.{_MAKERS[one.what]}")
        entries.append(f'"{key}": texture({", ".join(given)})')
    return spread("TEXTURES = {", entries, "}")

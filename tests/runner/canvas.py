"""What all objects of a frame share; like the whole runner it knows nothing but the manifest."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import moderngl
import numpy as np

CHANNELS = {"r": 1, "rg": 2, "rgba": 4}
DTYPES = {"16f": "f2", "32f": "f4", "32ui": "u4"}
FILTERS = {"linear": moderngl.LINEAR, "nearest": moderngl.NEAREST}


class Canvas:
    """What all objects of a frame share: the target, its depth, and the two caches."""

    def __init__(
        self,
        ctx: moderngl.Context,
        size: tuple[int, int],
        cache: Mapping[str, Any],
        cache_format: str | None = None,
    ) -> None:
        """Args: ``cache`` as the manifest has it; ``cache_format`` replaces that of floats."""
        self.ctx = ctx
        self.layers = [cache, cache["second"]] if "second" in cache else [cache]
        self.caches = [self._textures(size, cache_format) for _ in range(cache["buffers"])]
        for texture in self.caches[0] + self.caches[1]:
            texture.filter = (FILTERS[cache["filter"]],) * 2
            texture.repeat_x = texture.repeat_y = False
        self.color = ctx.texture(size, 4, dtype="f4")
        self.depth = ctx.depth_renderbuffer(size)
        self.framebuffers: dict[tuple[int, ...], moderngl.Framebuffer] = {}
        self.over_screen: set[tuple[Path, str]] = set()

    def _textures(self, size: tuple[int, int], precision: str | None) -> list[moderngl.Texture]:
        """The textures of one cache; ``precision`` (a format) replaces that of floats."""
        made: list[moderngl.Texture] = []
        for layer in self.layers:
            channels, kind = re.fullmatch("([rgba]+)(.+)", layer["format"]).groups()
            if precision and kind.endswith("f"):
                kind = precision.removeprefix("rgba")
            made.append(self.ctx.texture(size, CHANNELS[channels], dtype=DTYPES[kind]))
        return made

    def begin(self, forgets: bool) -> None:
        """Clear what a frame begins with, and what the last one stored if it ``forgets`` that."""
        self.over_screen.clear()
        previous, current = self.caches
        if forgets:
            self._clear(previous)
        self._clear(current)
        framebuffer = self.framebuffer(self.color)
        framebuffer.depth_mask = True  # A pass may have left it off, and then nothing is cleared.
        framebuffer.clear(0.0, 0.0, 0.0, 0.0, depth=1.0)

    def holds(self, folder: Path, item: Mapping[str, Any]) -> bool:
        """Has this frame a pass over the screen already, since another object has drawn it?"""
        key = (folder, item["name"])
        if not over_screen(item) or key in self.over_screen:
            return over_screen(item)
        self.over_screen.add(key)
        return False

    def end(self) -> np.ndarray:
        """Swap the caches; the colours, (h, w, 4) float32 with row 0 at the bottom."""
        self.caches.reverse()
        width, height = self.color.size
        return np.frombuffer(self.color.read(), "f4").reshape(height, width, 4)

    def _clear(self, cache: list[moderngl.Texture]) -> None:
        for texture, layer in zip(cache, self.layers, strict=True):
            if texture.dtype == "u4":
                texel = np.array(layer["clear"][: texture.components], "u4")
                texture.write(np.tile(texel, texture.width * texture.height).tobytes())
            else:
                self.framebuffer(texture, depth=False).clear(*layer["clear"])

    def framebuffer(self, *textures: moderngl.Texture, depth: bool = True) -> moderngl.Framebuffer:
        """One with these textures, and the depth."""
        key = (depth, *(texture.glo for texture in textures))
        if key not in self.framebuffers:
            made = self.ctx.framebuffer(textures, self.depth if depth else None)
            self.framebuffers[key] = made
        return self.framebuffers[key]


def over_screen(item: Mapping[str, Any]) -> bool:
    """Does a pass draw one triangle over the screen in place of the objects?"""
    return item.get("draws") == "screen"

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
        manifest: Mapping[str, Any],
        cache_format: str | None = None,
    ) -> None:
        """Args: ``cache_format`` replaces that of floats."""
        self.ctx, cache = ctx, manifest["cache"]
        self.layers = [cache, cache["second"]] if "second" in cache else [cache]
        divisor = manifest["targets"]["cache"].get("divisor", 1)
        small = tuple(-(-edge // divisor) for edge in size)
        self.caches = [self._textures(small, cache_format) for _ in range(cache["buffers"])]
        for texture in self.caches[0] + self.caches[1]:
            texture.filter = (FILTERS[cache["filter"]],) * 2
            texture.repeat_x = texture.repeat_y = False
        self.written: dict[int, int] = {}
        self.outputs = {
            name: self._output(size, output["type"])
            for output in manifest["outputs"]
            for name in output["targets"]
        }
        self.color = self.outputs["color"]
        self.depths = {edges: ctx.depth_renderbuffer(edges) for edges in (size, small)}
        self.empty = [ctx.framebuffer((), depth) for depth in self.depths.values()]
        self.marks = ctx.depth_renderbuffer(size)
        # From pixels to texels: both viewports are the whole target, and begin at (0, 0).
        self.scale = (small[0] / size[0], small[1] / size[1], 0.0, 0.0)
        self.parked: dict[str, moderngl.Texture] = {}
        self.framebuffers: dict[tuple[Any, ...], moderngl.Framebuffer] = {}
        self.over_screen: set[tuple[Path, str]] = set()

    def _textures(self, size: tuple[int, int], precision: str | None) -> list[moderngl.Texture]:
        """The textures of one cache; ``precision`` (a format) replaces that of floats."""
        made: list[moderngl.Texture] = []
        for layer in self.layers:
            made.append(self._texture(size, layer["format"], precision))
        return made

    def _texture(
        self, size: tuple[int, int], form: str, precision: str | None = None
    ) -> moderngl.Texture:
        channels, kind = re.fullmatch("([rgba]+)(.+)", form).groups()
        if precision and kind.endswith("f"):
            kind = precision.removeprefix("rgba")
        return self.ctx.texture(size, CHANNELS[channels], dtype=DTYPES[kind])

    def _output(self, size: tuple[int, int], kind: str) -> moderngl.Texture:
        channels = int(kind.partition("[")[0][-1]) if "vec" in kind else 1
        dtype = {"i": "i4", "u": "u4"}.get(kind[0], "f4")
        made = self.ctx.texture(size, 4 if channels == 3 else channels, dtype=dtype)
        self.written[made.glo] = channels
        return made

    def park(self, targets: Mapping[str, Any]) -> dict[str, moderngl.Texture]:
        """What a pass parks for a later one, by name; ``targets`` as the manifest has it."""
        for name, target in targets.items():
            if name.startswith("parked") and name not in self.parked:
                self.parked[name] = self._texture(self.color.size, target["format"])
                self.parked[name].filter = (moderngl.NEAREST, moderngl.NEAREST)
        return self.parked

    def begin(self, forgets: bool) -> None:
        """Clear what a frame begins with, and what the last one stored if it ``forgets`` that."""
        self.over_screen.clear()
        previous, current = self.caches
        if forgets:
            self._clear(previous)
        self._clear(current)
        for framebuffer in self.empty:
            framebuffer.clear(depth=1.0)
        for texture in self.outputs.values():
            texture.write(bytes(4 * texture.components * texture.width * texture.height))

    def holds(self, folder: Path, item: Mapping[str, Any]) -> bool:
        """Has this frame a pass over the screen already, since another object has drawn it?"""
        key = (folder if item["targets"] else Path(), item["name"])
        if item.get("draws") != "screen" or key in self.over_screen:
            return item.get("draws") == "screen"
        self.over_screen.add(key)
        return False

    def end(self) -> np.ndarray:
        """Swap the caches; the outputs side by side, (h, w, 4 each) with row 0 at the bottom."""
        self.caches.reverse()
        return np.concatenate([self._read(texture) for texture in self.outputs.values()], axis=-1)

    def _read(self, texture: moderngl.Texture) -> np.ndarray:
        """The floats of an output, or those of an integer's bits; what it has not is filled."""
        width, height = texture.size
        raw = np.frombuffer(texture.read(), texture.dtype).reshape(height, width, -1)
        written = self.written[texture.glo]
        read = np.zeros((height, width, 4), raw.dtype)
        read[..., :written] = raw[..., :written]
        if written == 1:
            read[..., 1] = read[..., 2] = raw[..., 0]
        if written < 4:
            read[..., 3] = 1
        return read.view("f4")

    def _clear(self, cache: list[moderngl.Texture]) -> None:
        for texture, layer in zip(cache, self.layers, strict=True):
            if texture.dtype == "u4":
                texel = np.array(layer["clear"][: texture.components], "u4")
                texture.write(np.tile(texel, texture.width * texture.height).tobytes())
            else:
                self.framebuffer(texture, depth=False).clear(*layer["clear"])

    def framebuffer(
        self, *textures: moderngl.Texture, depth: bool = True, buffer: str = ""
    ) -> moderngl.Framebuffer:
        """One with these textures, and the depth of their size, or that of marks."""
        key = (depth, buffer, *(texture.glo for texture in textures))
        if key not in self.framebuffers:
            chosen = self.marks if buffer == "marks" else self.depths[textures[0].size]
            made = self.ctx.framebuffer(textures, chosen if depth else None)
            self.framebuffers[key] = made
        return self.framebuffers[key]


def over_screen(item: Mapping[str, Any]) -> bool:
    """Does a pass draw one triangle over the screen in place of the objects?"""
    return item.get("draws", "objects") != "objects"

"""Runs a variant from its folder alone: the proof that the manifest tells an engine enough.

This file imports nothing of shadercache. It knows what ``manifest.schema.json`` defines, and gets
from its caller what every engine has anyway: a mesh, textures, and the uniforms of each frame.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import moderngl
import numpy as np

CHANNELS = {"r": 1, "rg": 2, "rgba": 4}
DTYPES = {"16f": "f2", "32f": "f4", "32ui": "u4"}
DEPTH_TESTS = {"less": "<", "lequal": "<="}
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
        previous, current = self.caches
        if forgets:
            self._clear(previous)
        self._clear(current)
        self.framebuffer(self.color).clear(0.0, 0.0, 0.0, 0.0, depth=1.0)

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


class IndependentRunner:
    """One object, drawn frame by frame by one variant of one folder (or by the original)."""

    def __init__(
        self,
        ctx: moderngl.Context,
        folder: Path,
        algorithm: str,
        size: tuple[int, int],
        attributes: Mapping[str, np.ndarray],
        index: np.ndarray,
        textures: Mapping[str, moderngl.Texture | moderngl.TextureCube],
        cache_format: str | None = None,
        cull: bool = False,
        canvas: Canvas | None = None,
        number: int = 1,
    ) -> None:
        """Args: ``attributes`` maps vertex attributes to (n, c) float32, ``index`` is (m, 3).

        Both are of the engine's objects, which a full-screen variant does not draw. ``algorithm``
        may be ``original``. Objects of one picture share a ``canvas`` and have a ``number`` each.
        """
        self.ctx = ctx
        self.flags = moderngl.DEPTH_TEST | (moderngl.CULL_FACE if cull else 0)
        self.folder = folder
        self.manifest = json.loads((folder / "manifest.json").read_text())
        self.textures = textures
        self.roles = {item["name"]: item["role"] for item in self.manifest["uniforms"]}
        self.twins = {twin: name for name, twin in self.manifest["previous"].items()}
        self.buffers = {
            name: (ctx.buffer(array.astype("f4").tobytes()), f"{array.shape[1]}f")
            for name, array in attributes.items()
        }
        full_screen = self.manifest["draw"]["geometry"] == "full-screen triangle"
        self.vertices = self.manifest["draw"]["vertices"] if full_screen else -1
        self.index = None if full_screen else ctx.buffer(index.astype("u4").tobytes())
        self.canvas = canvas or Canvas(ctx, size, self.manifest["cache"], cache_format)
        self.number = number
        self.is_cached = algorithm != "original"
        if self.is_cached:
            found = next(v for v in self.manifest["variants"] if v["algorithm"] == algorithm)
            passes = found["passes"]
        else:
            passes = [self.manifest["original"]]
        self.passes = [(item, self._program(item)) for item in passes]
        self.last_values: Mapping[str, Any] | None = None

    def _program(self, item: Mapping[str, Any]) -> tuple[moderngl.Program, moderngl.VertexArray]:
        program = self.ctx.program(
            vertex_shader=(self.folder / item["vertex"]).read_text(),
            fragment_shader=(self.folder / item["fragment"]).read_text(),
        )
        content = [(*self.buffers[n], n) for n in item["attributes"] if n in program]
        return program, self.ctx.vertex_array(program, content, self.index)

    def reset(self) -> None:
        """The next frame is the first one again."""
        self.last_values = None

    def draw(self, frame: int, values: Mapping[str, Any], period: int, block: int) -> np.ndarray:
        """Draw a frame of nothing but this object, and return its colours.

        Args: ``values`` maps the user's uniforms to what moderngl takes as their value.
        """
        self.canvas.begin(forgets=self.last_values is None)
        for number in range(len(self.passes)):
            self.draw_pass(number, frame, values, period, block)
        self.last_values = dict(values)
        return self.canvas.end()

    def draw_pass(
        self, number: int, frame: int, values: Mapping[str, Any], period: int, block: int
    ) -> None:
        """Draw one pass, if the frame has it."""
        item, (program, array) = self.passes[number]
        on_reset = self.last_values is None
        if on_reset and not item["on_reset"]:
            return
        defaults = {item["role"]: item["default"] for item in self.manifest["uniforms"]}
        numbers = defaults | {"clock": frame % period, "period": period, "block": block}
        numbers |= {"reset": int(on_reset), "object": self.number}
        previous, current = self.canvas.caches
        targets = {"color": self.canvas.color, **_named("cache", current)}
        caches = {**_named("previous-cache", previous), **_named("current-cache", current)}
        self.ctx.enable_only(self.flags)
        framebuffer = self.canvas.framebuffer(*(targets[name] for name in item["targets"]))
        framebuffer.depth_mask = item["depth"]["write"]
        framebuffer.use()
        self.ctx.depth_func = DEPTH_TESTS[item["depth"]["test"]]
        self._set_uniforms(program, item["uniforms"], values, numbers, caches)
        array.render(vertices=self.vertices)

    def _set_uniforms(
        self,
        program: moderngl.Program,
        names: list[str],
        values: Mapping[str, Any],
        numbers: Mapping[str, Any],
        caches: Mapping[str, moderngl.Texture],
    ) -> None:
        last = values if self.last_values is None else self.last_values
        textures = {**self.textures, **{n: caches[r] for n, r in self.roles.items() if r in caches}}
        for unit, name in enumerate(n for n in names if n in program):
            if name in textures:
                textures[name].use(unit)
                program[name].value = unit
            elif name in self.roles:
                program[name].value = numbers[self.roles[name]]
            else:
                program[name].value = last[self.twins[name]] if name in self.twins else values[name]


class Turn(NamedTuple):
    """An object in a frame: its uniforms (None: it is not there), its period and block."""

    runner: IndependentRunner
    values: Mapping[str, Any] | None
    period: int
    block: int


def draw_together(frame: int, turns: Sequence[Turn]) -> np.ndarray:
    """Draw a frame of several objects that share a canvas, and return its colours.

    What is not cached comes first; all finish a pass before the next begins; an object that the
    last frame did not show draws the passes of a reset.
    """
    canvas = turns[0].runner.canvas
    canvas.begin(forgets=frame == 0)
    shown = [turn for turn in turns if turn.values is not None]
    shown.sort(key=lambda turn: turn.runner.is_cached)
    for number in range(max(len(turn.runner.passes) for turn in shown)):
        for turn in shown:
            if number < len(turn.runner.passes):
                turn.runner.draw_pass(number, frame, turn.values, turn.period, turn.block)
    for turn in turns:
        turn.runner.last_values = None if turn.values is None else dict(turn.values)
    return canvas.end()


def _named(name: str, cache: list[moderngl.Texture]) -> dict[str, moderngl.Texture]:
    """The textures of a cache as the manifest calls them."""
    return dict(zip((name, f"{name}-2"), cache, strict=False))

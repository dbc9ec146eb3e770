"""Runs a variant from its folder alone: the proof that the manifest tells an engine enough.

This file imports nothing of shadercache. It knows what ``manifest.schema.json`` defines, and gets
from its caller what every engine has anyway: a mesh, textures, and the uniforms of each frame.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import moderngl
import numpy as np
from runner.canvas import Canvas, over_screen
from runner.inputs import Given, Inputs

DEPTH_TESTS = {"less": "<", "lequal": "<=", "equal": "==", "always": "1"}


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
        self.inputs = Inputs(ctx, self.manifest, textures)
        self.buffers = {
            name: (ctx.buffer(array.astype("f4").tobytes()), f"{array.shape[1]}f")
            for name, array in attributes.items()
        }
        full_screen = self.manifest["draw"]["geometry"] == "full-screen triangle"
        self.vertices = self.manifest["draw"]["vertices"] if full_screen else -1
        self.index = None if full_screen else ctx.buffer(index.astype("u4").tobytes())
        self.canvas = canvas or Canvas(ctx, size, self.manifest, cache_format)
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
        index = None if over_screen(item) else self.index
        return program, self.ctx.vertex_array(program, content, index)

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
        if (on_reset and not item["on_reset"]) or self.canvas.holds(self.folder, item):
            return
        uniforms = self.manifest["uniforms"]
        numbers = {item["role"]: item["default"] for item in uniforms}
        numbers |= {"clock": frame % period, "period": period, "block": block}
        numbers |= {"object": self.number, "group": self.number, "scale": self.canvas.scale}
        if on_reset:
            numbers |= {i["role"]: i["on_reset"] for i in uniforms if "on_reset" in i}
        parked = self.canvas.park(self.manifest["targets"])
        previous, current = self.canvas.caches
        targets = {**self.canvas.outputs, **_named("cache", current), **parked}
        caches = parked | _named("previous-cache", previous) | _named("current-cache", current)
        self.ctx.enable_only(self.flags)
        used = (targets[name] for name in item["targets"])
        framebuffer = self.canvas.framebuffer(*used, buffer=item["depth"].get("buffer", ""))
        framebuffer.depth_mask = item["depth"]["write"]
        framebuffer.use()
        self.ctx.depth_func = DEPTH_TESTS[item["depth"]["test"]]
        given = Given(values, values if on_reset else self.last_values, numbers, caches)
        self.inputs.give(program, item["uniforms"], given)
        array.render(vertices=3 if over_screen(item) else self.vertices)


class Turn(NamedTuple):
    """An object in a frame: its uniforms (None: it is not there), its period and block."""

    runner: IndependentRunner
    values: Mapping[str, Any] | None
    period: int
    block: int


def draw_together(frame: int, turns: Sequence[Turn]) -> np.ndarray:
    """Draw a frame of several objects that share a canvas, and return its colours.

    What is not cached comes first; all finish a pass before the next begins, and passes over the
    screen are last; what the last frame did not show draws the passes of a reset.
    """
    canvas = turns[0].runner.canvas
    canvas.begin(forgets=frame == 0)
    shown = [turn for turn in turns if turn.values is not None]
    shown.sort(key=lambda turn: turn.runner.is_cached)
    due = [(turn, *one) for turn in shown for one in enumerate(turn.runner.passes)]
    for turn, number, _ in sorted(due, key=lambda one: (over_screen(one[2][0]), one[1])):
        turn.runner.draw_pass(number, frame, turn.values, turn.period, turn.block)
    for turn in turns:
        turn.runner.last_values = None if turn.values is None else dict(turn.values)
    return canvas.end()


def _named(name: str, cache: list[moderngl.Texture]) -> dict[str, moderngl.Texture]:
    """The textures of a cache as the manifest calls them."""
    return dict(zip((name, f"{name}-2"), cache, strict=False))

"""Draws shaders and compares the images: the child process of ``drawing.py``.

Each line of the standard input asks for one shader, as JSON; each line of the output answers. Both
programs get the same uniforms and textures, whose values depend on their names alone.
"""

from __future__ import annotations

import json
import signal
import sys
from contextlib import ExitStack, suppress
from typing import Any
from zlib import crc32

import moderngl
import numpy as np
from numpy.typing import NDArray

from bench.public_shaders.plain_vertex import POSITION
from shadercache.gpu.context import open_context

SECONDS = 20
"""A shader that takes longer hangs, and its process ends."""

SIZE = (32, 32)
_FORMATS = {"f": "f4", "i": "i4", "u": "u4"}
_TEXELS = 16
_STORAGE = 1 << 16  # Bytes of a storage block, whatever it would take.
_CORNERS = np.array([-1, -1, 1, -1, -1, 1, 1, 1], "f4")

# GL types of samplers: the sort of texture, and what its texels are.
_SAMPLERS = {
    **{0x8B5E: ("2D", "f4"), 0x8DCA: ("2D", "i4"), 0x8DD2: ("2D", "u4"), 0x8B62: ("depth", "f4")},
    **{0x8B5F: ("3D", "f4"), 0x8DCB: ("3D", "i4"), 0x8DD3: ("3D", "u4")},
    **{0x8B60: ("cube", "f4"), 0x8DCC: ("cube", "i4"), 0x8DD4: ("cube", "u4")},
    **{0x8DC1: ("array", "f4"), 0x8DCF: ("array", "i4"), 0x8DD7: ("array", "u4")},
}
_OTHER_HANDLES = (
    *(range(0x8B5D, 0x8B65), range(0x8DC0, 0x8DD9), range(0x9108, 0x910E)),
    *(range(0x900C, 0x9010), range(0x904C, 0x906D)),
)

Image = NDArray[np.generic]


class Painter:
    """One context that all shaders are drawn in."""

    def __init__(self) -> None:
        self._ctx = open_context().ctx
        self._corners = self._ctx.buffer(_CORNERS.tobytes())
        self._textures: dict[tuple[str, str], Any] = {}

    def compare(self, vertex: str, fragments: list[str], formats: str, integers: bool) -> Any:
        """Draw both fragments; whether the images are the same, and whether there is one at all.

        Raises moderngl's error where the driver refuses the first.
        """
        first = self._draw(vertex, fragments[0], formats, integers)
        try:
            second = self._draw(vertex, fragments[1], formats, integers)
        except moderngl.Error as error:
            return {"same": False, "why": f"the driver refuses our print: {_short(error)}"}
        wrong = [int(_differ(a, b).any(axis=-1).sum()) for a, b in zip(first, second, strict=True)]
        varied = any((image != image[:1, :1]).any() for image in first)
        why = f"pixels that differ by target, depth last: {wrong}" if any(wrong) else ""
        return {"same": not why, "varied": bool(varied), "why": why}

    def _draw(self, vertex: str, fragment: str, formats: str, integers: bool) -> list[Image]:
        ctx = self._ctx
        with ExitStack() as made:

            def keep(item: Any) -> Any:
                made.callback(item.release)
                return item

            program = keep(ctx.program(vertex_shader=vertex, fragment_shader=fragment))
            kinds = [_FORMATS[kind] for kind in formats]
            images = [keep(ctx.texture(SIZE, 4, dtype=kind)) for kind in kinds]
            depth = keep(ctx.depth_texture(SIZE))
            framebuffer = keep(ctx.framebuffer(images, depth))
            framebuffer.use()
            framebuffer.clear(depth=1.0)
            for image, kind in zip(images, kinds, strict=True):
                image.write(np.full((*SIZE, 4), 7, kind).tobytes())
            ctx.enable_only(moderngl.DEPTH_TEST)
            ctx.depth_func = "<="
            for buffer in self._fill(program, integers):
                keep(buffer)
            names = (POSITION,) if POSITION in program else ()
            array = keep(ctx.vertex_array(program, self._corners, *names))
            array.render(moderngl.TRIANGLE_STRIP, vertices=4)
            ctx.finish()
            pairs = [*zip(images, kinds, strict=True), (depth, "f4")]
            return [np.frombuffer(i.read(), kind).reshape(*SIZE, -1) for i, kind in pairs]

    def _fill(self, program: moderngl.Program, integers: bool) -> list[moderngl.Buffer]:
        """Give every uniform and block its value; returns the buffers."""
        made: list[moderngl.Buffer] = []
        unit = 0
        for name in sorted(program):
            member: Any = program[name]
            if isinstance(member, moderngl.Uniform):
                unit += self._set(name, member, unit)
            elif isinstance(member, moderngl.UniformBlock | moderngl.StorageBlock):
                size = getattr(member, "size", _STORAGE)  # Only uniform blocks have one.
                buffer = self._ctx.buffer(_block(name, size, integers))
                if isinstance(member, moderngl.UniformBlock):
                    buffer.bind_to_uniform_block(len(made))
                else:
                    buffer.bind_to_storage_buffer(len(made))
                member.binding = len(made)
                made.append(buffer)
        return made

    def _set(self, name: str, member: Any, unit: int) -> int:
        """Set a uniform; returns how many texture units it takes."""
        kind, length = member.gl_type, member.array_length
        if kind in _SAMPLERS:
            for offset in range(length):
                self._texture(*_SAMPLERS[kind]).use(unit + offset)
        if kind in _SAMPLERS or any(kind in handles for handles in _OTHER_HANDLES):
            member.write(np.arange(unit, unit + length, dtype="i4").tobytes())
            return int(length)
        count = member.dimension * length
        random = np.random.default_rng(crc32(name.encode()))
        with suppress(moderngl.Error):  # It cannot write integers of 64 bits, which so remain 0.
            if member.fmt[-1] in "fd":
                member.write(random.uniform(0.1, 1.0, count).astype(member.fmt[-1]).tobytes())
            else:
                member.write(random.integers(0, 4, count).astype("u4").tobytes())
        return 0

    def _texture(self, sort: str, dtype: str) -> Any:
        if (sort, dtype) not in self._textures:
            self._textures[sort, dtype] = self._make_texture(sort, dtype)
        return self._textures[sort, dtype]

    def _make_texture(self, sort: str, dtype: str) -> Any:
        ctx, size = self._ctx, (_TEXELS, _TEXELS)
        depth = {"3D": _TEXELS, "cube": 6, "array": 4}.get(sort, 1)
        random = np.random.default_rng(len(sort))
        shape = (depth, *size, 1 if sort == "depth" else 4)
        texels = random.uniform(0.0, 1.0, shape) if dtype == "f4" else random.integers(0, 4, shape)
        data = texels.astype(dtype).tobytes()
        if sort == "depth":
            shadow: Any = ctx.depth_texture(size, data)
            shadow.compare_func = "<="
            return shadow
        makers: dict[str, Any] = {
            "3D": ctx.texture3d,
            "cube": ctx.texture_cube,
            "array": ctx.texture_array,
        }
        extent = (*size, depth) if sort in ("3D", "array") else size
        made: Any = makers.get(sort, ctx.texture)(extent, 4, data, dtype=dtype)
        if dtype != "f4":
            made.filter = (moderngl.NEAREST, moderngl.NEAREST)
        return made


def _block(name: str, size: int, integers: bool) -> bytes:
    """The contents of a block. Where it holds integers all numbers are small ones, lest a loop that
    counts to one of them runs for ever."""
    random = np.random.default_rng(crc32(name.encode()))
    count = -(-size // 4)
    if integers:
        return random.integers(1, 4, count).astype("u4").tobytes()[:size]
    return random.uniform(0.1, 1.0, count).astype("f4").tobytes()[:size]


def _differ(one: Image, other: Image) -> NDArray[np.bool_]:
    """Where the bits differ, but that any NaN is as good as another."""
    wrong = np.asarray(one.view("u4") != other.view("u4"))
    if one.dtype.kind == "f":
        wrong &= ~(np.isnan(one) & np.isnan(other))
    return wrong


def _short(error: Exception) -> str:
    lines = [line for line in str(error).splitlines() if "error" in line.lower()]
    return (lines[0] if lines else str(error).strip().splitlines()[-1])[:200]


def main() -> None:
    """Answer until the input ends."""
    painter = Painter()
    for line in sys.stdin:
        job = json.loads(line)
        signal.alarm(SECONDS)  # Its default action ends the process, in whatever the driver is.
        try:
            answer = {"same": None, **job} if "why" in job else painter.compare(**job)
        except Exception as error:  # Whatever a driver or a shader does is an answer.
            answer = {"same": None, "why": f"{type(error).__name__}: {_short(error)}"}
        signal.alarm(0)
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()

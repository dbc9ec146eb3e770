"""Draws shaders and compares the images: the child process of ``rendering.py``.

Each line of the standard input asks for one shader, as JSON; each line of the output answers. The
process may hang or crash with a driver; its parent then starts another one.

Both programs get the same uniforms and textures, whose values depend on their names alone.
"""

from __future__ import annotations

import json
import sys
from contextlib import suppress
from typing import Any
from zlib import crc32

import moderngl
import numpy as np
from numpy.typing import NDArray

from bench.public_shaders.plain_vertex import POSITION
from shadercache.gpu.context import open_context

SIZE = (32, 32)
TARGETS = 8
_FORMATS = {"f": np.dtype("f4"), "i": np.dtype("i4"), "u": np.dtype("u4")}
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


class Painter:
    """One context with the targets that all shaders are drawn into."""

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
        same = all(_equal(one, other) for one, other in zip(first, second, strict=True))
        varied = any(
            len(np.unique(image.reshape(-1, image.shape[-1]), axis=0)) > 1 for image in first
        )
        return {"same": same, "varied": varied, "why": "" if same else _difference(first, second)}

    def _draw(
        self, vertex: str, fragment: str, formats: str, integers: bool
    ) -> list[NDArray[np.generic]]:
        ctx = self._ctx
        program = ctx.program(vertex_shader=vertex, fragment_shader=fragment)
        made: list[Any] = [program]
        try:
            images = [self._target(kind) for kind in formats]
            depth = ctx.depth_texture(SIZE)
            framebuffer = ctx.framebuffer(images, depth)
            made += [*images, depth, framebuffer]
            framebuffer.use()
            framebuffer.clear(depth=1.0)
            for image, kind in zip(images, formats, strict=True):
                image.write(np.full((*SIZE, 4), 7, _FORMATS[kind]).tobytes())
            ctx.enable_only(moderngl.DEPTH_TEST)
            ctx.depth_func = "<="
            made += self._fill(program, integers)
            array = ctx.vertex_array(program, self._corners, *self._attributes(program))
            made.append(array)
            array.render(moderngl.TRIANGLE_STRIP, vertices=4)
            ctx.finish()
            found = [
                np.frombuffer(image.read(), _FORMATS[kind]).reshape(*SIZE, 4)
                for image, kind in zip(images, formats, strict=True)
            ]
            return [*found, np.frombuffer(depth.read(), "f4").reshape(*SIZE, 1)]
        finally:
            for item in made:
                item.release()

    @staticmethod
    def _attributes(program: moderngl.Program) -> tuple[str, ...]:
        return (POSITION,) if POSITION in program else ()

    def _target(self, kind: str) -> moderngl.Texture:
        return self._ctx.texture(SIZE, 4, dtype=_FORMATS[kind].str[1:])

    def _fill(self, program: moderngl.Program, integers: bool) -> list[Any]:
        """Give every uniform and block its value; returns what has to be released."""
        made: list[Any] = []
        unit = binding = 0
        for name in sorted(program):
            member: Any = program[name]
            if isinstance(member, moderngl.Uniform):
                unit += self._set(name, member, unit)
                continue
            elif isinstance(member, moderngl.UniformBlock):
                buffer = self._ctx.buffer(_block(name, member.size, integers))
                buffer.bind_to_uniform_block(binding)
            elif isinstance(member, moderngl.StorageBlock):
                buffer = self._ctx.buffer(_block(name, _STORAGE, integers))
                buffer.bind_to_storage_buffer(binding)
            else:  # An attribute.
                continue
            member.binding = binding
            binding += 1
            made.append(buffer)
        return made

    def _set(self, name: str, member: Any, unit: int) -> int:
        """Set a uniform; returns how many texture units it takes."""
        kind = member.gl_type
        if kind in _SAMPLERS:
            for offset in range(member.array_length):
                self._texture(*_SAMPLERS[kind]).use(unit + offset)
        if kind in _SAMPLERS or any(kind in handles for handles in _OTHER_HANDLES):
            units = range(unit, unit + member.array_length)
            member.write(np.array(units, "i4").tobytes())
            return int(member.array_length)
        count = member.dimension * member.array_length
        random = np.random.default_rng(crc32(name.encode()))
        with suppress(moderngl.Error):  # It cannot write integers of 64 bits, which so remain 0.
            if member.fmt[-1] in "fd":
                member.write(random.uniform(0.1, 1.0, count).astype(member.fmt[-1]).tobytes())
            else:
                member.write(random.integers(0, 4, count).astype("u4").tobytes())
        return 0

    def _texture(self, sort: str, dtype: str) -> Any:
        found = self._textures.get((sort, dtype))
        if found is None:
            found = self._textures[sort, dtype] = self._make_texture(sort, dtype)
        return found

    def _make_texture(self, sort: str, dtype: str) -> Any:
        size = (_TEXELS, _TEXELS)
        depth = {"3D": _TEXELS, "cube": 6, "array": 4}.get(sort, 1)
        channels = 1 if sort == "depth" else 4
        random = np.random.default_rng(len(sort))
        shape = (depth, *size, channels)
        if dtype == "f4":
            data = random.uniform(0.0, 1.0, shape).astype("f4").tobytes()
        else:
            data = random.integers(0, 4, shape).astype(dtype).tobytes()
        match sort:
            case "depth":
                made: Any = self._ctx.depth_texture(size, data)
                made.compare_func = "<="
            case "3D":
                made = self._ctx.texture3d((*size, depth), 4, data, dtype=dtype)
            case "cube":
                made = self._ctx.texture_cube(size, 4, data, dtype=dtype)
            case "array":
                made = self._ctx.texture_array((*size, depth), 4, data, dtype=dtype)
            case _:
                made = self._ctx.texture(size, 4, data, dtype=dtype)
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


def _equal(one: NDArray[np.generic], other: NDArray[np.generic]) -> bool:
    """The same bits, but that any NaN is as good as another."""
    if one.dtype.kind == "f":
        return bool(
            ((one.view("u4") == other.view("u4")) | (np.isnan(one) & np.isnan(other))).all()
        )
    return bool((one == other).all())


def _difference(first: list[Any], second: list[Any]) -> str:
    places = zip(first, second, strict=True)
    counts = [int((one != other).any(axis=-1).sum()) for one, other in places]
    return f"pixels that differ by target, depth last: {counts}"


def _short(error: Exception) -> str:
    lines = [line for line in str(error).splitlines() if "error" in line.lower()]
    return (lines[0] if lines else str(error).strip().splitlines()[-1])[:200]


def main() -> None:
    """Answer until the input ends."""
    painter = Painter()
    for line in sys.stdin:
        job = json.loads(line)
        try:
            answer = painter.compare(**job)
        except Exception as error:  # Whatever a driver or a shader does is an answer.
            answer = {"same": None, "why": f"{type(error).__name__}: {_short(error)}"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()

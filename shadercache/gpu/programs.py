"""Programs, linked once for each pair of texts, and what they want as input."""

from __future__ import annotations

import re
from collections import Counter, OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import moderngl
import numpy as np

from shadercache.diagnostics import Diagnostic, InputError, input_error
from shadercache.gpu.context import Gpu
from shadercache.gpu.uniform_blocks import Uniform, UniformBuffer, block_uniforms
from shadercache.manifest.interface import InputEntry
from shadercache.source import Source, Span

# GL types of samplers and what moderngl must bind for them; others are told to be unsupported.
_SAMPLERS = {
    0x8B5E: "2D texture",
    0x8B5F: "3D texture",
    0x8B60: "cube map",
    0x8DC1: "array texture",
    0x8DCA: "2D texture of integers",
    0x8DCB: "3D texture of integers",
    0x8DCC: "cube map of integers",
    0x8DCF: "array texture of integers",
    0x8DD2: "2D texture of unsigned integers",
    0x8DD3: "3D texture of unsigned integers",
    0x8DD4: "cube map of unsigned integers",
    0x8DD7: "array texture of unsigned integers",
}
_IMAGES = {
    0x904D: "2D texture",
    0x904E: "3D texture",
    0x9053: "array texture",
    0x9058: "2D texture of integers",
    0x9059: "3D texture of integers",
    0x905E: "array texture of integers",
    0x9063: "2D texture of unsigned integers",
    0x9064: "3D texture of unsigned integers",
    0x9069: "array texture of unsigned integers",
}
_SAMPLER_RANGES = (range(0x8B5D, 0x8B64), range(0x8DC0, 0x8DD9), range(0x9108, 0x910E))
_IMAGE_RANGE = range(0x904C, 0x906D)
_FORMATS = {code: np.dtype(code) for code in "fiId"}

MOST_IDLE = 32
"""Unused programs that are kept: a node in proof and plain mode has twelve."""

# Our own comment names the pass and the node. Programs that differ in nothing else are one, and so
# are shaders to the driver's cache of compiled code, which goes by the text.
_HEADING = re.compile(r"^// shadercache: [^\\\n]*$", re.MULTILINE)

VERSION_HINT = (
    "'shadercache doctor' lists what the driver has; proof mode raises shaders to GLSL 4.00 or "
    "GLSL ES 3.20, where `precise` begins"
)

# "0:12(5): error: ..." (Mesa), "0(12) : error ..." (NVIDIA), "ERROR: 0:12: ..." (others).
_LOG_LINE = re.compile(r"^(?:ERROR: )?0[:(](\d+)(?:\((\d+)\))?[):]*\s*(.*)$", re.MULTILINE)


@dataclass(eq=False)
class Program:
    """A linked program with its active uniforms and vertex attributes.

    ``arrays`` are meshes as its input, each made when it is first drawn. ``storage``: storage
    buffers and where each is bound.
    """

    name: str
    gl: moderngl.Program
    uniforms: dict[str, Uniform]
    attributes: tuple[str, ...]
    blocks: tuple[UniformBuffer, ...] = ()
    storage: dict[str, int] = field(default_factory=dict)
    arrays: dict[tuple[int, ...], moderngl.VertexArray] = field(default_factory=dict)
    users: int = 0

    def bind_blocks(self) -> None:
        """Upload what has changed of the uniform blocks, and bind them."""
        for block in self.blocks:
            block.bind()

    def release(self) -> None:
        """Free the GL objects."""
        for array in self.arrays.values():
            array.release()
        for block in self.blocks:
            block.release()
        self.gl.release()


class Programs:
    """Linked programs of one render scene, shared by text and counted by user.

    Programs that nobody uses are kept for a while, the last used longest.
    """

    # A node is verified in several runs; compiling its programs anew for each would take most of
    # the time.

    def __init__(self, gpu: Gpu) -> None:
        self._gpu = gpu
        self._by_text: OrderedDict[tuple[str, str, str], Program] = OrderedDict()

    @property
    def used(self) -> int:
        """How many programs somebody uses."""
        return sum(program.users > 0 for program in self._by_text.values())

    @property
    def idle(self) -> int:
        """How many are kept although nobody uses them (at most ``MOST_IDLE``)."""
        return len(self._by_text) - self.used

    def acquire(
        self,
        vertex: Source,
        fragment: Source,
        inputs: Sequence[InputEntry] = (),
        captured: str = "",
        locations: Mapping[str, int] | None = None,
    ) -> Program:
        """The program of two shaders; call ``release`` with it once for every ``acquire``.

        ``inputs`` are what it declares, as the manifest has it. ``captured`` is a varying: the
        program is the vertex shader alone, and keeps that. ``locations``: of outputs that may have
        none in the text.

        Raises:
            InputError: SC602 with the driver's log, SC524 for inputs the harness cannot give.
        """
        # The line of the heading stays, so that the driver's line numbers are those of the file.
        key = (_HEADING.sub("//", vertex.text), _HEADING.sub("//", fragment.text), captured)
        program = self._by_text.get(key)
        if program is None:
            program = self._by_text[key] = _link(
                self._gpu.ctx, (vertex, fragment), key, inputs, locations or {}
            )
        program.users += 1
        self._by_text.move_to_end(key)
        return program

    def release(self, program: Program) -> None:
        """Give one use back."""
        program.users -= 1
        # In the order of their last use, the oldest in front.
        idle = [key for key, kept in self._by_text.items() if kept.users == 0]
        for key in idle[: max(0, len(idle) - MOST_IDLE)]:
            self._by_text.pop(key).release()

    def release_all(self) -> None:
        """Free every program, whoever still uses it."""
        for program in self._by_text.values():
            program.release()
        self._by_text.clear()


def _link(
    ctx: moderngl.Context,
    sources: tuple[Source, Source],
    texts: tuple[str, str, str],
    inputs: Sequence[InputEntry],
    locations: Mapping[str, int],
) -> Program:
    vertex, fragment = sources
    _check_names(fragment.name, inputs)
    try:
        if texts[2]:
            gl = ctx.program(vertex_shader=texts[0], varyings=(texts[2],))
        else:
            gl = ctx.program(
                vertex_shader=texts[0], fragment_shader=texts[1], fragment_outputs=dict(locations)
            )
    except moderngl.Error as error:
        raise _refused(str(error), vertex, fragment) from None
    uniforms: dict[str, Uniform] = {}
    attributes: list[str] = []
    buffers: dict[str, UniformBuffer] = {}
    storage: dict[str, int] = {}
    for name in gl:
        member: Any = gl[name]
        if isinstance(member, moderngl.Uniform):
            uniforms[name] = _uniform(fragment.name, name, member)
        elif isinstance(member, moderngl.Attribute):
            # Drivers list gl_VertexID and its like among the active attributes.
            if not name.startswith("gl_"):
                _check_attribute(vertex.name, name, member)
                attributes.append(name)
        elif isinstance(member, moderngl.UniformBlock):
            buffers[name] = UniformBuffer(ctx, member, len(buffers))
        elif isinstance(member, moderngl.StorageBlock):
            member.binding = storage[name] = len(storage)
    uniforms |= {
        uniform.name: uniform for uniform in block_uniforms(fragment.name, inputs, buffers)
    }
    blocks = tuple(buffers.values())
    return Program(fragment.name, gl, uniforms, tuple(attributes), blocks, storage)


def _uniform(shader: str, name: str, member: Any) -> Uniform:
    sampler, image = _SAMPLERS.get(member.gl_type), _IMAGES.get(member.gl_type)
    if sampler is None and any(member.gl_type in kinds for kinds in _SAMPLER_RANGES):
        given = "2D and 3D textures, cube maps and arrays of 2D textures only"
        raise input_error("SC524", f"{shader}: the harness gives {given}, {name} is none")
    if image is None and member.gl_type in _IMAGE_RANGE:
        given = "images of 2D and 3D textures and of arrays of 2D textures only"
        raise input_error("SC524", f"{shader}: the harness gives {given}, {name} is none")
    is_array = member.array_length > 1
    count = member.dimension * member.array_length
    dtype = _FORMATS[member.fmt[-1]]
    return Uniform(name, sampler, member.write, dtype, count, is_array, image)


def _check_names(shader: str, inputs: Sequence[InputEntry]) -> None:
    """moderngl knows what a program has by name alone, and hides an attribute behind a uniform."""
    for name, count in Counter(entry.name for entry in inputs).items():
        if count > 1:
            message = f"{shader}: the harness cannot give two inputs of the name {name}"
            hint = "an engine can, but to measure it here, rename one of them"
            raise input_error("SC524", message, hint)


def _check_attribute(shader: str, name: str, member: Any) -> None:
    # Of matrices moderngl tells all components, of doubles another shape.
    if member.shape not in "fi" or member.array_length > 1:
        given = "vectors and matrices of floats, and vectors of integers"
        message = f"{shader}: the harness gives {given}, attribute {name} is none"
        raise input_error("SC524", message)


def _refused(log: str, vertex: Source, fragment: Source) -> InputError:
    """The driver's words; each complaint with a line number is put at that line of the text."""
    # moderngl heads the log with the stage, underlined by equal signs.
    at_vertex = "vertex_shader" in log.split("=", 1)[0]
    source = vertex if at_vertex else fragment
    body = log.split("=\n", 1)[-1].strip()
    places = [
        Diagnostic(
            "SC602",
            f"the driver says: {complaint[3]}",
            source,
            _place(source, complaint),
            VERSION_HINT if "GLSL" in complaint[3] and "not supported" in complaint[3] else None,
        )
        for complaint in _LOG_LINE.finditer(body)
        if "warning" not in complaint[3].lower()
    ]
    if places:
        return InputError(places)
    words = " / ".join(line.strip() for line in body.splitlines() if line.strip())
    message = f"{vertex.name} + {fragment.name}: the driver refuses the program: {words}"
    return InputError(Diagnostic("SC602", message))


def _place(source: Source, complaint: re.Match[str]) -> Span:
    # moderngl strips the text before it compiles it, which moves the lines.
    text = source.text
    line = int(complaint[1]) + text[: len(text) - len(text.lstrip())].count("\n")
    lines = text.splitlines(keepends=True)
    start = sum(map(len, lines[: line - 1])) + max(0, int(complaint[2] or 1) - 1)
    return Span(start, start + 1)

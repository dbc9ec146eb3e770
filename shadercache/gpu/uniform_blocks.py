"""Uniforms of programs: those outside of blocks, and those that std140 lays out in blocks.

Members are known by the names that a shader uses: ``view`` of a block without an instance name,
``camera.view`` of one with, ``lights[1].color`` of structs in arrays.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import product
from math import prod
from typing import Any, Protocol

import moderngl
import numpy as np
from msgspec import UNSET, UnsetType
from numpy.typing import NDArray

from shadercache.diagnostics import input_error
from shadercache.lang.types import builtin_type
from shadercache.manifest.interface import InputEntry, MemberEntry, UniformBlockInput

_WORD = 4
_VEC4 = 16
# In a block a boolean is a whole word, true unless that is zero (OpenGL 4.6 section 7.6.2.1).
_DTYPES = {"float": "f4", "int": "i4", "uint": "u4", "bool": "i4"}


@dataclass(eq=False)
class Uniform:
    """One active uniform of a linked program, or member of a block, and the bytes it holds now.

    ``sampler`` and ``image``: the kind of texture that it takes, if it is one or the other.
    """

    name: str
    sampler: str | None
    upload: Callable[[bytes], None]
    dtype: np.dtype[Any]
    count: int
    is_array: bool
    image: str | None = None
    _written: bytes = b""

    def encode(self, values: NDArray[np.float64], giver: str) -> bytes:
        """The bytes of a value; ``giver`` is who provided it, for the message.

        Raises:
            InputError: SC523, the value has more or fewer components than the uniform.
        """
        # Drivers drop unused elements at the end of an array, so a longer value is right there.
        if values.size == self.count or (self.is_array and values.size > self.count):
            return values[: self.count].astype(self.dtype).tobytes()
        message = f"uniform {self.name} takes {self.count} numbers, but {giver} has {values.size}"
        raise input_error("SC523", message)

    def write(self, data: bytes) -> None:
        """Upload, unless the program holds these bytes already."""
        # GL keeps uniforms with the program, and all who share that share this object.
        if data != self._written:
            self.upload(data)
            self._written = data


class WordBuffer(Protocol):
    """What holds the words of a block; ``size`` in bytes."""

    size: int

    def write(self, words: list[int], data: bytes) -> None:
        """Set some words, which lie close together in ``data``."""


class UniformBuffer:
    """What a block holds. It is uploaded when it has changed and the program is drawn."""

    def __init__(self, ctx: moderngl.Context, block: moderngl.UniformBlock, binding: int) -> None:
        block.binding = binding
        self.size = int(block.size)
        self._binding = binding
        # Rounded up to whole words.
        self._words = np.zeros(-(-block.size // _WORD), np.uint32)
        self._buffer = ctx.buffer(self._words.tobytes())
        self._changed = False

    def write(self, words: list[int], data: bytes) -> None:
        """Set some words, which lie close together in ``data``."""
        self._words[words] = np.frombuffer(data, np.uint32)
        self._changed = True

    def bind(self) -> None:
        """Make it the block's buffer."""
        if self._changed:
            self._buffer.write(self._words.tobytes())
            self._changed = False
        # Binding points belong to the context, so each draw binds its own again.
        self._buffer.bind_to_uniform_block(self._binding)

    def release(self) -> None:
        """Free the buffer."""
        self._buffer.release()


def block_uniforms(
    shader: str, inputs: Iterable[InputEntry], buffers: Mapping[str, WordBuffer]
) -> Iterator[Uniform]:
    """The members of the blocks that a program has; a scene need not give those nobody reads.

    OpenGL 3.3 lists no offsets through moderngl; the manifest's ``inputs`` have them. ``buffers``
    are the program's, by the names of their blocks; ``shader`` is its name in messages.

    Raises:
        InputError: SC524 for a block that is not laid out as std140 lays out columns.
    """
    blocks = {entry.name: entry for entry in inputs if isinstance(entry, UniformBlockInput)}
    for name, buffer in buffers.items():
        # Each element of an array of blocks is a block of its own; moderngl calls the first by the
        # name of all.
        stem = name.partition("[")[0]
        block = blocks.get(stem)
        if block is None or not _is_usual(block, buffer.size):
            message = f"{shader}: the harness cannot fill the uniform block {name}"
            hint = "it fills blocks with layout(std140), by columns"
            raise input_error("SC524", message, hint)
        element = name.removeprefix(stem) or "[0]" * len(block.dims)
        prefix = f"{block.instance}{element}." if block.instance else ""
        for member in block.members:
            if member.read:
                yield from _leaves(prefix + member.name, buffer, member, 0)


def _is_usual(block: UniformBlockInput, size: int) -> bool:
    """Is it std140 by columns, with no places of its own, and as the driver has it?"""
    words = " ".join(member.layout or "" for member in block.members)
    placed = any(word in words for word in ("row_major", "offset", "align"))
    if block.packing != "std140" or block.matrices == "row_major" or placed:
        return False
    # Drivers may leave out what only fills up the last vec4.
    return block.size is not UNSET and block.size - _VEC4 < size <= block.size


def _leaves(name: str, buffer: WordBuffer, member: MemberEntry, start: int) -> Iterator[Uniform]:
    """The uniforms that a member is, as GL counts them: parts of structs are uniforms."""
    offset, step = start + _given(member.offset), _given(member.stride)
    # An innermost array of numbers is one uniform. Arrays around it, and those of structs, have one
    # for each element (OpenGL 4.6 section 7.3.1).
    whole = member.dims if member.members else member.dims[:-1]
    left = prod(member.dims[len(whole) :])
    for at, place in enumerate(product(*map(range, whole))):
        element = name + "".join(f"[{index}]" for index in place)
        # The stride is that of the innermost array, of which an outer step spans `left` elements.
        first = offset + at * left * step
        for inner in member.members:
            yield from _leaves(f"{element}.{inner.name}", buffer, inner, first)
        if not member.members:
            yield _numbers(element, buffer, member, first)


def _numbers(name: str, buffer: WordBuffer, member: MemberEntry, offset: int) -> Uniform:
    kind = builtin_type(member.type.partition("[")[0])
    if kind is None or kind.base not in _DTYPES:
        raise input_error("SC524", f"the harness cannot fill {name}: {member.type} in a block")
    # Where each number lies, in the order of upload: elements of arrays and columns of matrices
    # one after another.
    words = [
        (offset + element * _given(member.stride) + column * _given(member.matrix_stride)) // _WORD
        + row
        for element in range(member.dims[-1] if member.dims else 1)
        for column in range(kind.cols)
        for row in range(kind.rows)
    ]
    dtype = np.dtype(_DTYPES[kind.base])
    return Uniform(name, None, partial(buffer.write, words), dtype, len(words), bool(member.dims))


def _given(number: int | UnsetType) -> int:
    return 0 if number is UNSET else number

"""Uniform blocks: where std140 puts each member, and the buffer that holds them.

OpenGL 3.3 lists no offsets through moderngl; the manifest has them. Members are told apart by the
names a shader uses: ``view`` of a block without an instance name, ``camera.view`` of one with,
``lights[1].color`` of structs in arrays.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from math import prod

import moderngl
import numpy as np
from msgspec import UNSET, UnsetType

from shadercache.diagnostics import input_error
from shadercache.lang.types import builtin_type
from shadercache.manifest.interface import InputEntry, MemberEntry, UniformBlockInput

PACKING = "std140"
_WORD = 4
_VEC4 = 16
_DTYPES = {"float": "f4", "int": "i4", "uint": "u4", "bool": "i4"}


@dataclass(frozen=True, slots=True)
class BlockNumbers:
    """Numbers of one type in a block.

    ``words``: where each lies, in words of four bytes, in the order in which uniforms are uploaded
    (columns of matrices, elements of arrays one after another).
    """

    name: str
    block: str
    dtype: np.dtype[np.generic]
    words: tuple[int, ...]
    is_array: bool


class UniformBuffer:
    """What a block holds. It is uploaded when it has changed and the program is drawn."""

    def __init__(self, ctx: moderngl.Context, block: moderngl.UniformBlock, binding: int) -> None:
        block.binding = binding
        self._binding = binding
        self._words = np.zeros(-(-block.size // _WORD), np.uint32)
        self._buffer = ctx.buffer(self._words.tobytes())
        self._changed = False

    def write(self, words: tuple[int, ...], data: bytes) -> None:
        """Set some words."""
        self._words[list(words)] = np.frombuffer(data, np.uint32)
        self._changed = True

    def bind(self) -> None:
        """Make it the block's buffer."""
        if self._changed:
            self._buffer.write(self._words.tobytes())
            self._changed = False
        self._buffer.bind_to_uniform_block(self._binding)

    def release(self) -> None:
        """Free the buffer."""
        self._buffer.release()


@dataclass(frozen=True, slots=True)
class BufferPlace:
    """A member's part of the buffer; written as a uniform is."""

    buffer: UniformBuffer
    words: tuple[int, ...]

    def write(self, data: bytes) -> None:
        """Set the member's numbers, which lie close together in ``data``."""
        self.buffer.write(self.words, data)


def blocks_of(inputs: Iterable[InputEntry]) -> tuple[UniformBlockInput, ...]:
    """The uniform blocks among what an engine gives."""
    return tuple(item for item in inputs if isinstance(item, UniformBlockInput))


def members_of(
    shader: str, blocks: Iterable[UniformBlockInput], sizes: Mapping[str, int]
) -> list[BlockNumbers]:
    """The numbers of the blocks that a program has; a scene need not give those that nobody reads.

    Args:
        shader: the program's name in messages.
        sizes: the driver's size of each block in bytes.

    Raises:
        InputError: SC524 for a block that is not laid out as std140 lays out columns.
    """
    found: list[BlockNumbers] = []
    told = {block.name: block for block in blocks}
    for name, size in sizes.items():
        block = told.get(name)
        if block is None or not _is_usual(block, size):
            message = f"{shader}: the harness cannot fill the uniform block {name}"
            hint = "it fills blocks with layout(std140), by columns, and not in arrays"
            raise input_error("SC524", message, hint)
        prefix = f"{block.instance}." if block.instance else ""
        for member in block.members:
            if member.read:
                found += _leaves(prefix + member.name, name, member, 0)
    return found


def _is_usual(block: UniformBlockInput, size: int) -> bool:
    """Is it std140 by columns, with no places of its own, and as the driver has it?"""
    words = " ".join(member.layout or "" for member in block.members)
    placed = any(word in words for word in ("row_major", "offset", "align"))
    if block.dims or block.packing != PACKING or block.matrices == "row_major" or placed:
        return False
    # Drivers may leave out what only fills up the last vec4.
    return block.size is not UNSET and block.size - _VEC4 < size <= block.size


def _leaves(name: str, block: str, member: MemberEntry, start: int) -> Iterator[BlockNumbers]:
    """The uniforms that a member is, as GL counts them: parts of structs are uniforms."""
    offset, step = start + _given(member.offset), _given(member.stride)
    whole = member.dims if member.members else member.dims[:-1]
    left = prod(member.dims[len(whole) :])
    for at, place in enumerate(product(*map(range, whole))):
        element = name + "".join(f"[{index}]" for index in place)
        first = offset + at * left * step
        for inner in member.members:
            yield from _leaves(f"{element}.{inner.name}", block, inner, first)
        if not member.members:
            yield _numbers(element, block, member, first)


def _numbers(name: str, block: str, member: MemberEntry, offset: int) -> BlockNumbers:
    kind = builtin_type(member.type.partition("[")[0])
    if kind is None or kind.base not in _DTYPES:
        raise input_error("SC524", f"the harness cannot fill {name}: {member.type} in a block")
    words = tuple(
        (offset + element * _given(member.stride) + column * _given(member.matrix_stride)) // _WORD
        + row
        for element in range(member.dims[-1] if member.dims else 1)
        for column in range(kind.cols)
        for row in range(kind.rows)
    )
    return BlockNumbers(name, block, np.dtype(_DTYPES[kind.base]), words, bool(member.dims))


def _given(number: int | UnsetType) -> int:
    return 0 if number is UNSET else number

"""Uniform blocks: where std140 puts each member, and the buffer that holds them.

OpenGL 3.3 lists no offsets through moderngl, so they are computed from the declaration (section
2.11.4). Members are told apart by the names a shader uses: ``view`` of a block without an instance
name, ``camera.view`` of one with, ``lights[1].color`` of structs in arrays.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import moderngl
import numpy as np

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import input_error
from shadercache.front.parse import parse
from shadercache.lang.block_layout import alignment
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import infer
from shadercache.source import Source

PACKING = "std140"
_WORD = 4
_COLUMN = 16  # bytes from one column of a matrix to the next
_DTYPES = {"float": "f4", "int": "i4", "uint": "u4", "bool": "i4"}


@dataclass(frozen=True, slots=True)
class Member:
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
class Place:
    """A member's part of the buffer; written as a uniform is."""

    buffer: UniformBuffer
    words: tuple[int, ...]

    def write(self, data: bytes) -> None:
        """Set the member's numbers, which lie close together in ``data``."""
        self.buffer.write(self.words, data)


def members_of(stages: tuple[tuple[Source, Stage], ...], sizes: dict[str, int]) -> list[Member]:
    """The members, of the blocks that a program has, that its shaders name.

    Args:
        sizes: the driver's size of each block in bytes.

    Raises:
        InputError: SC524 for a block that is not laid out as std140 lays out columns.
    """
    found: dict[str, Member] = {}
    for source, stage in stages:
        module = parse(source)
        facts = infer(module, source, stage)
        for decl in module.decls:
            if isinstance(decl, n.BlockDecl) and decl.name in sizes:
                found |= {
                    member.name: member for member in _members(decl, module, facts, sizes, source)
                }
    return list(found.values())


def _members(
    decl: n.BlockDecl, module: n.Module, facts: Facts, sizes: dict[str, int], source: Source
) -> Iterator[Member]:
    fields = block_fields(decl, facts)
    end, places = 0, {}
    for name, kind in fields.items():
        unit, size = alignment(kind, PACKING)
        places[name] = -(-end // unit) * unit
        end = places[name] + size
    agrees = end <= sizes[decl.name] <= -(-end // _COLUMN) * _COLUMN
    if decl.dims or not _is_usual(decl, module) or not agrees:
        message = f"{source.name}: the harness cannot fill the uniform block {decl.name}"
        hint = "it fills blocks with layout(std140), by columns, and not in arrays"
        raise input_error("SC524", message, hint)
    prefix = f"{decl.instance}." if decl.instance else ""
    for name in sorted(_used(decl, module, facts), key=list(fields).index):
        yield from _leaves(prefix + name, decl.name, fields[name], places[name])


def block_fields(decl: n.BlockDecl, facts: Facts) -> dict[str, Type]:
    """The members of a block and their types, in order."""
    if decl.instance is not None:
        kind = facts.declared[decl].type
        assert kind.struct is not None
        return dict(kind.struct.fields)
    nodes = [node for field in decl.fields for node in field.declarators]
    return {node.name: facts.declared[node].type for node in nodes}


def _is_usual(decl: n.BlockDecl, module: n.Module) -> bool:
    """Is it std140 by columns, with no places of its own? By itself, or as all blocks are."""
    general = (
        item.qualifiers
        for item in module.decls
        if isinstance(item, n.QualifierDecl) and item.qualifiers.has("uniform")
    )
    own = (decl.qualifiers, *(field.qualifiers for field in decl.fields))
    words = [item.name for layout in (*general, *own) for item in layout.layout or ()]
    packings = [word for word in words if word in ("std140", "std430", "shared", "packed")]
    return packings[-1:] == [PACKING] and not {"row_major", "offset", "align"} & set(words)


def _used(decl: n.BlockDecl, module: n.Module, facts: Facts) -> set[str]:
    """The members that something reads: a scene need not give the others."""
    if decl.instance is None:
        return {s.name for s in facts.symbols.values() if s.block is decl and s.kind != "block"}
    own = facts.declared[decl]
    return {
        node.name
        for node in walk(module)
        if isinstance(node, n.Member)
        and isinstance(node.object, n.Name)
        and facts.symbols.get(node.object) is own
    }


def _leaves(name: str, block: str, kind: Type, offset: int) -> Iterator[Member]:
    """The uniforms that a member is, as GL counts them: parts of structs are uniforms."""
    if kind.is_array and (kind.element.is_array or kind.struct is not None):
        step = alignment(kind, PACKING)[1] // (kind.dims[0] or 1)
        for at in range(kind.dims[0] or 1):
            yield from _leaves(f"{name}[{at}]", block, kind.element, offset + at * step)
    elif kind.struct is not None:
        for field, inner in kind.struct.fields.items():
            unit, size = alignment(inner, PACKING)
            offset = -(-offset // unit) * unit
            yield from _leaves(f"{name}.{field}", block, inner, offset)
            offset += size
    elif kind.base not in _DTYPES:
        raise input_error("SC524", f"the harness cannot fill {name}: {kind} in a block")
    else:
        dtype = np.dtype(_DTYPES[kind.base])
        yield Member(name, block, dtype, tuple(_words(kind, offset)), kind.is_array)


def _words(kind: Type, offset: int) -> Iterator[int]:
    count = (kind.dims[0] or 1) if kind.is_array else 1
    step = alignment(kind, PACKING)[1] // count
    for element in range(count):
        for column in range(kind.cols):
            first = (offset + element * step + column * _COLUMN) // _WORD
            yield from range(first, first + kind.rows)

"""The values that shaders of the example get, frame by frame, as tables."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.manifest.interface import MemberEntry, UniformBlockInput, UniformInput
from shadercache.report.hand_over.example.block_bytes import block_bytes
from shadercache.report.hand_over.handed_shaders import HandedShader
from shadercache.scene.camera import Values
from shadercache.scene.object_inputs import root_of

Array: TypeAlias = NDArray[Any]

_TYPES = {"u": "u4", "i": "i4", "b": "i4", "d": "f8"}


def declared(shader: HandedShader) -> set[str]:
    """The names of all attributes, uniforms, textures and blocks that its programs declare."""
    entries = (*shader.passes, shader.manifest.original)
    return {name for one in entries for name in (*one.uniforms, *one.attributes)}


def dtype_of(glsl: str) -> str:
    """The type of the numbers that a GLSL type is made of."""
    return _TYPES.get(glsl[0], "f4")


def uniform_tables(shader: HandedShader, values: Sequence[Sequence[Values]]) -> dict[str, Array]:
    """A table for each uniform outside of blocks, and for each block one of its bytes.

    ``values`` of each object at each frame. A table is (objects or 1, frames or 1, numbers): 1
    where all are the same.
    """
    names = declared(shader)
    tables: dict[str, Array] = {}
    for entry in shader.inputs:
        if entry.name not in names or getattr(entry, "previous_of", None):
            continue
        if isinstance(entry, UniformInput):
            for name, kind in _leaves(entry, values[0][0]):
                rows = [[at[name] for at in frames] for frames in values]
                tables[name] = collapsed(np.array(rows).astype(kind))
        elif isinstance(entry, UniformBlockInput):
            blocks = [[block_bytes(entry, at, shader.title) for at in frames] for frames in values]
            tables[entry.name] = collapsed(np.array(blocks))
    return tables


def twin_names(shader: HandedShader, names: Collection[str]) -> dict[str, str]:
    """Twin -> what it is that of, among ``names``, as GL names them: parts of structs are
    uniforms."""
    previous = shader.variant.previous if shader.variant else {}
    return {
        twin + name[len(root) :]: name
        for root, twin in previous.items()
        for name in names
        if root_of(name) == root
    }


def collapsed(table: Array) -> Array:
    """The table with one row for all objects or frames that are the same."""
    for axis in (0, 1):
        first = table.take([0], axis)
        if np.array_equal(np.broadcast_to(first, table.shape), table):
            table = first
    return np.ascontiguousarray(table)


def _leaves(entry: UniformInput, values: Values) -> Iterator[tuple[str, str]]:
    """The uniforms that a variable is, those that have values, with the types of their numbers."""
    for name in values:
        if root_of(name) == entry.name:
            yield name, dtype_of(_leaf_type(entry, name))


def _leaf_type(entry: UniformInput | MemberEntry, name: str) -> str:
    """The type of a part: that of ``lights[1].color``, asked of ``lights``."""
    for member_name in re.findall(r"\.(\w+)", name):
        entry = next(member for member in entry.members if member.name == member_name)
    return entry.type

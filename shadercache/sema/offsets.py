"""Offsets of the members of blocks (GLSL 4.60 section 4.4.5; OpenGL 4.6 section 7.6.2.2)."""

from __future__ import annotations

from collections.abc import Mapping
from math import prod

from shadercache.ast.nodes import BlockDecl
from shadercache.lang.types import Type
from shadercache.sema.check_context import ERROR, Context

_ALIGNED = ("std140", "std430")
_VEC4 = 16


def check_offsets(
    block: BlockDecl,
    packing: str,
    shared_align: int | None,
    fields: Mapping[str, Type],
    members: list[dict[str, int]],
    context: Context,
) -> None:
    """Offsets and alignments stand in ``std140`` and ``std430`` blocks, and grow."""
    given = [values for values in members if "offset" in values or "align" in values]
    if (given or shared_align) and packing not in _ALIGNED:
        message = "'offset' and 'align' are for blocks with the layout std140 or std430"
        context.error("SC223", message, block)
        return
    end = 0
    for decl, values in zip(block.fields, members, strict=True):
        for node in decl.declarators:
            kind = fields[node.name]
            if kind is ERROR or kind.components is None:
                return
            unit, size = alignment(kind, packing)
            align = values.get("align", shared_align or 0)
            if align & (align - 1):
                context.error("SC223", f"an alignment is a power of 2, not {align}", decl)
            if "offset" in values:
                problem = _offset_problem(values["offset"], unit, end, node.name, kind)
                if problem is not None:
                    context.error("SC223", problem, node)
                end = max(end, values["offset"])
            step = max(unit, align)
            end = -(-end // step) * step + size


def _offset_problem(offset: int, unit: int, end: int, name: str, kind: Type) -> str | None:
    if offset % unit:
        return f"the offset of {kind} is a multiple of {unit}, not {offset}"
    if offset < end:
        return f"'{name}' at the offset {offset} lies in members before it"
    return None


def alignment(kind: Type, packing: str) -> tuple[int, int]:
    """Alignment and size in bytes; matrices count as stored by columns."""
    if kind.dims:
        unit, size = alignment(_element(kind), packing)
        unit = max(unit, _VEC4) if packing == "std140" else unit
        return unit, -(-size // unit) * unit * prod(n or 1 for n in kind.dims)
    if kind.struct is not None:
        units = [alignment(field, packing) for field in kind.struct.fields.values()]
        unit = max(unit for unit, _ in units)
        unit = max(unit, _VEC4) if packing == "std140" else unit
        end = 0
        for step, size in units:
            end = -(-end // step) * step + size
        return unit, -(-end // unit) * unit
    scalar = 8 if kind.base in ("double", "int64_t", "uint64_t") else 4
    unit = scalar * (4 if kind.rows == 3 else kind.rows)
    if kind.cols > 1:
        unit = max(unit, _VEC4) if packing == "std140" else unit
        return unit, unit * kind.cols
    return unit, scalar * kind.rows


def _element(kind: Type) -> Type:
    """What an array of arrays holds in the end."""
    while kind.dims:
        kind = kind.element
    return kind

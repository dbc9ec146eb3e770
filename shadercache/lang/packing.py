"""How std140 and std430 lay out a block (OpenGL 4.6 section 7.6.2.2)."""

from __future__ import annotations

from math import prod

from shadercache.lang.types import Type

_VEC4 = 16


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

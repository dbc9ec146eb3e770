"""Where std140 and std430 put what is in a block (OpenGL 4.6 section 7.6.2.2)."""

from __future__ import annotations

from math import prod

from shadercache.lang.types import Type

LAID_OUT = ("std140", "std430")
_VEC4 = 16
_BYTES = {
    **dict.fromkeys(("double", "int64_t", "uint64_t"), 8),
    **dict.fromkeys(("float16_t", "int16_t", "uint16_t"), 2),
    **dict.fromkeys(("int8_t", "uint8_t"), 1),
}
"""Of scalars that have not four."""


def alignment(kind: Type, packing: str, by_rows: bool = False) -> tuple[int, int]:
    """Alignment and size in bytes; ``by_rows``: are matrices stored row by row?"""
    if kind.dims:
        unit, size = alignment(innermost(kind), packing, by_rows)
        unit = _rounded(unit, packing)
        # An array without a size ends its block, so it does not matter where it ends itself.
        return unit, up(size, unit) * prod(n or 1 for n in kind.dims)
    if kind.struct is not None:
        units = [alignment(field, packing, by_rows) for field in kind.struct.fields.values()]
        # A struct is aligned as its widest member, and padded to that at its end (rule 9).
        unit = _rounded(max(unit for unit, _ in units), packing)
        end = 0
        for step, size in units:
            end = up(end, step) + size
        return unit, up(end, unit)
    scalar = _BYTES.get(kind.base or "", 4)
    if kind.cols > 1:
        # A matrix is laid out as an array of its columns, or of its rows (rules 5 and 7).
        vectors, numbers = (kind.rows, kind.cols) if by_rows else (kind.cols, kind.rows)
        unit = _rounded(_vector(scalar, numbers), packing)
        return unit, unit * vectors
    return _vector(scalar, kind.rows), scalar * kind.rows


def strides(kind: Type, packing: str, by_rows: bool = False) -> tuple[int | None, int | None]:
    """Bytes from one element of the innermost array to the next, and from one column of a matrix
    to the next (``by_rows``: one row)."""
    inner = innermost(kind)
    unit, size = alignment(inner, packing, by_rows)
    stride = up(size, _rounded(unit, packing)) if kind.dims else None
    return stride, unit if inner.cols > 1 else None


def innermost(kind: Type) -> Type:
    """What an array of arrays holds in the end."""
    while kind.dims:
        kind = kind.element
    return kind


def up(offset: int, unit: int) -> int:
    """The next multiple of a unit."""
    return -(-offset // unit) * unit


def _vector(scalar: int, numbers: int) -> int:
    # Three components are aligned as four are (rule 3).
    return scalar * (4 if numbers == 3 else numbers)


def _rounded(unit: int, packing: str) -> int:
    """Arrays, structs and matrices begin at multiples of a vec4, but for std430."""
    return max(unit, _VEC4) if packing == "std140" else unit

"""Values of constant expressions: literals, operators, constructors.

A value is a ``bool``, ``int`` or ``float``, or a tuple: of the components of a vector, the columns
of a matrix, the elements of an array, the fields of a struct. ``None`` stands for a value that is
not known. Integers wrap at their size, floats are rounded to 32 bits; a driver may round the last
bit of a built-in function otherwise.
"""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from typing import Any, TypeAlias

from shadercache.lang import types as lang
from shadercache.lang.types import BOOL, DOUBLE, FLOAT, HALF, Type
from shadercache.sema.facts import Scalar

Value: TypeAlias = "Scalar | tuple[Value, ...]"

MAX_COMPONENTS = 1 << 16
"""Scalars of a value that is kept: structs of structs can ask for billions."""

_FLOATS = {"float": struct.Struct("f"), "float16_t": struct.Struct("e")}
_BITS = {
    **{"int": 32, "uint": 32, "int64_t": 64, "uint64_t": 64},
    **{"int16_t": 16, "uint16_t": 16, "int8_t": 8, "uint8_t": 8},
}
_SIGNED = ("int", "int64_t", "int16_t", "int8_t")
_INTEGERS = {
    **{"": lang.INT, "u": lang.UINT, "l": lang.INT64, "ul": lang.UINT64},
    **{"s": lang.INT16, "us": lang.UINT16},
}


@lru_cache(1 << 12)
def literal(text: str) -> tuple[Type, Scalar | None]:
    """Type and value of a literal; ``None`` for an integer that needs more bits than it has."""
    if text in ("true", "false"):
        return BOOL, text == "true"
    low = text.lower()
    if low.endswith("lf") and not low.startswith("0x"):
        return DOUBLE, float(low[:-2])
    if low.endswith("hf") and not low.startswith("0x"):
        return HALF, convert(float(low[:-2]), "float16_t")
    if not low.startswith("0x") and any(char in low for char in ".ef"):
        return FLOAT, convert(float(low.removesuffix("f")), "float")
    digits = low.rstrip("uls")
    kind = _INTEGERS[low[len(digits) :]]
    # Python writes octal numbers as `0o17`, and refuses `017`.
    octal = digits.startswith("0") and digits.isdigit()
    value = int(digits, 8) if octal and len(digits) > 1 else int(digits, 0)
    if value >= 1 << _BITS[kind.name]:
        return kind, None
    # A literal above 2^31 has its bit pattern (section 4.1.3), so 0xFFFFFFFF is -1.
    return kind, wrap(value, kind.name)


def wrap(value: int, base: str) -> int:
    """``value`` in the bits of an integer type."""
    limit = 1 << _BITS[base]
    value &= limit - 1
    return value - limit if base in _SIGNED and value >= limit // 2 else value


def convert(value: Scalar, base: str | None) -> Scalar | None:
    """One scalar as another scalar type; ``None`` where the result is undefined."""
    if base == "bool":
        return bool(value)
    if base == "double":
        return float(value)
    if base in _FLOATS:
        try:
            return float(_FLOATS[base].unpack(_FLOATS[base].pack(value))[0])
        except OverflowError:
            # A literal too large for a float is infinite (4.60 section 4.1.4), and so is a result.
            return math.copysign(math.inf, value)
    base = base or "int"
    limit = 1 << _BITS[base]
    low, high = (-limit // 2, limit // 2) if base in _SIGNED else (0, limit)
    # In this form the test also holds for a NaN.
    if isinstance(value, float) and not low <= value < high:
        return None
    return wrap(int(value), base)


def flattened(value: Value) -> Iterator[Scalar]:
    """The scalars of a value in order."""
    if isinstance(value, tuple):
        for part in value:
            yield from flattened(part)
    else:
        yield value


def _quotient(left: Any, right: Any) -> Any:
    if isinstance(left, int):
        # `//` rounds down, GPUs round towards zero.
        whole = abs(left) // abs(right)
        return whole if (left < 0) == (right < 0) else -whole
    return left / right


def _remainder(left: int, right: int) -> int:
    # Undefined for a negative operand (section 5.9).
    if left < 0 or right < 0:
        raise ArithmeticError
    return left % right


def _too_far(steps: Value, kind: Type) -> bool:
    """Is a number shifted by more than its bits, which is undefined (section 5.9)?"""
    bits = min(32, _BITS.get(kind.base or "", 32))
    return not all(0 <= step < bits for step in flattened(steps))


def _shift(left: int, right: int, sign: int) -> int:
    return left << right if sign > 0 else left >> right


_BINARY: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": _quotient,
    "%": _remainder,
    "<<": lambda left, right: _shift(left, right, 1),
    ">>": lambda left, right: _shift(left, right, -1),
    "&": operator.and_,
    "|": operator.or_,
    "^": operator.xor,
    "&&": lambda a, b: a and b,
    "||": lambda a, b: a or b,
    "^^": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
}

_UNARY: Mapping[str, Callable[[Any], Any]] = {
    "+": lambda a: a,
    "-": operator.neg,
    "~": operator.invert,
    "!": operator.not_,
}


def fold_unary(op: str, value: Value, kind: Type) -> Value | None:
    """``op value``; not for ``++`` and ``--``."""
    return mapped(_UNARY[op], (value,), kind.base)


def fold_binary(
    op: str,
    values: tuple[Value, Value],
    operands: tuple[Type, Type],
    base: str | None,
    kind: Type,
) -> Value | None:
    """An operator on two values of the types ``operands``, with a result of type ``kind``; both are
    first converted to scalar ``base``."""
    left, right = values
    if op in ("<<", ">>") and _too_far(right, kind):
        return None
    # The operands of a shift need not agree: the result has the type of the left one (section 5.9).
    if base is not None and op not in ("<<", ">>"):
        one, two = converted(left, base), converted(right, base)
        if one is None or two is None:
            return None
        left, right = one, two
    if op in ("==", "!="):
        return (left == right) == (op == "==")
    if op == "*" and any(operand.is_matrix for operand in operands):
        product = _product(left, right, *operands)
        if product is not None:
            return converted(product, kind.base)
    return mapped(_BINARY[op], (left, right), kind.base)


def _product(left: Any, right: Any, first: Type, second: Type) -> Any:
    """Linear algebra; ``None`` where one operand is a scalar."""
    if first.is_scalar or second.is_scalar:
        return None
    if first.is_vector:
        return tuple(_dot(left, column) for column in right)
    # Matrices are tuples of columns.
    rows = tuple(zip(*left, strict=True))
    if second.is_vector:
        return tuple(_dot(row, right) for row in rows)
    return tuple(tuple(_dot(row, column) for row in rows) for column in right)


def _dot(left: Any, right: Any) -> Any:
    return sum(a * b for a, b in zip(left, right, strict=True))


def converted(value: Value, base: str | None) -> Value | None:
    """Every scalar of ``value`` as another scalar type."""
    if not isinstance(value, tuple):
        return convert(value, base)
    return _all([converted(part, base) for part in value])


def _all(values: list[Value | None]) -> tuple[Value, ...] | None:
    known = tuple(value for value in values if value is not None)
    return known if len(known) == len(values) else None


def mapped(apply: Callable[..., Any], values: tuple[Value, ...], base: str | None) -> Value | None:
    """``apply`` component by component; scalars serve every component."""
    sizes = {len(value) for value in values if isinstance(value, tuple)}
    try:
        if not sizes:
            return convert(apply(*values), base)
        size = sizes.pop()
        columns = [v if isinstance(v, tuple) else (v,) * size for v in values]
        return _all([mapped(apply, column, base) for column in zip(*columns, strict=True)])
    except (ArithmeticError, ValueError, TypeError):
        return None


def fold_construct(kind: Type, values: list[Value]) -> Value | None:
    """A value of type ``kind`` made from others (section 5.4); ``None`` for a very large one."""
    if kind.components is not None and kind.components > MAX_COMPONENTS:
        return None
    if kind.dims:
        return _all([_part(kind.element, value) for value in values])
    if kind.struct is not None:
        return _all(list(map(_part, kind.struct.fields.values(), values)))
    if kind.is_matrix:
        return _matrix(kind, values)
    scalars = [convert(scalar, kind.base) for value in values for scalar in flattened(value)]
    if len(scalars) == 1:
        scalars *= kind.rows
    # The last argument may have more components than are needed (section 5.4.2).
    known = _all([*scalars[: kind.rows]])
    if known is None or len(known) < kind.rows:
        return None
    return known if kind.rows > 1 else known[0]


def _part(kind: Type, value: Value) -> Value | None:
    """An element or field, implicitly converted."""
    return value if kind.base is None or kind.dims else fold_construct(kind, [value])


def _matrix(kind: Type, values: list[Value]) -> Value | None:
    only = values[0]
    if len(values) == 1 and not isinstance(only, tuple):
        columns = [[only if r == c else 0 for r in range(kind.rows)] for c in range(kind.cols)]
    elif len(values) == 1 and isinstance(only, tuple) and isinstance(only[0], tuple):
        columns = [[_entry(only, c, r) for r in range(kind.rows)] for c in range(kind.cols)]
    else:
        flat = [scalar for value in values for scalar in flattened(value)]
        columns = [flat[c * kind.rows : (c + 1) * kind.rows] for c in range(kind.cols)]
    return converted(tuple(tuple(column) for column in columns), kind.base)


def _entry(matrix: Any, column: int, row: int) -> Scalar:
    """Of a bigger or smaller matrix; what is missing is as in the unit matrix."""
    if column < len(matrix) and row < len(matrix[0]):
        entry: Scalar = matrix[column][row]
        return entry
    return 1.0 if column == row else 0.0

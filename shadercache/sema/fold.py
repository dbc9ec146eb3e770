"""Values of constant expressions.

A value is a ``bool``, ``int`` or ``float``, or a flat tuple of them for a vector or a matrix
(column by column); ``None`` stands for a value that is not known. Integers wrap at 32 bits, floats
are rounded to 32 bits; a driver may round the last bit of a built-in function otherwise.
"""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

from shadercache.lang.types import BOOL, DOUBLE, FLOAT, INT, UINT, Type
from shadercache.sema.facts import Scalar

Value: TypeAlias = Scalar | tuple[Scalar, ...]

_FLOAT32 = struct.Struct("f")
_INT_LIMIT = 1 << 31
_UINT_LIMIT = 1 << 32


def literal(text: str) -> tuple[Type, Scalar | None]:
    """Type and value of a literal; ``None`` for an integer that needs more than 32 bits."""
    if text in ("true", "false"):
        return BOOL, text == "true"
    low = text.lower()
    if low.startswith("0x") or not any(char in low for char in ".ef"):
        return _integer(low)
    if low.endswith("lf"):
        return DOUBLE, float(low[:-2])
    return FLOAT, convert(float(low.removesuffix("f")), "float")


def _integer(low: str) -> tuple[Type, int | None]:
    digits = low.removesuffix("u")
    kind = UINT if low.endswith("u") else INT
    octal = digits.startswith("0") and digits.isdigit()
    value = int(digits, 8) if octal and len(digits) > 1 else int(digits, 0)
    if value >= _UINT_LIMIT:
        return kind, None
    # A literal above 2^31 has its bit pattern (section 4.1.3), so 0xFFFFFFFF is -1.
    return kind, wrap(value, "int" if kind is INT else "uint")


def wrap(value: int, base: str) -> int:
    """``value`` in the 32 bits of ``int`` or ``uint``."""
    value &= _UINT_LIMIT - 1
    return value - _UINT_LIMIT if base == "int" and value >= _INT_LIMIT else value


def convert(value: Scalar, base: str | None) -> Scalar | None:
    """One scalar as another scalar type; ``None`` where the result is undefined."""
    if base == "bool":
        return bool(value)
    if base == "double":
        return float(value)
    if base == "float":
        try:
            return float(_FLOAT32.unpack(_FLOAT32.pack(value))[0])
        except OverflowError:
            return math.copysign(math.inf, value)
    if isinstance(value, float):
        if not -_INT_LIMIT <= value < _UINT_LIMIT or (base == "int" and value >= _INT_LIMIT):
            return None
        return int(value) if base == "int" or value >= 0 else None
    return wrap(int(value), base or "int")


def _quotient(left: Any, right: Any) -> Any:
    if isinstance(left, int):
        whole = abs(left) // abs(right)
        return whole if (left < 0) == (right < 0) else -whole
    return left / right


def _remainder(left: int, right: int) -> int:
    # Undefined for a negative operand (section 5.9).
    if left < 0 or right < 0:
        raise ArithmeticError
    return left % right


def _shift(apply: Callable[[int, int], int]) -> Callable[[int, int], int]:
    def shifted(left: int, right: int) -> int:
        if not 0 <= right < 32:
            raise ArithmeticError
        return apply(left, right)

    return shifted


_BINARY: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": _quotient,
    "%": _remainder,
    "<<": _shift(operator.lshift),
    ">>": _shift(operator.rshift),
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
    return _mapped(_UNARY[op], (value,), kind.base)


def fold_binary(op: str, left: Value, right: Value, base: str | None, kind: Type) -> Value | None:
    """``left op right`` of result type ``kind``; both are first converted to scalar ``base``."""
    if op not in ("<<", ">>"):
        left, right = _converted(left, base), _converted(right, base)
    if op in ("==", "!=") and isinstance(left, tuple):
        return (left == right) == (op == "==")
    return _mapped(_BINARY[op], (left, right), kind.base)


def _converted(value: Value, base: str | None) -> Any:
    if isinstance(value, tuple):
        return tuple(convert(item, base) for item in value)
    return convert(value, base)


def _mapped(apply: Callable[..., Any], values: tuple[Value, ...], base: str | None) -> Value | None:
    """``apply`` component by component; scalars serve every component."""
    sizes = {len(value) for value in values if isinstance(value, tuple)}
    try:
        if not sizes:
            return convert(apply(*values), base)
        size = sizes.pop()
        columns = [v if isinstance(v, tuple) else (v,) * size for v in values]
        items = [convert(apply(*column), base) for column in zip(*columns, strict=True)]
    except (ArithmeticError, ValueError, TypeError):
        return None
    return None if None in items else tuple(item for item in items if item is not None)


def fold_construct(kind: Type, values: list[Value]) -> Value | None:
    """A scalar or vector made from scalars and vectors; matrices are not folded."""
    flat: list[Scalar] = []
    for value in values:
        flat.extend(value if isinstance(value, tuple) else (value,))
    if len(values) == 1 and len(flat) == 1:
        flat *= kind.rows
    items = [convert(item, kind.base) for item in flat[: kind.rows]]
    if kind.cols > 1 or len(items) < kind.rows:
        return None
    known = tuple(item for item in items if item is not None)
    if len(known) < len(items):
        return None
    return known if kind.rows > 1 else known[0]


_CALLS: Mapping[str, Callable[..., Any]] = {
    "radians": math.radians,
    "degrees": math.degrees,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "pow": math.pow,
    "exp": math.exp,
    "log": math.log,
    "exp2": lambda x: 2.0**x,
    "log2": math.log2,
    "sqrt": math.sqrt,
    "abs": abs,
    "sign": lambda x: (x > 0) - (x < 0),
    "floor": math.floor,
    "ceil": math.ceil,
    "trunc": math.trunc,
    "roundEven": round,
    "fract": lambda x: x - math.floor(x),
    "mod": lambda x, y: x - y * math.floor(x / y),
    "min": min,
    "max": max,
    "clamp": lambda x, low, high: min(max(x, low), high),
    "mix": lambda x, y, a: (y if a else x) if isinstance(a, bool) else x * (1.0 - a) + y * a,
    "step": lambda edge, x: 0.0 if x < edge else 1.0,
    "lessThan": operator.lt,
    "lessThanEqual": operator.le,
    "greaterThan": operator.gt,
    "greaterThanEqual": operator.ge,
    "equal": operator.eq,
    "notEqual": operator.ne,
    "not": operator.not_,
}


def fold_call(name: str, values: list[Value], params: list[Type], kind: Type) -> Value | None:
    """A call of a built-in function that works component by component."""
    if name in ("any", "all") and isinstance(values[0], tuple):
        return any(values[0]) if name == "any" else all(values[0])
    apply = _CALLS.get(name)
    if apply is None or kind.cols > 1:
        return None
    converted = [_converted(v, p.base) for v, p in zip(values, params, strict=True)]
    return _mapped(apply, tuple(converted), kind.base)

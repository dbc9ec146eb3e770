"""Values of calls of built-in functions with constant arguments (GLSL 3.30 section 8)."""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable, Mapping
from itertools import chain
from typing import Any

from shadercache.lang.types import Type
from shadercache.sema.fold import Value, converted, fold_construct, mapped

# Where GLSL leaves a value undefined or to the driver, nobody may count on one: a ValueError says
# so, as those of the math module do.


def _defined(holds: bool, value: Any) -> Any:
    if not holds:
        raise ValueError("undefined in GLSL")
    return value


def _atan(y: float, x: float | None = None) -> float:
    if x is None:
        return math.atan(y)
    return float(_defined(x != 0.0 or y != 0.0, math.atan2(y, x)))


def _pow(x: float, y: float) -> float:
    return float(_defined(x > 0.0 or (x == 0.0 and y > 0.0), x) ** y)


def _round(x: float) -> int:
    # Python rounds halves to even; GLSL leaves them to the driver (section 8.3).
    return int(_defined(_fraction(x) != 0.5, round(x)))


def _clamp(x: Any, low: Any, high: Any) -> Any:
    return _defined(low <= high, min(max(x, low), high))


def _smoothstep(low: float, high: float, x: float) -> float:
    _defined(low < high, None)
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def _fraction(x: float) -> float:
    return x - math.floor(x)


def _bits(target: str, given: str) -> Callable[[Any], Any]:
    return lambda value: struct.unpack(target, struct.pack(given, value))[0]


_COMPONENTWISE: Mapping[str, Callable[..., Any]] = {
    "radians": math.radians,
    "degrees": math.degrees,
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos")},
    **{name: getattr(math, name) for name in ("sinh", "cosh", "tanh", "asinh", "acosh", "atanh")},
    "atan": _atan,
    "pow": _pow,
    "exp": math.exp,
    "log": math.log,
    "exp2": lambda x: 2.0**x,
    "log2": math.log2,
    "sqrt": math.sqrt,
    "inversesqrt": lambda x: 1.0 / math.sqrt(x),
    "abs": abs,
    "sign": lambda x: (x > 0) - (x < 0),
    "floor": math.floor,
    "ceil": math.ceil,
    "trunc": math.trunc,
    "round": _round,
    "roundEven": round,
    "fract": _fraction,
    "mod": lambda x, y: x - y * math.floor(x / y),
    "min": min,
    "max": max,
    "clamp": _clamp,
    # With booleans it chooses, and what is not chosen may be infinite or NaN (section 8.3).
    "mix": lambda x, y, a: (y if a else x) if isinstance(a, bool) else x * (1.0 - a) + y * a,
    "step": lambda edge, x: 0.0 if x < edge else 1.0,
    "smoothstep": _smoothstep,
    "fma": lambda a, b, c: a * b + c,
    "ldexp": lambda x, e: math.ldexp(x, int(e)),
    "isnan": math.isnan,
    "isinf": math.isinf,
    "floatBitsToInt": _bits("i", "f"),
    "floatBitsToUint": _bits("I", "f"),
    "intBitsToFloat": _bits("f", "i"),
    "uintBitsToFloat": _bits("f", "I"),
    # Python counts the bits of the magnitude, GLSL those of the two's complement.
    "bitCount": lambda x: (x & 0xFFFFFFFF).bit_count(),
    "lessThan": operator.lt,
    "lessThanEqual": operator.le,
    "greaterThan": operator.gt,
    "greaterThanEqual": operator.ge,
    "equal": operator.eq,
    "notEqual": operator.ne,
    "not": operator.not_,
    "matrixCompMult": operator.mul,
}


def _items(value: Any) -> tuple[Any, ...]:
    return value if isinstance(value, tuple) else (value,)


def _dot(left: Any, right: Any) -> float:
    return math.fsum(a * b for a, b in zip(_items(left), _items(right), strict=True))


def _length(value: Any) -> float:
    return math.sqrt(_dot(value, value))


def _scaled(value: Any, factor: float) -> Any:
    return tuple(x * factor for x in value) if isinstance(value, tuple) else value * factor


def _sum(left: Any, right: Any) -> Any:
    if isinstance(left, tuple):
        return tuple(map(operator.add, left, right))
    return left + right


def _cross(a: Any, b: Any) -> Any:
    return (a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1])


def _refract(i: Any, n: Any, eta: float) -> Any:
    d = _dot(n, i)
    k = 1.0 - eta * eta * (1.0 - d * d)
    if k < 0.0:
        return _scaled(i, 0.0)
    return _sum(_scaled(i, eta), _scaled(n, -(eta * d + math.sqrt(k))))


def _determinant(matrix: Any) -> float:
    if len(matrix) == 1:
        return float(matrix[0][0])
    return math.fsum(
        (-1.0) ** i * column[0] * _determinant(_without(matrix, i, 0))
        for i, column in enumerate(matrix)
    )


def _without(matrix: Any, column: int, row: int) -> Any:
    return [
        [value for r, value in enumerate(values) if r != row]
        for c, values in enumerate(matrix)
        if c != column
    ]


def _inverse(matrix: Any) -> Any:
    whole, size = _determinant(matrix), range(len(matrix))
    return tuple(
        tuple((-1.0) ** (c + r) * _determinant(_without(matrix, r, c)) / whole for r in size)
        for c in size
    )


_WHOLE: Mapping[str, Callable[..., Any]] = {
    "any": any,
    "all": all,
    "dot": _dot,
    "length": _length,
    "distance": lambda p, q: _length(_sum(p, _scaled(q, -1.0))),
    "normalize": lambda v: _scaled(v, 1.0 / _length(v)),
    "cross": _cross,
    "faceforward": lambda n, i, reference: _scaled(n, 1.0 if _dot(reference, i) < 0.0 else -1.0),
    "reflect": lambda i, n: _sum(i, _scaled(n, -2.0 * _dot(n, i))),
    "refract": _refract,
    "outerProduct": lambda c, r: tuple(_scaled(c, x) for x in r),
    "transpose": lambda m: tuple(zip(*m, strict=True)),
    "determinant": _determinant,
    "inverse": _inverse,
}


def fold_call(name: str, values: list[Value], params: list[Type], kind: Type) -> Value | None:
    """The value of a call; ``None`` where it is undefined or not known here."""
    arguments = [converted(v, p.base) for v, p in zip(values, params, strict=True)]
    known = tuple(argument for argument in arguments if argument is not None)
    apply, whole = _COMPONENTWISE.get(name), _WHOLE.get(name)
    if len(known) < len(arguments):
        return None
    if apply is not None:
        return mapped(apply, known, kind.base)
    if whole is None:
        return None
    try:
        value = whole(*known)
    # Undefined in GLSL as well: a vector of no length, a matrix that has no inverse.
    except (ArithmeticError, ValueError):
        return None
    return fold_construct(kind, list(chain(*value)) if kind.is_matrix else [value])

"""Which expressions have values that any compiler knows: literals, and what is made of these alone.

This goes by the text, without types, and errs to the side of a zero: what is known of a value is
whether it is floating-point, and whether one of its components may be zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.walk import postorder
from shadercache.lang.types import FLOATS, builtin_type

_FOLDED = frozenset(
    (
        *("abs", "sign", "floor", "trunc", "round", "roundEven", "ceil", "fract", "mod", "min"),
        *("max", "clamp", "mix", "step", "smoothstep", "fma", "dot", "cross", "radians", "degrees"),
        *("matrixCompMult", "outerProduct", "transpose", "reflect", "faceforward", "determinant"),
    )
)
"""Built-in functions with one right result, which a compiler evaluates where it can."""


@dataclass(frozen=True, slots=True)
class Known:
    """What is known of a value. ``zero``: may it, or one of its components, be zero (or false)?"""

    floating: bool
    zero: bool
    array: bool = False
    boolean: bool = False


Constants: TypeAlias = dict[str, Known]
"""By name, what is known of variables."""


def known_values(root: n.Node, constants: Constants) -> dict[n.Node, Known]:
    """All expressions below ``root`` that have known values."""
    values: dict[n.Node, Known] = {}
    for node in postorder(root):
        known = _known(node, values, constants)
        if known is not None:
            values[node] = known
    return values


def is_floating(kind: n.TypeSpec) -> bool:
    """A scalar, vector or matrix of floating-point numbers, or an array of them."""
    built_in = builtin_type(kind.name)
    return built_in is not None and built_in.base in FLOATS


def is_boolean(kind: n.TypeSpec) -> bool:
    """A boolean, or a vector or array of them."""
    built_in = builtin_type(kind.name)
    return built_in is not None and built_in.base == "bool"


def is_matrix(kind: n.TypeSpec) -> bool:
    """A matrix, or an array of them."""
    built_in = builtin_type(kind.name)
    return built_in is not None and built_in.is_matrix


def _known(node: n.Node, values: dict[n.Node, Known], constants: Constants) -> Known | None:
    match node:
        case n.Literal(text=text):
            return _literal(text)
        case n.Name(name=name):
            return constants.get(name)
        case n.Unary(op="+" | "-", operand=part) | n.Member(object=part):
            return values.get(part)
        case n.Binary(op="+" | "-" | "*" | "/", left=left, right=right):
            return _computed((left, right), values)
        case n.Call(name=name, args=args) if name in _FOLDED:
            return _computed(args, values)
        case n.Conditional(condition=condition, then=then, other=other) if condition in values:
            return _computed((then, other), values)
        case n.Construct(type=kind, args=args) if not kind.dims and builtin_type(kind.name):
            parts = _all(args, values)
            if parts is not None:
                # A matrix made of one number is zero off its diagonal (GLSL 4.60 section 5.4.2).
                zero = is_matrix(kind) or any(part.zero for part in parts)
                return Known(is_floating(kind), zero, boolean=is_boolean(kind))
        case n.Index(object=part, index=index) if part in values and index in values:
            # The index is not looked at: what is known of an array is known of every element.
            return replace(values[part], array=False)
    return None


def _literal(text: str) -> Known:
    if text in ("true", "false"):
        return Known(False, text == "false", boolean=True)
    digits = text.lower()
    # Ahead of the marks of floats, for `e` and `f` are hexadecimal digits.
    if digits.startswith("0x"):
        return Known(False, not digits[2:].rstrip("u").strip("0"))
    floating = any(mark in digits for mark in ".ef")
    mantissa = digits.partition("e")[0].rstrip("lfu")
    return Known(floating, not mantissa.strip("0."))


def _all(exprs: Sequence[n.Expr], values: dict[n.Node, Known]) -> list[Known] | None:
    known = [values[expr] for expr in exprs if expr in values]
    return known if len(known) == len(exprs) else None


def _computed(exprs: Sequence[n.Expr], values: dict[n.Node, Known]) -> Known | None:
    parts = _all(exprs, values)
    if parts is None or any(part.array for part in parts):
        return None
    boolean = all(part.boolean for part in parts)
    # No arithmetic is done here, so any result may be zero: `1.0 - 1.0`.
    return Known(any(part.floating for part in parts), zero=True, boolean=boolean)

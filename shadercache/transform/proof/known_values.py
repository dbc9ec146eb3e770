"""Which expressions have values that any compiler knows: literals, and what is made of these alone.

This goes by the text, without types, and errs to the side of a zero: what is known of a value is
whether it is floating-point, and whether one of its components may be zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.lang.types import builtin_type

_FOLDED = frozenset(
    (
        *("abs", "sign", "floor", "trunc", "round", "roundEven", "ceil", "fract", "mod", "min"),
        *("max", "clamp", "mix", "step", "smoothstep", "fma", "dot", "cross", "radians", "degrees"),
        *("matrixCompMult", "outerProduct", "transpose", "reflect", "faceforward", "determinant"),
    )
)
"""Built-in functions with one right result, which a compiler evaluates where it can."""

_ARITHMETIC = ("+", "-", "*", "/")


@dataclass(frozen=True, slots=True)
class Known:
    """What is known of a value."""

    floating: bool
    zero: bool
    """May it, or one of its components, be zero?"""
    array: bool = False


Constants: TypeAlias = dict[str, Known]
"""By name, what is known of variables."""


def known_values(root: n.Node, constants: Constants) -> dict[n.Node, Known]:
    """All expressions below ``root`` that have known values."""
    found: dict[n.Node, Known] = {}
    for node in reversed(list(walk(root))):
        known = _known(node, found, constants)
        if known is not None:
            found[node] = known
    return found


def is_floating(kind: n.TypeSpec) -> bool:
    """A scalar, vector or matrix of floating-point numbers, or an array of them."""
    found = builtin_type(kind.name)
    return found is not None and found.base in ("float", "double")


def is_matrix(kind: n.TypeSpec) -> bool:
    """A matrix, or an array of them."""
    found = builtin_type(kind.name)
    return found is not None and found.is_matrix


def _known(node: n.Node, found: dict[n.Node, Known], constants: Constants) -> Known | None:
    match node:
        case n.Literal(text=text):
            return _literal(text)
        case n.Name(name=name):
            return constants.get(name)
        case n.Unary(op="+" | "-", operand=operand):
            return found.get(operand)
        case n.Binary(op=op, left=left, right=right) if op in _ARITHMETIC:
            return _computed((left, right), found)
        case n.Call(name=name, args=args) if name in _FOLDED:
            return _computed(args, found)
        case n.Conditional(condition=condition, then=then, other=other):
            return _computed((then, other), found) if condition in found else None
        case n.Construct(type=kind, args=args) if not kind.dims:
            return _constructed(kind, args, found)
        case n.Member(object=item):
            return found.get(item)
        case n.Index(object=item, index=index) if item in found and index in found:
            return Known(found[item].floating, found[item].zero)
    return None


def _literal(text: str) -> Known:
    if text in ("true", "false"):
        return Known(False, text == "false")
    digits = text.lower()
    if digits.startswith("0x"):
        return Known(False, not digits[2:].rstrip("u").strip("0"))
    floating = any(mark in digits for mark in ".ef")
    mantissa = digits.partition("e")[0].rstrip("lfu")
    return Known(floating, not mantissa.strip("0."))


def _computed(parts: tuple[n.Expr, ...], found: dict[n.Node, Known]) -> Known | None:
    known = [found.get(part) for part in parts]
    if None in known or any(item is not None and item.array for item in known):
        return None
    return Known(any(item is not None and item.floating for item in known), True)


def _constructed(
    kind: n.TypeSpec, args: tuple[n.Expr, ...], found: dict[n.Node, Known]
) -> Known | None:
    made = builtin_type(kind.name)
    known = [found.get(arg) for arg in args]
    if made is None or None in known:
        return None
    zero = made.is_matrix or any(item is not None and item.zero for item in known)
    return Known(is_floating(kind), zero)

"""Choosing among overloads (GLSL 3.30 section 6.1, 4.00 section 6.1)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from shadercache.lang.builtins import Signature
from shadercache.lang.types import Type
from shadercache.sema.conversions import Conversions
from shadercache.sema.scopes import Overload

Candidate: TypeAlias = Overload | Signature


def parameters(candidate: Candidate) -> tuple[tuple[Type, str], ...]:
    """Types and directions of the parameters."""
    if isinstance(candidate, Signature):
        return tuple((param.type, param.direction) for param in candidate.params)
    return tuple(zip(candidate.params, candidate.directions, strict=True))


def exact_match(candidates: Sequence[Signature], args: tuple[Type, ...]) -> Signature | None:
    """The built-in overload whose parameters have exactly these types."""
    for candidate in candidates:
        if tuple([param.type for param in candidate.params]) == args:
            return candidate
    return None


def convertible(
    candidates: Sequence[Candidate], args: tuple[Type, ...], conversions: Conversions
) -> list[Candidate]:
    """The best of the overloads that the arguments convert to; several: the call is ambiguous.

    Before 4.00 no conversion is better than another.
    """
    viable = [item for item in candidates if _accepts(item, args, conversions)]
    if len(viable) < 2 or not conversions.ranked:
        return viable
    for item in viable:
        if all(other is item or _better(item, other, args) for other in viable):
            return [item]
    return viable


def _accepts(candidate: Candidate, args: tuple[Type, ...], conversions: Conversions) -> bool:
    params = parameters(candidate)
    if len(params) != len(args):
        return False
    for arg, (kind, direction) in zip(args, params, strict=True):
        # Values go in by conversion to the parameter, and come out by conversion from it.
        if direction != "out" and not conversions.converts(arg, kind):
            return False
        if direction != "in" and not conversions.converts(kind, arg):
            return False
    return True


def _better(one: Candidate, two: Candidate, args: tuple[Type, ...]) -> bool:
    """Is some conversion to ``one`` better, and none worse?"""
    some = False
    for arg, (first, _), (second, _) in zip(args, parameters(one), parameters(two), strict=True):
        if _rank(arg, first) > _rank(arg, second):
            return False
        some = some or _rank(arg, first) < _rank(arg, second)
    return some


def _rank(arg: Type, param: Type) -> int:
    """Exact, float to double, to float, anything else."""
    if arg is param:
        return 0
    if arg.base == "float" and param.base == "double":
        return 1
    return 3 if param.base == "double" else 2

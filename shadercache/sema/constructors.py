"""Rules of constructors (GLSL 3.30 section 5.4)."""

from __future__ import annotations

from shadercache.lang.types import Type
from shadercache.sema.conversions import Conversions


def construct_problem(kind: Type, args: list[Type], conversions: Conversions) -> str | None:
    """What is wrong with making a ``kind`` from ``args``; ``None`` if nothing is.

    ``kind`` is sized; none of the types is an error.
    """
    if not args:
        return f"{kind}() needs an argument"
    if kind.dims:
        return _array_problem(kind, args, conversions)
    if kind.struct is not None:
        return _struct_problem(kind, args, conversions)
    if kind.base is None:
        return f"{kind} has no constructor"
    for arg in args:
        if arg.base is None or arg.dims:
            return f"{kind} cannot be made from {arg}"
    if len(args) == 1 and (args[0].is_scalar or (kind.is_matrix and args[0].is_matrix)):
        return None
    return _components_problem(kind, args)


def is_handle(kind: Type, args: list[Type]) -> bool:
    """``sampler2D(uvec2)`` or ``uvec2(sampler2D)``: a handle (ARB_bindless_texture)."""
    kinds = {kind.is_opaque: kind, **{arg.is_opaque: arg for arg in args}}
    return len(args) == 1 and True in kinds and str(kinds.get(False)) == "uvec2"


def _components_problem(kind: Type, args: list[Type]) -> str | None:
    """Enough components, and no argument that none of them comes from."""
    if kind.is_matrix and any(arg.is_matrix for arg in args):
        return f"{kind} is made from one matrix or from none"
    needed = kind.rows * kind.cols
    if kind.is_scalar and len(args) > 1:
        return f"{kind} takes one argument, not {len(args)}"
    given = [arg.rows * arg.cols for arg in args]
    if sum(given) < needed:
        return f"{kind} needs {needed} components, the arguments have {sum(given)}"
    if sum(given[:-1]) >= needed:
        return f"{kind} has {needed} components, the last argument is not used"
    return None


def _struct_problem(kind: Type, args: list[Type], conversions: Conversions) -> str | None:
    fields = kind.struct.fields if kind.struct else {}
    if len(args) != len(fields):
        return f"{kind} has {len(fields)} fields, not {len(args)}"
    for arg, (name, field) in zip(args, fields.items(), strict=True):
        if not conversions.converts(arg, field):
            return f"field '{name}' of {kind} is {field}, not {arg}"
    return None


def _array_problem(kind: Type, args: list[Type], conversions: Conversions) -> str | None:
    if len(args) != kind.dims[0]:
        return f"{kind} has {kind.dims[0]} elements, not {len(args)}"
    for arg in args:
        if not conversions.converts(arg, kind.element):
            return f"an element of {kind} is {kind.element}, not {arg}"
    return None

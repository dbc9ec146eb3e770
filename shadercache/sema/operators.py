"""Types of what operators, members and constructors make (GLSL 3.30 sections 5.4 to 5.9).

The functions that give a type return ``None`` where the operands do not fit.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from shadercache.lang.types import BOOL, VOID, Type, matrix, vector
from shadercache.sema.conversions import Conversions

ARITHMETIC = frozenset("+-*/")
BITWISE = frozenset("&|^")
SHIFTS = frozenset(("<<", ">>"))
RELATIONAL = frozenset(("<", ">", "<=", ">="))
EQUALITY = frozenset(("==", "!="))
INTEGER_ONLY = frozenset(("%", "~")) | BITWISE | SHIFTS
INDICES = frozenset(("int", "uint", "int16_t", "uint16_t", "int8_t", "uint8_t"))
INTEGERS = INDICES | {"int64_t", "uint64_t"}
LOGICAL = frozenset(("&&", "||", "^^"))
SWIZZLES = ("xyzw", "rgba", "stpq")


def unary_type(op: str, operand: Type) -> Type | None:
    """Type of ``op operand`` for ``+ - ! ~ ++ --``."""
    if op == "!":
        return BOOL if operand is BOOL else None
    if op == "~":
        return operand if _is_integer(operand) else None
    return operand if operand.is_numeric else None


@lru_cache(1 << 12)
def binary_type(op: str, left: Type, right: Type, conversions: Conversions) -> Type | None:
    """Type of ``left op right``; neither assignment nor comma."""
    if op in ARITHMETIC:
        return _arithmetic(op, left, right, conversions)
    if op in LOGICAL:
        return BOOL if left is BOOL and right is BOOL else None
    if op in RELATIONAL:
        fits = left.is_scalar and right.is_scalar and left.is_numeric and right.is_numeric
        return BOOL if fits and conversions.common(left, right) else None
    if op in EQUALITY:
        common = conversions.common(left, right)
        return BOOL if common and not common.holds_opaque and common is not VOID else None
    if not (_is_integer(left) and _is_integer(right)):
        return None
    if op in SHIFTS:
        # A scalar cannot be shifted by a vector, a vector can by a scalar (section 5.9).
        return left if right.rows in (1, left.rows) else None
    return _arithmetic(op, left, right, conversions)


def _is_integer(kind: Type) -> bool:
    return kind.base in INTEGERS and not kind.dims


def _arithmetic(op: str, left: Type, right: Type, conversions: Conversions) -> Type | None:
    if not (left.is_numeric and right.is_numeric) or left.base is None or right.base is None:
        return None
    base = conversions.common_base(left.base, right.base)
    if base is None:
        return None
    if right.is_scalar:
        return _with_base(left, base)
    if left.is_scalar:
        return _with_base(right, base)
    if op == "*" and (left.is_matrix or right.is_matrix):
        return _product(left, right, base)
    same = left.rows == right.rows and left.cols == right.cols
    return _with_base(left, base) if same else None


def _with_base(shape: Type, base: str) -> Type:
    if shape.is_matrix:
        return matrix(base, shape.cols, shape.rows)
    return vector(base, shape.rows)


def _product(left: Type, right: Type, base: str) -> Type | None:
    """Linear algebra: a vector is a column on the right and a row on the left of a matrix."""
    if left.is_vector:
        return vector(base, right.cols) if left.rows == right.rows else None
    if right.is_vector:
        return vector(base, left.rows) if left.cols == right.rows else None
    return matrix(base, right.cols, left.rows) if left.cols == right.rows else None


@lru_cache(1 << 12)
def member_type(whole: Type, name: str, version: int) -> Type | None:
    """Type of ``.name``: a field, or a swizzle (section 5.5); scalars have one from 4.20 on."""
    if whole.dims:
        return None
    if whole.struct is not None:
        return whole.struct.fields.get(name)
    if whole.base is None or whole.cols > 1 or (whole.rows == 1 and version < 420):
        return None
    fits = any(set(name) <= set(letters[: whole.rows]) for letters in SWIZZLES)
    return vector(whole.base, len(name)) if fits and 1 <= len(name) <= 4 else None


def construct_problem(kind: Type, args: Sequence[Type], conversions: Conversions) -> str | None:
    """What is wrong with making a ``kind`` from ``args``; ``None`` if nothing is.

    ``kind`` is sized; none of the types is an error.
    """
    if not args:
        return f"{kind}() needs an argument"
    if kind.dims or kind.struct is not None:
        return _parts_problem(kind, args, conversions)
    if kind.base is None:
        return f"{kind} has no constructor"
    for arg in args:
        if arg.base is None or arg.dims:
            return f"{kind} cannot be made from {arg}"
    # One scalar fills a vector or the diagonal of a matrix, and a matrix of any size makes another.
    if len(args) == 1 and (args[0].is_scalar or (kind.is_matrix and args[0].is_matrix)):
        return None
    return _components_problem(kind, args)


def is_handle(kind: Type, args: Sequence[Type]) -> bool:
    """``sampler2D(uvec2)`` or ``uvec2(sampler2D)``: a handle (ARB_bindless_texture)."""
    kinds = {kind.is_opaque: kind, **{arg.is_opaque: arg for arg in args}}
    return len(args) == 1 and True in kinds and str(kinds.get(False)) == "uvec2"


def is_combination(kind: Type, args: Sequence[Type]) -> bool:
    """``sampler2D(texture2D, sampler)``: a texture and how it is read (GL_KHR_vulkan_glsl)."""
    texture = kind.name.removesuffix("Shadow").replace("sampler", "texture", 1)
    names = [str(arg) for arg in args]
    return len(names) == 2 and names[0] == texture and names[1] in ("sampler", "samplerShadow")


def _components_problem(kind: Type, args: Sequence[Type]) -> str | None:
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


def _parts_problem(kind: Type, args: Sequence[Type], conversions: Conversions) -> str | None:
    """One argument for each field or element, which converts to it."""
    if kind.dims or kind.struct is None:
        count, what = kind.dims[0], "elements"
        parts = [(f"an element of {kind}", kind.element)] * len(args)
    else:
        fields = kind.struct.fields
        count, what = len(fields), "fields"
        parts = [(f"field '{name}' of {kind}", field) for name, field in fields.items()]
    if len(args) != count:
        return f"{kind} has {count} {what}, not {len(args)}"
    for arg, (part, wanted) in zip(args, parts, strict=True):
        if not conversions.converts(arg, wanted):
            return f"{part} is {wanted}, not {arg}"
    return None

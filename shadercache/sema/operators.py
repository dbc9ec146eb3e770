"""Result types of operators (GLSL 3.30 sections 5.7 to 5.9). Every function returns ``None`` where
the operands do not fit."""

from __future__ import annotations

from shadercache.lang.types import BOOL, Type, matrix, vector
from shadercache.sema.conversions import Conversions

ARITHMETIC = frozenset("+-*/")
BITWISE = frozenset("&|^")
SHIFTS = frozenset(("<<", ">>"))
RELATIONAL = frozenset(("<", ">", "<=", ">="))
EQUALITY = frozenset(("==", "!="))
INTEGER_ONLY = frozenset(("%", "~")) | BITWISE | SHIFTS
INTEGERS = frozenset(("int", "uint", "int64_t", "uint64_t"))
LOGICAL = frozenset(("&&", "||", "^^"))


def unary_type(op: str, operand: Type) -> Type | None:
    """Type of ``op operand`` for ``+ - ! ~ ++ --``."""
    if op == "!":
        return BOOL if operand is BOOL else None
    if op == "~":
        return operand if _is_integer(operand) else None
    return operand if operand.is_numeric else None


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
        return BOOL if common and not common.holds_opaque and not common.is_void else None
    if not (_is_integer(left) and _is_integer(right)):
        return None
    if op in SHIFTS:
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

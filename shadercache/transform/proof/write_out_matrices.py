"""Proof mode: write arithmetic on matrices out, column by column.

Mesa takes operations on matrices apart into temporaries that are not precise, whatever they are
assigned to, and rearranges these: ``m * 1.03 * 1.1`` becomes one product (22.3 and 25.0), and where
one component of ``turn * p`` is wanted, its four terms are added in another order (25.0)::

    m *= 1.03;    =>    m = sc_mat2_times_float(m, 1.03);
    q = turn * p;       q = sc_mat2_times_vec2(turn, p);

    mat2 sc_mat2_times_float(mat2 a, float b) { return mat2(a[0] * b, a[1] * b); }
    vec2 sc_mat2_times_vec2(mat2 a, vec2 b) { return a[0] * b[0] + a[1] * b[1]; }

Arithmetic on vectors stays precise.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set
from dataclasses import replace
from functools import reduce
from typing import TypeAlias

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Linked
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter
from shadercache.lang.types import Type, matrix
from shadercache.sema.facts import Stage
from shadercache.sema.infer import infer
from shadercache.source import NOWHERE, Source
from shadercache.transform.reachable import kept_names
from shadercache.transform.trees import change_declarations, change_functions

Types: TypeAlias = Mapping[n.Expr, Type]

_SIZES = ("2", "3", "4", *(f"{columns}x{rows}" for columns in "234" for rows in "234"))
_MATRICES = {f"{kind}{size}" for kind in ("mat", "dmat", "f16mat") for size in _SIZES} | {
    "outerProduct"
}
"""What a program names that works with matrices: their types, and what makes one without."""

_BASES = ("double", "float", "float16_t")

_WORDS = {"+": "plus", "-": "minus", "*": "times", "/": "over"}


def rewrite_linked(
    module: n.Module,
    stage: Stage,
    known: dict[Linked, n.FunctionDef],
    rewrite: Callable[[n.FunctionDef, EffectTable, Types], n.FunctionDef],
    memo: Memo,
) -> n.Module:
    """The module with each function rewritten, except those that are ``known`` already.

    ``rewrite`` is given the types of all expressions where the module works with matrices, which
    it rarely does.
    """
    table = EffectTable(module, memo)
    # What is made of a call depends on the callee's head: linked, a function has both.
    linked = {function: table.linked(function.name) for function in table.functions.values()}
    new = {function for function, key in linked.items() if key not in known}
    types = _types(module, new, stage, memo) if new else {}
    for function in new:
        known[linked[function]] = rewrite(function, table, types)
    return change_functions(module, lambda function: known[linked[function]])


def _types(module: n.Module, functions: Set[n.Decl], stage: Stage, memo: Memo) -> Types:
    if all(kept_names(decl, memo).isdisjoint(_MATRICES) for decl in module.decls):
        return {}

    def head(decl: n.Decl) -> n.Decl:
        """Of the other functions the checker sees the heads alone."""
        return decl.proto if isinstance(decl, n.FunctionDef) and decl not in functions else decl

    return infer(change_declarations(module, head), Source("proof", ""), stage).types


def write_out_matrices(module: n.Module, prefix: str, stage: Stage, memo: Memo) -> n.Module:
    """The module with a call of a small function for each operation on matrices."""
    helpers: dict[str, n.FunctionDef] = memo.table("arithmetic on matrices")
    words = n.Qualifiers(NOWHERE, ("highp",)) if module.profile == "es" else n.NO_QUALIFIERS

    def written(function: n.FunctionDef, _: EffectTable, types: Types) -> n.FunctionDef:
        return _MatrixWriter(types, prefix, helpers, words).rewrite(function) if types else function

    module = rewrite_linked(module, stage, memo.table("matrices written out"), written, memo)
    decls = list(module.decls)
    called = {name for decl in decls for name in kept_names(decl, memo) if name in helpers}
    if not called:
        return module
    function = n.FunctionDef | n.FunctionProto
    first = next(at for at, decl in enumerate(decls) if isinstance(decl, function))
    # By name, whichever program wrote them first: they are kept for all programs.
    decls[first:first] = [helpers[name] for name in sorted(called)]
    return replace(module, decls=tuple(decls))


class _MatrixWriter(Rewriter):
    def __init__(
        self, types: Types, prefix: str, helpers: dict[str, n.FunctionDef], words: n.Qualifiers
    ) -> None:
        self._types, self._prefix, self._helpers, self._words = types, prefix, helpers, words

    def enter(self, node: n.Node) -> n.Node | None:
        """What must be constant can call no function of ours."""
        return node if isinstance(node, n.VarDecl) and node.qualifiers.has("const") else None

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        match original, node:
            case n.Binary(left=left, right=right), n.Binary(op=op) if self._works(op, left, right):
                return self._call(op, (left, right), (node.left, node.right))
            # `*=` without its last sign is an operation; of `=` nothing is left, which is none.
            case n.Assign(target=target, value=value), n.Assign(op=op) if self._works(
                op[:-1], target, value
            ) and _is_place(target):
                call = self._call(op[:-1], (target, value), (node.target, node.value))
                return replace(node, op="=", value=call)
        return node

    def _works(self, op: str, left: n.Expr, right: n.Expr) -> bool:
        return op in _WORDS and any(self._types[side].is_matrix for side in (left, right))

    def _call(
        self, op: str, originals: tuple[n.Expr, n.Expr], args: tuple[n.Expr, n.Expr]
    ) -> n.Call:
        left, right = (self._types[side] for side in originals)
        # Whole numbers become floating-point ones, and smaller ones larger.
        base = next(base for base in _BASES if base in (left.base, right.base))
        kinds = [_type_name(side.cols, side.rows, base) for side in (left, right)]
        name = f"{self._prefix}{kinds[0]}_{_WORDS[op]}_{kinds[1]}"
        if name not in self._helpers:
            params = tuple(
                n.Param(NOWHERE, self._words, n.TypeSpec(NOWHERE, kind), param)
                for kind, param in zip(kinds, "ab", strict=True)
            )
            kind, value = _result(op, left, right, base)
            proto = n.FunctionProto(NOWHERE, self._words, n.TypeSpec(NOWHERE, kind), name, params)
            body = n.Block(NOWHERE, (n.Return(NOWHERE, value),))
            self._helpers[name] = n.FunctionDef(NOWHERE, proto, body)
        return n.Call(args[0].span, name, args)


def _is_place(target: n.Expr) -> bool:
    """Can the target be evaluated twice?"""
    # An index with a side effect, as in ``m[i++] *= n``, must not be repeated.
    while isinstance(target, n.Index | n.Member):
        if isinstance(target, n.Index) and not isinstance(target.index, n.Literal | n.Name):
            return False
        target = target.object
    return isinstance(target, n.Name)


def _type_name(columns: int, rows: int, base: str) -> str:
    return matrix(base, columns, rows).name


def _result(op: str, left: Type, right: Type, base: str) -> tuple[str, n.Expr]:
    """The type of an operation on ``a`` and ``b``, and its value by columns."""
    a, b = n.Name(NOWHERE, "a"), n.Name(NOWHERE, "b")
    if op != "*" or left.is_scalar or right.is_scalar:
        kind = left if left.is_matrix else right
        name = _type_name(kind.cols, kind.rows, base)
        columns = tuple(
            n.Binary(
                NOWHERE,
                op,
                _at(a, column) if left.is_matrix else a,
                _at(b, column) if right.is_matrix else b,
            )
            for column in range(kind.cols)
        )
    elif right.is_vector:
        return _type_name(1, left.rows, base), _sum(left.cols, a, b)
    else:
        # A vector on the left is a row, and so is what it is multiplied to.
        size = (right.cols, left.rows) if left.is_matrix else (1, right.cols)
        name = _type_name(*size, base)
        columns = tuple(_sum(right.rows, a, _at(b, column)) for column in range(right.cols))
    return name, n.Construct(NOWHERE, n.TypeSpec(NOWHERE, name), columns)


def _at(value: n.Expr, index: int) -> n.Expr:
    return n.Index(NOWHERE, value, n.Literal(NOWHERE, str(index)))


def _sum(count: int, one: n.Expr, other: n.Expr) -> n.Binary:
    """``one[0] * other[0] + one[1] * other[1]`` …, from the left."""
    terms = [n.Binary(NOWHERE, "*", _at(one, i), _at(other, i)) for i in range(count)]
    return reduce(lambda total, term: n.Binary(NOWHERE, "+", total, term), terms)

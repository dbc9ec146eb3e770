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

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import reduce
from typing import TypeAlias, cast

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Linked
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter
from shadercache.lang.types import Type
from shadercache.sema.facts import Stage
from shadercache.sema.infer import infer
from shadercache.source import NOWHERE, Source
from shadercache.transform.reachable import kept_names

Types: TypeAlias = Mapping[n.Expr, Type]

_SIZES = ("2", "3", "4", *(f"{columns}x{rows}" for columns in "234" for rows in "234"))
_MATRICES = {f"{kind}{size}" for kind in ("mat", "dmat") for size in _SIZES} | {"outerProduct"}
"""What a program names that works with matrices: their types, and what makes one without."""

_WORDS = {"+": "plus", "-": "minus", "*": "times", "/": "over"}


def types_for_matrices(
    module: n.Module, functions: Iterable[str], stage: Stage, memo: Memo
) -> Types:
    """The types of all expressions in the given functions where the module works with matrices,
    which it rarely does. Of the other functions the checker sees the heads alone."""
    if all(kept_names(decl, memo).isdisjoint(_MATRICES) for decl in module.decls):
        return {}
    wanted = set(functions)
    decls = tuple(
        decl.proto if isinstance(decl, n.FunctionDef) and decl.name not in wanted else decl
        for decl in module.decls
    )
    return infer(replace(module, decls=decls), Source("proof", ""), stage).types


def write_out_matrices(
    module: n.Module, prefix: str, stage: Stage = "fragment", memo: Memo | None = None
) -> n.Module:
    """The module with a call of a small function for each operation on matrices."""
    memo = Memo() if memo is None else memo
    table = EffectTable(module, memo)
    kept: dict[Linked, n.FunctionDef] = memo.table("matrices written out")
    linked = {name: table.linked(name) for name in table.functions}
    new = [name for name, item in linked.items() if item not in kept]
    helpers: dict[str, n.FunctionDef] = memo.table("arithmetic on matrices")
    types = types_for_matrices(module, new, stage, memo) if new else {}
    words = n.Qualifiers(NOWHERE, ("highp",)) if module.profile == "es" else n.NO_QUALIFIERS
    for name in new:
        function = table.functions[name]
        writer = _MatrixWriter(types, prefix, helpers, words)
        kept[linked[name]] = writer.rewrite(function) if types else function
    decls = [
        kept[linked[decl.name]] if isinstance(decl, n.FunctionDef) else decl
        for decl in module.decls
    ]
    called = {name for decl in decls for name in kept_names(decl, memo) if name in helpers}
    first = next(at for at, decl in enumerate(decls) if _is_function(decl))
    decls[first:first] = [helpers[name] for name in sorted(called)]
    return replace(module, decls=tuple(decls)) if called or new else module


def _is_function(decl: n.Decl) -> bool:
    return isinstance(decl, n.FunctionDef | n.FunctionProto)


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
        double = "double" in (left.base, right.base)
        kinds = _named(left, double), _named(right, double)
        name = f"{self._prefix}{kinds[0]}_{_WORDS[op]}_{kinds[1]}"
        if name not in self._helpers:
            value = _result(op, left, right, double)
            self._helpers[name] = _function(name, kinds, value, self._words)
        return n.Call(args[0].span, name, args)


def _is_place(target: n.Expr) -> bool:
    """Can the target be evaluated twice?"""
    while isinstance(target, n.Index | n.Member):
        if isinstance(target, n.Index) and not isinstance(target.index, n.Literal | n.Name):
            return False
        target = target.object
    return isinstance(target, n.Name)


def _named(kind: Type, double: bool) -> str:
    """The type as it takes part: whole numbers become floating-point ones."""
    return _type(kind.cols, kind.rows, double)


def _type(columns: int, rows: int, double: bool) -> str:
    if columns == 1 == rows:
        return "double" if double else "float"
    size = f"{columns}x{rows}" if columns not in (1, rows) else f"{rows}"
    return f"{'d' if double else ''}{'vec' if columns == 1 else 'mat'}{size}"


def _function(
    name: str, kinds: tuple[str, str], value: tuple[str, n.Expr], words: n.Qualifiers
) -> n.FunctionDef:
    params = tuple(
        n.Param(NOWHERE, words, n.TypeSpec(NOWHERE, kind), param)
        for kind, param in zip(kinds, "ab", strict=True)
    )
    kind = n.TypeSpec(NOWHERE, value[0])
    proto = n.FunctionProto(NOWHERE, words, kind, name, params)
    return n.FunctionDef(NOWHERE, proto, n.Block(NOWHERE, (n.Return(NOWHERE, value[1]),)))


def _result(op: str, left: Type, right: Type, double: bool) -> tuple[str, n.Expr]:
    """The type of an operation on ``a`` and ``b``, and its value by columns."""
    a, b = n.Name(NOWHERE, "a"), n.Name(NOWHERE, "b")
    if op != "*" or left.is_scalar or right.is_scalar:
        kind = left if left.is_matrix else right
        sides = _columns(a, left), _columns(b, right)
        return _matrix(kind, double, lambda c: n.Binary(NOWHERE, op, sides[0](c), sides[1](c)))
    if left.is_matrix and right.is_matrix:
        made = replace(left, cols=right.cols)
        return _matrix(made, double, lambda c: _sum(left.cols, a, _at(b, c)))
    if left.is_matrix:
        return _type(1, left.rows, double), _sum(left.cols, a, b)
    kind_name = _type(1, right.cols, double)
    terms = tuple(_sum(right.rows, a, _at(b, c)) for c in range(right.cols))
    return kind_name, n.Construct(NOWHERE, n.TypeSpec(NOWHERE, kind_name), terms)


def _matrix(kind: Type, double: bool, column: Callable[[int], n.Expr]) -> tuple[str, n.Expr]:
    name = _type(kind.cols, kind.rows, double)
    columns = tuple(column(c) for c in range(kind.cols))
    return name, n.Construct(NOWHERE, n.TypeSpec(NOWHERE, name), columns)


def _columns(value: n.Expr, kind: Type) -> Callable[[int], n.Expr]:
    return lambda c: _at(value, c) if kind.is_matrix else value


def _at(value: n.Expr, index: int) -> n.Expr:
    return n.Index(NOWHERE, value, n.Literal(NOWHERE, str(index)))


def _sum(count: int, one: n.Expr, other: n.Expr) -> n.Expr:
    """``one[0] * other[0] + one[1] * other[1]`` …, from the left."""
    terms = [n.Binary(NOWHERE, "*", _at(one, i), _at(other, i)) for i in range(count)]
    return reduce(
        lambda sum_, term: n.Binary(NOWHERE, "+", sum_, term), cast("list[n.Expr]", terms)
    )

"""Drop the results of cloned functions that no caller uses any more.

A result computed for nobody would keep the code behind it alive, and the function's own work::

    float sc_wave(vec3 p) {                     void sc_wave(vec3 p) {
        sc_payload = p.z * 4.7;         =>          sc_payload = p.z * 4.7;
        return sin(sc_payload) * p.x;           }
    }

Only functions that this compiler made are touched (their names are not overloaded).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk
from shadercache.source import NOWHERE


def drop_results(
    module: n.Module, functions: Collection[str], memo: Memo | None = None
) -> n.Module:
    """The module without unused results of the given functions (the same one if none)."""
    memo = Memo() if memo is None else memo
    unused = _returning(module, functions).difference(*(_used(d, memo) for d in module.decls))
    if not unused:
        return module
    table = EffectTable(module, memo)
    return replace(module, decls=tuple(_without(decl, unused, table) for decl in module.decls))


def _returning(module: n.Module, functions: Collection[str]) -> set[str]:
    return {
        decl.name
        for decl in module.decls
        if isinstance(decl, n.FunctionDef)
        and decl.name in functions
        and decl.proto.type.name != "void"
    }


def _used(decl: n.Decl, memo: Memo) -> frozenset[str]:
    """Functions with a call in the declaration that is not a statement of its own."""
    kept: dict[n.Decl, frozenset[str]] = memo.table("used results")
    found = kept.get(decl)
    if found is None:
        calls: list[n.Call] = []
        alone: set[n.Expr | None] = set()
        for item in walk(decl):
            if isinstance(item, n.Call):
                calls.append(item)
            elif isinstance(item, n.ExprStmt):
                alone.add(item.expr)
        found = kept[decl] = frozenset(call.name for call in calls if call not in alone)
    return found


def _without(decl: n.Decl, unused: set[str], table: EffectTable) -> n.Decl:
    if isinstance(decl, n.FunctionProto) and decl.name in unused:
        return _nothing(decl)
    if not isinstance(decl, n.FunctionDef) or decl.name not in unused:
        return decl
    body = _Returns(table).rewrite(decl.body)
    match body.body:
        case (*rest, n.Return(value=None)):
            body = replace(body, body=tuple(rest))
    return replace(decl, proto=_nothing(decl.proto), body=body)


def _nothing(proto: n.FunctionProto) -> n.FunctionProto:
    return replace(proto, type=n.TypeSpec(NOWHERE, "void"), qualifiers=n.NO_QUALIFIERS)


class _Returns(Rewriter):
    """``return f(x);`` becomes ``f(x); return;`` where that has a side effect, else ``return;``."""

    def __init__(self, table: EffectTable) -> None:
        self._table = table

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if not isinstance(node, n.Return) or node.value is None:
            return node
        effects = self._table.of(node.value)
        bare = replace(node, value=None)
        if not effects.writes and not effects.does:
            return bare
        return n.ExprStmt(node.span, node.value), bare

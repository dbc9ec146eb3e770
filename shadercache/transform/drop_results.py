"""Drop the results of cloned functions where nobody uses them any more.

A clone that computes a payload on its way returns what the shader goes on with. In a pass that
wants the payload alone, nothing goes on::

    float sc_fbm(vec3 p) {                            void sc_fbm(vec3 p) {
        sc_payload = noise(p);                            sc_payload = noise(p);
        return sc_payload + noise(p * 2.0);     =>    }
    }                                                 ...
    tint(2.0 * sc_fbm(q) + noise(q));                 sc_fbm(q);

What only fed such a result is dead code afterwards.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import cast

from shadercache.analysis.effects import Does, EffectTable, out_arguments
from shadercache.ast import nodes as n
from shadercache.ast.rewrite import Rewriter
from shadercache.ast.walk import EXPRESSIONS, children, walk
from shadercache.source import NOWHERE


def drop_results(module: n.Module, functions: Collection[str]) -> n.Module:
    """The module where those of the ``functions`` return nothing whose results are not used.

    The same one if there are none. They are this compiler's own: no name of theirs is overloaded.
    """
    returning = {
        decl.name
        for decl in module.decls
        if isinstance(decl, n.FunctionDef) and decl.name in functions and not _is_void(decl.proto)
    }
    if not returning:
        return module
    table = EffectTable(module)
    trimmed = _Trimmed(table, returning).rewrite(module)
    unused = returning - _used(trimmed)
    if not unused:
        return trimmed
    decls = (_without_result(decl, unused, table) for decl in trimmed.decls)
    return replace(trimmed, decls=tuple(decls))


def _is_void(proto: n.FunctionProto) -> bool:
    return proto.type.name == "void"


def _used(module: n.Module) -> set[str]:
    """The functions of which some call is not a statement by itself."""
    alone = {item.expr for item in walk(module) if isinstance(item, n.ExprStmt)}
    calls = (item for item in walk(module) if isinstance(item, n.Call))
    return {call.name for call in calls if call not in alone}


class _Trimmed(Rewriter):
    """Of a statement that only evaluates, keeps the calls that do something."""

    def __init__(self, table: EffectTable, functions: set[str]) -> None:
        self.table, self.functions = table, functions

    def enter(self, node: n.Node) -> n.Node | None:
        return node if isinstance(node, EXPRESSIONS) else None

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if not isinstance(node, n.ExprStmt) or isinstance(node.expr, n.Assign | n.Call | None):
            return node
        named = (item.name for item in walk(node) if isinstance(item, n.Call))
        if self.functions.isdisjoint(named):
            return node
        return _effects_alone(node.expr, self.table)


class _Ended(Rewriter):
    """Returns without a value; what its evaluation does beside is still done."""

    def __init__(self, table: EffectTable) -> None:
        self.table = table

    def enter(self, node: n.Node) -> n.Node | None:
        return node if isinstance(node, EXPRESSIONS) else None

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if not isinstance(node, n.Return) or node.value is None:
            return node
        return (*_effects_alone(node.value, self.table), n.Return(node.span, None))


def _without_result(decl: n.Decl, unused: Collection[str], table: EffectTable) -> n.Decl:
    if isinstance(decl, n.FunctionProto) and decl.name in unused:
        return _without_type(decl)
    if not isinstance(decl, n.FunctionDef) or decl.name not in unused:
        return decl
    body = _Ended(table).rewrite(decl.body)
    if body.body and isinstance(body.body[-1], n.Return):
        body = replace(body, body=body.body[:-1])
    return replace(decl, proto=_without_type(decl.proto), body=body)


def _without_type(proto: n.FunctionProto) -> n.FunctionProto:
    return replace(proto, type=n.TypeSpec(NOWHERE, "void"), qualifiers=n.NO_QUALIFIERS)


def _effects_alone(expr: n.Expr, table: EffectTable) -> list[n.Stmt]:
    """Statements that do what evaluating the expression does, without its value."""
    kept: list[n.Stmt] = []
    stack = [expr]
    while stack:
        item = stack.pop()
        effects = table.of(item)
        if not effects.writes and not effects.does & Does.DISCARD:
            continue
        if _only_combines(item, table):
            parts = (cast("n.Expr", part) for part in children(item)[::-1])
            stack += [part for part in parts if isinstance(part, EXPRESSIONS)]
        else:
            kept.append(n.ExprStmt(item.span, item))
    return kept


def _only_combines(expr: n.Expr, table: EffectTable) -> bool:
    """Does it do nothing itself, and evaluate all of its operands?"""
    match expr:
        case n.Binary(op=op):
            return op not in ("&&", "||")
        case n.Unary(op=op):
            return op not in ("++", "--")
        case n.Call():
            summary = table.summary(expr.name) if expr.name in table.functions else None
            acts = summary is not None and (summary.writes or summary.does & Does.DISCARD)
            return not acts and not any(out_arguments(expr, table))
    return isinstance(expr, n.Member | n.Index | n.Construct | n.Comma)

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
from shadercache.ast.walk import walk
from shadercache.source import NOWHERE
from shadercache.transform.trees import change_declarations, replace_nodes


def drop_results(module: n.Module, functions: Collection[str], memo: Memo) -> n.Module:
    """The module without unused results of the given functions (the same one if none)."""
    returning = {
        decl.name
        for decl in module.decls
        if isinstance(decl, n.FunctionDef)
        and decl.name in functions
        and decl.proto.type.name != "void"
    }
    unused = returning.difference(*(_used(decl, memo) for decl in module.decls))
    if not unused:
        return module
    table = EffectTable(module, memo)

    def without(decl: n.Decl) -> n.Decl:
        match decl:
            case n.FunctionProto(name=name) if name in unused:
                return returning_nothing(decl)
            case n.FunctionDef(name=name) if name in unused:
                body = _without_values(decl.body, table)
                return replace(decl, proto=returning_nothing(decl.proto), body=body)
        return decl

    return change_declarations(module, without)


def returning_nothing(proto: n.FunctionProto) -> n.FunctionProto:
    """The head of the function, which returns nothing any more."""
    # A result may have a precision in GLSL ES, and `void` has none.
    return replace(proto, type=n.TypeSpec(NOWHERE, "void"), qualifiers=n.NO_QUALIFIERS)


def _used(decl: n.Decl, memo: Memo) -> frozenset[str]:
    """Functions with a call in the declaration that is not a statement of its own."""
    known: dict[n.Decl, frozenset[str]] = memo.table("used results")
    if decl not in known:
        nodes = list(walk(decl))
        alone = {node.expr for node in nodes if isinstance(node, n.ExprStmt)}
        calls = (node for node in nodes if isinstance(node, n.Call) and node not in alone)
        known[decl] = frozenset(call.name for call in calls)
    return known[decl]


def _without_values(body: n.Block, table: EffectTable) -> n.Block:
    """``return f(x);`` becomes ``f(x); return;`` where that has a side effect, else ``return;``."""

    def without(_: n.Node, node: n.Node) -> n.Node | Sequence[n.Node]:
        if not isinstance(node, n.Return) or node.value is None:
            return node
        effects = table.of(node.value)
        bare = replace(node, value=None)
        if effects.writes or effects.does:
            return n.ExprStmt(node.span, node.value), bare
        return bare

    body = replace_nodes(body, without)
    match body.body:
        case (*rest, n.Return(value=None)):
            return replace(body, body=tuple(rest))
    return body

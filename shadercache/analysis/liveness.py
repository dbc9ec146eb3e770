"""What a function reads of its caller's variables, and what it overwrites for sure.

The effects of a function say what it may read or write, in whatever order. Here the order counts::

    void shade() {               // reads u_light and v_a; o_color is overwritten before
        o_color = vec4(v_a, 1.0);
        o_color.rgb *= u_light;
    }

Works by name, backward over the structured statements; a loop or a ``switch`` is taken as a whole.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from shadercache.analysis.effects import Effects, Linked
from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk

_NONE: frozenset[str] = frozenset()


class Summaries(Protocol):
    """What is known of the pieces and of the functions of a module (an :class:`EffectTable`)."""

    functions: dict[str, n.FunctionDef]

    def of(self, node: n.Node) -> Effects:
        """The effects of a piece."""

    def linked(self, name: str) -> Linked:
        """A function with its head."""


def reads_of(node: n.Node, table: Summaries) -> frozenset[str]:
    """What evaluating an expression or a statement reads, before it is overwritten by a call."""
    if not any(isinstance(item, n.Call) and item.name in table.functions for item in walk(node)):
        return table.of(node).reads
    match node:
        case n.Call(name=name, args=args) if name in table.functions:
            return table.linked(name).head.live_at_entry.union(
                *(reads_of(arg, table) for arg in args)
            )
        case n.Assign(op="=", target=n.Name(), value=value):
            return reads_of(value, table)
    return _NONE.union(*(reads_of(part, table) for part in children(node)))


def live_at_entry(function: n.FunctionDef, table: Summaries) -> frozenset[str]:
    """Variables that a function may read before it overwrites them."""
    return _before_all(function.body.body, _NONE, table)


def overwritten_in(function: n.FunctionDef, table: Summaries) -> frozenset[str]:
    """Variables that a function overwrites wholly, wherever it returns."""
    found = _NONE
    for stmt in _flat(function.body.body):
        if isinstance(stmt, n.Return) or any(isinstance(item, n.Return) for item in walk(stmt)):
            break
        found |= overwritten_by(stmt, table)
    return found


def overwritten_by(node: n.Node, table: Summaries) -> frozenset[str]:
    """Variables whose old value is gone behind a plain statement, whatever they held."""
    match node:
        case n.ExprStmt(expr=n.Assign(op="=", target=n.Name(name=name))):
            return frozenset((name,))
        case n.ExprStmt(expr=n.Call(name=name)) if name in table.functions:
            return table.linked(name).head.overwritten
        case n.DeclStmt(decl=n.VarDecl(declarators=items)):
            return frozenset(item.name for item in items)
    return _NONE


def _flat(stmts: Iterable[n.Stmt]) -> Iterable[n.Stmt]:
    for stmt in stmts:
        if isinstance(stmt, n.Block):
            yield from _flat(stmt.body)
        else:
            yield stmt


def _before_all(
    stmts: tuple[n.Stmt, ...], live: frozenset[str], table: Summaries
) -> frozenset[str]:
    for stmt in reversed(stmts):
        live = _before(stmt, live, table)
    return live


def _before(stmt: n.Stmt, live: frozenset[str], table: Summaries) -> frozenset[str]:
    match stmt:
        case n.Block():
            return _before_all(stmt.body, live, table)
        case n.If():
            then = _before(stmt.then, live, table)
            other = live if stmt.other is None else _before(stmt.other, live, table)
            return then | other | reads_of(stmt.condition, table)
        case n.For() | n.While() | n.DoWhile() | n.Switch():
            return live | reads_of(stmt, table)
        case n.Return():
            return reads_of(stmt, table)
        case n.Jump(word="discard"):
            return _NONE
    return (live - overwritten_by(stmt, table)) | reads_of(stmt, table)

"""Move arguments that do something ahead of their statement, where nobody reads the parameter.

Such an argument is computed for what happens on the way, and its value for nobody::

    color = sc_marble(sc_noise(p), q);        sc_noise(p);
                                        =>    color = sc_marble(0, q);

The zero is a stand-in of no type: whoever calls this drops parameter and argument at once
(:mod:`shadercache.transform.drop_parameters`).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import NO_EFFECTS, Does, Effects, union
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.transform.trees import evaluated_first, replace_nodes

# Not loops: what their heads evaluate is evaluated in every round.
_Movers = n.ExprStmt | n.DeclStmt | n.Return | n.If | n.Switch


class ActingArgument(NamedTuple):
    """An argument that writes or discards, and the statement that it may be moved ahead of, if
    any."""

    call: n.Call
    place: int
    stmt: n.Stmt | None


def acting_arguments(
    decl: n.Decl, functions: Collection[str], table: EffectTable
) -> list[ActingArgument]:
    """The arguments of the functions' calls that write or discard, operands before what holds
    them."""
    # `walk` meets a call before its arguments. Turned round, the list has operands first; turned
    # twice, the arguments of one call from left to right (GLSL 3.30 section 6.1.1).
    acting = [
        (node, place)
        for node in walk(decl)
        if isinstance(node, n.Call) and node.name in functions
        for place in reversed(range(len(node.args)))
        if _acts(table.of(node.args[place]))
    ]
    free = _free(decl, table) if acting else {}
    return [ActingArgument(call, at, free.get(call.args[at])) for call, at in reversed(acting)]


def move_arguments(module: n.Module, arguments: Sequence[ActingArgument]) -> n.Module:
    """The module with these arguments moved."""
    places: dict[n.Node, set[int]] = {}
    ahead: dict[n.Node | None, list[n.Expr]] = {}
    for call, place, stmt in arguments:
        places.setdefault(call, set()).add(place)
        ahead.setdefault(stmt, []).append(call.args[place])
    expressions = {expr for exprs in ahead.values() for expr in exprs}
    rebuilt: dict[n.Expr, n.Expr] = {}

    def moved(original: Any, node: Any) -> n.Node | Sequence[n.Node]:
        if original in places:
            stand_ins = (
                n.Literal(arg.span, "0") if place in places[original] else arg
                for place, arg in enumerate(node.args)
            )
            node = replace(node, args=tuple(stand_ins))
        if original in expressions:
            # Not the original: an argument inside that is moved as well would be evaluated twice.
            rebuilt[original] = node
        before = [rebuilt[expr] for expr in ahead.get(original, ())]
        return (*(n.ExprStmt(expr.span, expr) for expr in before), node) if before else node

    return replace_nodes(module, moved)


def _free(decl: n.Decl, table: EffectTable) -> dict[n.Node, n.Stmt]:
    """Expressions that may as well be evaluated ahead of the statement in which they stand."""
    headers = {loop.init for loop in walk(decl) if isinstance(loop, n.For)}
    free: dict[n.Node, n.Stmt] = {}
    for stmt in walk(decl):
        if isinstance(stmt, _Movers) and stmt not in headers:
            free.update(dict.fromkeys(_free_in(stmt, table), stmt))
    return free


def _free_in(stmt: _Movers, table: EffectTable) -> Iterator[n.Node]:
    stack = [(part, NO_EFFECTS) for part in evaluated_first(stmt)]
    while stack:
        node, beside = stack.pop()
        # `beside` are the effects of what else the statement evaluates: some is overtaken.
        if not _collide(table.of(node), beside):
            yield node
        parts = evaluated_first(node)
        effects = [table.of(part) for part in parts]
        for at, part in enumerate(parts):
            stack.append((part, union((beside, *effects[:at], *effects[at + 1 :]))))


def _acts(effects: Effects) -> bool:
    # An argument that discards decides which pixels are drawn, whoever reads its value.
    return bool(effects.writes or effects.does & Does.DISCARD)


def _collide(one: Effects, other: Effects) -> bool:
    """Does it matter which of the two comes first?"""
    # Behind a discard nothing is written, and derivatives are undefined (GLSL 4.60 section 8.14.1).
    return bool(
        one.writes & (other.reads | other.writes)
        or one.reads & other.writes
        or (one.does & Does.DISCARD and (other.writes or other.does))
        or (other.does & Does.DISCARD and (one.writes or one.does))
    )

"""Move arguments that do something ahead of their statement, where nobody reads the parameter.

Such an argument is computed for what happens on the way, and its value for nobody::

    color = sc_marble(sc_noise(p), q);        sc_noise(p);
                                        =>    color = sc_marble(0, q);

The zero is a stand-in of no type: whoever calls this drops parameter and argument at once
(:mod:`shadercache.transform.drop_parameters`).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias, cast

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import NO_EFFECTS, Does, Effects, union
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import children, walk

_Movers = n.ExprStmt | n.DeclStmt | n.Return | n.If | n.Switch

Places: TypeAlias = Mapping[str, Collection[int]]
"""Places of arguments, by function."""


@dataclass(frozen=True, slots=True)
class _Argument:
    """An argument with a side effect, and the statement that it may be moved ahead of, if any."""

    call: n.Call
    place: int
    stmt: n.Stmt | None

    @property
    def expr(self) -> n.Expr:
        return self.call.args[self.place]


def fixed_places(module: n.Module, places: Places, table: EffectTable) -> dict[str, set[int]]:
    """The places of which some argument has a side effect and cannot be moved."""
    found: dict[str, set[int]] = {}
    for argument in _arguments(module, places, table):
        if argument.stmt is None:
            found.setdefault(argument.call.name, set()).add(argument.place)
    return found


def move_arguments(module: n.Module, places: Places, table: EffectTable) -> n.Module:
    """The module with the arguments at these places moved where they have a side effect."""
    moved = [item for item in _arguments(module, places, table) if item.stmt is not None]
    return _Mover(moved).rewrite(module) if moved else module


def _arguments(module: n.Module, places: Places, table: EffectTable) -> Iterator[_Argument]:
    """The arguments at these places that have a side effect, operands before what holds them."""
    for decl in module.decls:
        calls = [
            item
            for item in walk(decl)
            if isinstance(item, n.Call)
            and any(table.of(item.args[place]).writes for place in places.get(item.name, ()))
        ]
        if not calls:
            continue
        free = _free(decl, table)
        for call in reversed(calls):
            for place in sorted(places[call.name]):
                if table.of(call.args[place]).writes:
                    yield _Argument(call, place, free.get(call.args[place]))


def _free(decl: n.Decl, table: EffectTable) -> dict[n.Node, n.Stmt]:
    """Expressions that may as well be evaluated ahead of the statement in which they stand."""
    headers = {item.init for item in walk(decl) if isinstance(item, n.For)}
    found: dict[n.Node, n.Stmt] = {}
    for stmt in walk(decl):
        if isinstance(stmt, _Movers) and stmt not in headers:
            found.update(dict.fromkeys(_free_in(stmt, table), cast("n.Stmt", stmt)))
    return found


def _free_in(stmt: _Movers, table: EffectTable) -> Iterator[n.Node]:
    stack = [(part, NO_EFFECTS) for part in _evaluated_first(stmt)]
    while stack:
        node, beside = stack.pop()
        if not _collide(table.of(node), beside):
            yield node
        parts = _evaluated_first(node)
        effects = [table.of(part) for part in parts]
        for at, part in enumerate(parts):
            stack.append((part, union((beside, *effects[:at], *effects[at + 1 :]))))


def _evaluated_first(node: n.Node) -> Sequence[n.Node]:
    """What is evaluated in every case when a node is, ahead of what the node itself does."""
    match node:
        case n.If(condition=first) | n.Switch(selector=first) | n.Conditional(condition=first):
            return (first,)
        case n.Binary(op="&&" | "||", left=first):
            return (first,)
        case n.Assign(op="=", target=n.Name(), value=value):
            return (value,)
    return children(node)


def _collide(one: Effects, other: Effects) -> bool:
    """Does it matter which of the two comes first?"""
    return bool(
        one.writes & (other.reads | other.writes)
        or one.reads & other.writes
        or (one.does | other.does) & Does.DISCARD
    )


class _Mover(Rewriter):
    def __init__(self, moved: Sequence[_Argument]) -> None:
        self._places: dict[n.Expr, set[int]] = {}
        self._by_stmt: dict[n.Stmt, list[n.Expr]] = {}
        self._rebuilt: dict[n.Expr, n.Expr] = {}
        for item in moved:
            assert item.stmt is not None
            self._places.setdefault(item.call, set()).add(item.place)
            self._by_stmt.setdefault(item.stmt, []).append(item.expr)

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        self._rebuilt[original] = node
        places = self._places.get(original)
        if places is None or not isinstance(node, n.Call):
            return node
        stand_ins = (
            n.Literal(arg.span, "0") if place in places else arg
            for place, arg in enumerate(node.args)
        )
        return replace(node, args=tuple(stand_ins))

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        ahead = [self._rebuilt[expr] for expr in self._by_stmt.get(original, ())]
        if not ahead:
            return node
        return (*(n.ExprStmt(expr.span, expr) for expr in ahead), node)

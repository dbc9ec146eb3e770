"""Conditions, jumps, switches and results (GLSL 3.30 section 6)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from shadercache.ast import nodes as n
from shadercache.lang.types import BOOL, INT, UINT, VOID, Type
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Finding, Suspect


class _Around(NamedTuple):
    """What stands around a statement; ``labels`` are those of the switch whose body it is in."""

    loop: bool = False
    switch: bool = False
    labels: set[int | None] | None = None


def statements(function: n.FunctionDef, suspect: Suspect) -> Iterator[Finding]:
    """Every statement of a function where it stands, and what the function returns."""
    result = suspect.tables.functions[function.proto].result
    returns = False
    stack: list[tuple[n.Stmt, _Around]] = [(function.body, _Around())]
    while stack:
        stmt, around = stack.pop()
        match stmt:
            case n.Block():
                inner = _Around(around.loop, around.switch)
                stack += [(part, inner) for part in reversed(stmt.body)]
            case n.If():
                yield from _condition(stmt.condition, suspect)
                # A label under it is the switch's; one in a block would be nobody's.
                parts = (stmt.other, stmt.then)
                stack += [(part, around) for part in parts if part is not None]
            case n.For() | n.While() | n.DoWhile():
                yield from _condition(stmt.condition, suspect)
                stack.append((stmt.body, _Around(loop=True)))
            case n.Switch():
                yield from _switch(stmt, suspect)
                # `break` leaves this switch, `continue` goes on with a loop around it.
                inner = _Around(around.loop, True, set())
                stack += [(part, inner) for part in reversed(stmt.body)]
            case n.Case():
                yield from _case(stmt, around, suspect)
            case n.Return():
                returns = True
                yield from _return(stmt, result, suspect)
            case n.Jump():
                yield from _jump(stmt, around, suspect)
    # A path without `return` is allowed and its value undefined; compilers want one somewhere.
    if not returns and result not in (VOID, ERROR):
        message = f"'{function.name}' returns {result}, but has no return statement"
        yield Finding("SC211", message, function.proto)


def _condition(condition: n.Expr | n.VarDecl | None, suspect: Suspect) -> Iterator[Finding]:
    """A condition is one ``bool``, or the declaration of one with a value."""
    kinds: list[tuple[n.Node, Type]] = []
    if isinstance(condition, n.VarDecl):
        kinds = [(node, suspect.tables.declared[node].type) for node in condition.declarators]
    elif condition is not None:
        kinds = [(condition, suspect.type_of(condition))]
    for node, kind in kinds:
        if kind not in (BOOL, ERROR):
            yield Finding("SC212", f"the condition is {kind}, not bool", node)
        if isinstance(node, n.Declarator) and node.init is None:
            yield Finding("SC212", "the condition has no value", node)


def _return(stmt: n.Return, wanted: Type, suspect: Suspect) -> Iterator[Finding]:
    if stmt.value is None:
        if wanted not in (VOID, ERROR):
            yield Finding("SC211", f"the function returns {wanted}: a value is missing", stmt)
        return
    given = suspect.type_of(stmt.value)
    if ERROR in (given, wanted):
        return
    if wanted is VOID:
        yield Finding("SC211", "a void function returns no value", stmt.value)
    elif not suspect.language.conversions.converts(given, wanted):
        yield Finding("SC211", f"the function returns {wanted}, not {given}", stmt.value)


def _jump(stmt: n.Jump, around: _Around, suspect: Suspect) -> Iterator[Finding]:
    if stmt.word == "discard" and suspect.language.stage != "fragment":
        yield Finding("SC218", "'discard' is for fragment shaders only", stmt)
    elif stmt.word == "continue" and not around.loop:
        yield Finding("SC218", "'continue' outside of a loop", stmt)
    elif stmt.word == "break" and not around.loop and not around.switch:
        yield Finding("SC218", "'break' outside of a loop or switch", stmt)


def _switch(stmt: n.Switch, suspect: Suspect) -> Iterator[Finding]:
    kind = suspect.type_of(stmt.selector)
    if kind not in (INT, UINT, ERROR):
        message = f"the selector of a switch is an int or uint, not {kind}"
        yield Finding("SC220", message, stmt.selector)
    if stmt.body and not isinstance(stmt.body[0], n.Case):
        yield Finding("SC220", "a statement before the first case", stmt.body[0])
    if stmt.body and isinstance(stmt.body[-1], n.Case) and not suspect.language.at_least(430, 310):
        yield Finding("SC220", "no statement after the last case", stmt.body[-1])


def _case(stmt: n.Case, around: _Around, suspect: Suspect) -> Iterator[Finding]:
    if around.labels is None:
        yield Finding("SC220", "a case label outside of a switch", stmt)
        return
    label = None
    if stmt.value is not None:
        kind = suspect.type_of(stmt.value)
        if kind is ERROR:
            return
        if kind not in (INT, UINT) or not suspect.is_constant(stmt.value):
            yield Finding("SC220", "a case label is a constant integer", stmt.value)
            return
        value = suspect.value(stmt.value)
        if not isinstance(value, int):
            return
        label = value
    if label in around.labels:
        name = "default" if label is None else f"case {label}"
        yield Finding("SC220", f"'{name}' stands twice in the same switch", stmt)
    around.labels.add(label)

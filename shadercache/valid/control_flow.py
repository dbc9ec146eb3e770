"""Conditions, jumps, switches and results (GLSL 3.30 section 6): SC211, SC212, SC218, SC220."""

from __future__ import annotations

from dataclasses import dataclass, field

from shadercache.ast.nodes import (
    Block,
    Case,
    DoWhile,
    Expr,
    For,
    FunctionDef,
    If,
    Jump,
    Return,
    Stmt,
    Switch,
    VarDecl,
    While,
)
from shadercache.lang.types import BOOL, INT, UINT, VOID, Type
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Suspect


@dataclass(frozen=True, slots=True)
class _Inside:
    """What stands around a statement; ``labels`` are those of the switch whose body it is in."""

    loop: bool = False
    switch: bool = False
    labels: set[int | None] | None = None


@dataclass(slots=True)
class _FunctionBody:
    suspect: Suspect
    result: Type
    stack: list[tuple[Stmt, _Inside]] = field(default_factory=list)
    returns: bool = False


def check_control_flow(suspect: Suspect) -> None:
    """Go through the statements of every function."""
    for function in suspect.nodes(FunctionDef):
        _check_function(function, suspect)


def _check_function(function: FunctionDef, suspect: Suspect) -> None:
    body = _FunctionBody(suspect, suspect.tables.functions[function.proto].result)
    body.stack.append((function.body, _Inside()))
    while body.stack:
        statement, inside = body.stack.pop()
        _check_statement(statement, inside, body)
    if not body.returns and body.result not in (VOID, ERROR):
        message = f"'{function.name}' returns {body.result}, but has no return statement"
        suspect.problems.error("SC211", message, function.proto)


def _check_statement(node: Stmt, inside: _Inside, body: _FunctionBody) -> None:
    match node:
        case Block():
            nested = _Inside(inside.loop, inside.switch)
            body.stack += [(item, nested) for item in reversed(node.body)]
        case If():
            _check_condition(node.condition, body.suspect)
            body.stack += [(item, inside) for item in (node.other, node.then) if item is not None]
        case For() | While() | DoWhile():
            _check_condition(node.condition, body.suspect)
            body.stack.append((node.body, _Inside(loop=True)))
        case Switch():
            _check_switch(node, body.suspect)
            nested = _Inside(inside.loop, True, set())
            body.stack += [(item, nested) for item in reversed(node.body)]
        case Case():
            _check_case(node, inside, body.suspect)
        case Return():
            _check_return(node, body)
        case Jump():
            _check_jump(node, inside, body.suspect)


def _check_condition(condition: Expr | VarDecl | None, suspect: Suspect) -> None:
    """A condition is one ``bool``, or the declaration of one with a value."""
    if isinstance(condition, VarDecl):
        for node in condition.declarators:
            kind = suspect.tables.declared[node].type
            if kind not in (BOOL, ERROR):
                suspect.problems.error("SC212", f"the condition is {kind}, not bool", node)
            if node.init is None:
                suspect.problems.error("SC212", "the condition has no value", node)
    elif condition is not None:
        kind = suspect.type_of(condition)
        if kind not in (BOOL, ERROR):
            suspect.problems.error("SC212", f"the condition is {kind}, not bool", condition)


def _check_return(node: Return, body: _FunctionBody) -> None:
    body.returns = True
    problems, wanted = body.suspect.problems, body.result
    if node.value is None:
        if wanted not in (VOID, ERROR):
            problems.error("SC211", f"the function returns {wanted}: a value is missing", node)
        return
    given = body.suspect.type_of(node.value)
    if ERROR in (given, wanted):
        return
    if wanted is VOID:
        problems.error("SC211", "a void function returns no value", node.value)
    elif not body.suspect.language.conversions.converts(given, wanted):
        problems.error("SC211", f"the function returns {wanted}, not {given}", node.value)


def _check_jump(node: Jump, inside: _Inside, suspect: Suspect) -> None:
    message = None
    if node.word == "discard" and suspect.language.stage != "fragment":
        message = "'discard' is for fragment shaders only"
    elif node.word == "continue" and not inside.loop:
        message = "'continue' outside of a loop"
    elif node.word == "break" and not inside.loop and not inside.switch:
        message = "'break' outside of a loop or switch"
    if message is not None:
        suspect.problems.error("SC218", message, node)


def _check_switch(node: Switch, suspect: Suspect) -> None:
    problems, kind = suspect.problems, suspect.type_of(node.selector)
    if kind not in (INT, UINT, ERROR):
        message = f"the selector of a switch is an int or uint, not {kind}"
        problems.error("SC220", message, node.selector)
    if node.body and not isinstance(node.body[0], Case):
        problems.error("SC220", "a statement before the first case", node.body[0])
    if node.body and isinstance(node.body[-1], Case) and not suspect.language.at_least(430, 310):
        problems.error("SC220", "no statement after the last case", node.body[-1])


def _check_case(node: Case, inside: _Inside, suspect: Suspect) -> None:
    if inside.labels is None:
        suspect.problems.error("SC220", "a case label outside of a switch", node)
        return
    value = None if node.value is None else _label(node.value, suspect)
    if node.value is not None and value is None:
        return
    if value in inside.labels:
        label = "default" if value is None else f"case {value}"
        suspect.problems.error("SC220", f"'{label}' stands twice in the same switch", node)
    inside.labels.add(value)


def _label(label: Expr, suspect: Suspect) -> int | None:
    """The value of a case label; ``None`` where it is not known or wrong."""
    kind = suspect.type_of(label)
    if kind is ERROR:
        return None
    if kind not in (INT, UINT) or not suspect.is_constant(label):
        suspect.problems.error("SC220", "a case label is a constant integer", label)
        return None
    value = suspect.value(label)
    return value if isinstance(value, int) else None

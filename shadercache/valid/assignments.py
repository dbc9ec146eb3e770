"""What may be assigned to (GLSL 3.30 section 5.8): SC209."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast.nodes import Assign, Call, Expr, Index, Member, Name, Postfix, Unary
from shadercache.sema.facts import Symbol
from shadercache.sema.overloads import parameters
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Suspect

_READ_ONLY = {
    "const": "a constant",
    "uniform": "a uniform",
    "in": "an input",
    "param": "a constant parameter",
}


def check_assignments(suspect: Suspect) -> None:
    """What an operator or a function writes to is a variable that may change."""
    for target, by in _targets(suspect):
        problem = None if suspect.type_of(target) is ERROR else _problem(target, suspect)
        if problem is not None:
            message, place = problem
            suspect.problems.error("SC209", message + by, place)


def _targets(suspect: Suspect) -> Iterator[tuple[Expr, str]]:
    """What is written, and by which function."""
    for assign in suspect.nodes(Assign):
        yield assign.target, ""
    operators: list[Unary | Postfix] = [*suspect.nodes(Unary), *suspect.nodes(Postfix)]
    for node in operators:
        if node.op in ("++", "--") and suspect.type_of(node) is not ERROR:
            yield node.operand, ""
    for call in suspect.nodes(Call):
        callee = suspect.tables.calls.get(call)
        if callee is None:
            continue
        for arg, (_, direction) in zip(call.args, parameters(callee), strict=True):
            if direction != "in":
                yield arg, f" by '{call.name}'"


def _problem(target: Expr, suspect: Suspect) -> tuple[str, Expr] | None:
    """Why ``target`` cannot be assigned to, and the node to blame; ``None`` if it can."""
    expr = target
    while not isinstance(expr, Name):
        if isinstance(expr, Member):
            whole = suspect.type_of(expr.object)
            if not whole.dims and whole.struct is None and len(set(expr.name)) < len(expr.name):
                return f"the swizzle '{expr.name}' names a component twice", expr
        elif not isinstance(expr, Index):
            return "this is a value, not a variable: it cannot be changed", expr
        expr = expr.object
    symbol = suspect.tables.symbols.get(expr)
    if symbol is None or symbol.writable:
        return None
    return f"'{symbol.name}' is {_read_only(symbol)}: it cannot be changed", target


def _read_only(symbol: Symbol) -> str:
    if symbol.block is not None:
        return "a member of a read-only block"
    return _READ_ONLY.get(symbol.kind, "read-only")

"""The critical section of a fragment shader (ARB_fragment_shader_interlock): its two calls stand in
``main`` itself, once each, in this order, under no condition and before any ``return``."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast.nodes import Call, ExprStmt, FunctionDef, Return, Stmt
from shadercache.ast.walk import walk
from shadercache.sema.check_context import Context

_BEGIN, _END = "beginInvocationInterlock", "endInvocationInterlock"


def check_interlock(context: Context) -> None:
    """Complain about calls that stand elsewhere."""
    if not any("fragment_shader_interlock" in name for name in context.extensions):
        return
    seen: list[str] = []
    for function, calls in context.called.items():
        allowed = set(_straight(function)) if function.name == "main" else set()
        for call in calls:
            name = call.name[: -len("ARB")]
            if name not in (_BEGIN, _END):
                continue
            if call not in allowed:
                message = f"'{call.name}' stands in 'main', under no condition and before 'return'"
                context.error("SC218", message, call)
            elif name in seen or (name == _END and _BEGIN not in seen):
                message = f"'{call.name}' is called once, the beginning before the end"
                context.error("SC218", message, call)
            seen.append(name)


def _straight(main: FunctionDef) -> Iterator[Call]:
    """The calls that are statements of ``main`` and come before its first ``return``."""
    for statement in main.body.body:
        if _returns(statement):
            return
        if isinstance(statement, ExprStmt) and isinstance(statement.expr, Call):
            yield statement.expr


def _returns(statement: Stmt) -> bool:
    return any(isinstance(node, Return) for node in walk(statement))

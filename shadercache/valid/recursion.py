"""Nothing calls itself (GLSL 3.30 section 6.1): SC216."""

from __future__ import annotations

from shadercache.ast.nodes import Call, FunctionDef
from shadercache.sema.scopes import Overload
from shadercache.valid.suspect import Suspect


def check_recursion(suspect: Suspect) -> None:
    """Report each call that closes a cycle of calls, even one that never runs."""
    done: set[FunctionDef] = set()
    for start in suspect.tables.called:
        path: list[FunctionDef] = []
        stack: list[tuple[FunctionDef, Call | None]] = [(start, None)]
        while stack:
            function, call = stack.pop()
            if call is None and path and path[-1] is function:
                path.pop()
                done.add(function)
            elif function in path and call is not None:
                cycle = [*path[path.index(function) :], function]
                names = " > ".join(item.name for item in cycle)
                message = f"recursion is not allowed: {names}"
                suspect.problems.error("SC216", message, call)
            elif function not in done:
                path.append(function)
                stack.append((function, None))
                stack.extend(_calls(function, suspect))


def _calls(function: FunctionDef, suspect: Suspect) -> list[tuple[FunctionDef, Call | None]]:
    calls: list[tuple[FunctionDef, Call | None]] = []
    for call in reversed(suspect.tables.called[function]):
        callee = suspect.tables.calls[call]
        if isinstance(callee, Overload) and callee.definition in suspect.tables.called:
            calls.append((callee.definition, call))
    return calls

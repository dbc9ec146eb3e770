"""What may stand on the left of an assignment (GLSL 3.30 section 5.8)."""

from __future__ import annotations

from shadercache.ast.nodes import Expr, Index, Member, Name
from shadercache.sema.check_context import Context
from shadercache.sema.facts import Symbol

_READ_ONLY = {
    "const": "a constant",
    "uniform": "a uniform",
    "in": "an input",
    "param": "a constant parameter",
    "builtin": "read-only",
    "block": "a member of a read-only block",
}


def why_not_writable(target: Expr, context: Context) -> tuple[str, Expr] | None:
    """Why ``target`` cannot be assigned to, and the node to blame; ``None`` if it can.

    A target that was complained about already is not blamed again.
    """
    expr = target
    while not isinstance(expr, Name):
        if isinstance(expr, Member):
            whole = context.types[expr.object]
            if not whole.dims and whole.struct is None and len(set(expr.name)) < len(expr.name):
                return f"the swizzle '{expr.name}' names a component twice", expr
            if _is_read_only(expr, context):
                return f"'{expr.name}' is {_READ_ONLY['block']}: it cannot be changed", target
            expr = expr.object
        elif isinstance(expr, Index):
            expr = expr.object
        else:
            return "this is a value, not a variable: it cannot be changed", expr
    symbol = context.symbols.get(expr)
    if symbol is None or symbol.writable:
        return None
    return f"'{symbol.name}' is {_read_only(symbol)}: it cannot be changed", target


def _is_read_only(member: Member, context: Context) -> bool:
    """Is it a ``readonly`` member of a block with an instance name?"""
    whole = member.object.object if isinstance(member.object, Index) else member.object
    symbol = context.symbols.get(whole) if isinstance(whole, Name) else None
    if symbol is None or symbol.kind != "block" or symbol.block is None:
        return False
    return member.name in context.read_only_members(symbol.block)


def _read_only(symbol: Symbol) -> str:
    if symbol.block is not None:
        return _READ_ONLY["block"]
    return _READ_ONLY.get(symbol.kind, "read-only")

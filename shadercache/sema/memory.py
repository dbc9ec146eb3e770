"""What may be done with images and buffers that are passed to functions (4.60 section 4.10)."""

from __future__ import annotations

from shadercache.ast.nodes import Call, Expr, Index, Member, Name
from shadercache.lang.builtins import Signature
from shadercache.sema.check_context import Context
from shadercache.sema.facts import Symbol
from shadercache.sema.scopes import Overload

_KEPT = ("coherent", "volatile", "readonly", "writeonly")


def check_memory(node: Call, called: Overload | Signature, context: Context) -> None:
    """Complain about an image that loses a memory qualifier as an argument, and about an atomic
    function of something that is not in a buffer."""
    if isinstance(called, Signature):
        if not called.memory or not node.args:
            return
        if called.params[0].direction == "inout":
            _check_atomic(node, context)
            return
    for i, arg in enumerate(node.args):
        if not context.types[arg].holds_opaque:
            continue
        symbol = root(arg, context)
        if symbol is None:
            continue
        lost = [word for word in _KEPT if symbol.qualifiers.has(word)]
        lost = [word for word in lost if word not in _taken(called, i)]
        if lost:
            message = f"'{symbol.name}' is '{lost[0]}', and '{node.name}' takes no such image"
            context.error("SC221", message, arg)


def _taken(called: Overload | Signature, index: int) -> tuple[str, ...]:
    """The memory qualifiers that an argument may have."""
    if isinstance(called, Overload):
        return called.proto.params[index].qualifiers.words
    ways = {"imageLoad": ("readonly",), "imageStore": ("writeonly",)}
    if called.name.startswith(("imageLoad", "imageStore", "imageAtomic")):
        return ("coherent", "volatile", *ways.get(called.name, ()))
    return _KEPT


def _check_atomic(node: Call, context: Context) -> None:
    symbol = root(node.args[0], context)
    if symbol is not None and not (symbol.block and symbol.block.qualifiers.has("buffer")):
        message = f"'{node.name}' changes a member of a buffer; '{symbol.name}' is none"
        context.error("SC209", message, node.args[0])


def root(expr: Expr, context: Context) -> Symbol | None:
    """The variable that an expression is, or is a part of."""
    while isinstance(expr, Member | Index):
        expr = expr.object
    return context.symbols.get(expr) if isinstance(expr, Name) else None

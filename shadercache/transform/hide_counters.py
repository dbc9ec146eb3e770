"""Proof mode for unrolled loops: keep the driver from calculating with their counters beforehand.

A compiler evaluates ``exp(-float(i))`` itself where it knows ``i``, and to other bits than the
machine does. It knows ``i`` in each trip of an unrolled loop, but not in the loop::

    int i = 3;        =>        int i = 3 - int(gl_FragCoord.x < 0.0);

No fragment lies left of the picture, so nothing changes but what the compiler knows. The loops
of the original, which the driver may unroll itself, begin so as well.
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.analysis.spine import counters_of
from shadercache.ast import nodes as n
from shadercache.ast.rewrite import Rewriter
from shadercache.ast.walk import walk
from shadercache.source import NOWHERE
from shadercache.transform.trips import COUNTABLE


def hide_counters(module: n.Module) -> n.Module:
    """The module with counters of which a compiler does not know where they begin."""
    return _Hider(module).rewrite(module)


class _Hider(Rewriter):
    def __init__(self, module: n.Module) -> None:
        self._counters = {
            item for node in walk(module) if isinstance(node, n.Block) for item in counters_of(node)
        }

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        match node:
            case n.For(init=n.DeclStmt(decl=n.VarDecl() as decl) as init):
                return replace(node, init=replace(init, decl=_hidden(decl)))
            case n.DeclStmt(decl=n.VarDecl(declarators=(item,)) as decl) if item in self._counters:
                return replace(node, decl=_hidden(decl))
        return node


def _hidden(decl: n.VarDecl) -> n.VarDecl:
    name = decl.type.name
    if name not in COUNTABLE or decl.type.dims or decl.qualifiers.has("const"):
        return decl
    items = (
        item if item.init is None or item.dims else replace(item, init=_less_zero(item.init, name))
        for item in decl.declarators
    )
    return replace(decl, declarators=tuple(items))


def _less_zero(value: n.Expr, kind: str) -> n.Expr:
    """``value`` less a zero that only the machine knows: taken off, it keeps the sign of a zero."""
    x = n.Member(NOWHERE, n.Name(NOWHERE, "gl_FragCoord"), "x")
    outside = n.Binary(NOWHERE, "<", x, n.Literal(NOWHERE, "0.0"))
    zero = n.Construct(NOWHERE, n.TypeSpec(NOWHERE, kind), (outside,))
    return n.Binary(NOWHERE, "-", value, zero)

"""Proof mode: write a ``do`` loop that has a ``continue`` as a ``for`` loop.

Mesa 22.3 unrolls such loops wrongly: a round that ``continue`` ends keeps what the next round
assigns, though the condition has ended the loop. So the picture depends on what else stands in the
loop, and a variant need not agree with its original::

    do {                                for (bool sc_again = true; sc_again; sc_again = t < 2.0) {
        if (t < b) { continue; }   =>       if (t < b) { continue; }
    } while (t < 2.0);                  }

The text that plain mode writes stays the user's own.
"""

from __future__ import annotations

from typing import Any

from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk
from shadercache.source import NOWHERE
from shadercache.transform.names import FreshNames, all_names
from shadercache.transform.trees import declared, replace_nodes


def rewrite_do_loops(module: n.Module, prefix: str) -> n.Module:
    """The module without ``do`` loops that a ``continue`` leads to the condition of."""
    loops = {node for node in walk(module) if isinstance(node, n.DoWhile) and _goes_on(node.body)}
    if not loops:
        return module
    names = FreshNames(all_names(module))

    def rewritten(original: n.Node, node: Any) -> n.Node:
        return _for_loop(node, names.make(f"{prefix}again")) if original in loops else node

    return replace_nodes(module, rewritten)


def _goes_on(stmt: n.Node) -> bool:
    """Does a statement ``continue`` the loop around it?"""
    if isinstance(stmt, n.Jump):
        return stmt.word == "continue"
    nested = isinstance(stmt, n.Block | n.If | n.Switch)
    return nested and any(map(_goes_on, children(stmt)))


def _for_loop(loop: n.DoWhile, again: str) -> n.For:
    # Names in the condition mean the same there: the body's own are not seen by it (GLSL 4.60 6.3).
    first = n.Declarator(NOWHERE, again, (), n.Literal(NOWHERE, "true"))
    flag = declared(n.NO_QUALIFIERS, n.TypeSpec(NOWHERE, "bool"), first)
    step = n.Assign(NOWHERE, "=", n.Name(NOWHERE, again), loop.condition)
    return n.For(loop.span, flag, n.Name(NOWHERE, again), step, loop.body)

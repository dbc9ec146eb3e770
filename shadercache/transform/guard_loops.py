"""Leave loops in fragments whose result is thrown away, before they go round for ever.

The first of two passes may take fragments that have no payload to the end of the shader and discard
them only there. A loop that waits for what the cache should have held is left at once::

    for (...; t < 2.0; t += sc_payload) {          for (...; t < 2.0; t += sc_payload) {
        sum += f(t);                         =>        if (sc_lacks) { break; }
    }                                                  sum += f(t);
                                                   }
"""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace

from shadercache.analysis.loops import LOOPS
from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.source import NOWHERE


def guard_loops(module: n.Module, loops: Set[n.Node], flag: str) -> n.Module:
    """The module with ``if (flag) { break; }`` at the head of each of the loops."""
    return _Guard(loops, flag).rewrite(module) if loops else module


class _Guard(Rewriter):
    def __init__(self, loops: Set[n.Node], flag: str) -> None:
        self._loops, self._flag = loops, flag

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt:
        if original not in self._loops:
            return node
        assert isinstance(node, LOOPS)
        leave = n.Block(NOWHERE, (n.Jump(NOWHERE, "break"),))
        first = n.If(NOWHERE, n.Name(NOWHERE, self._flag), leave, None)
        body = node.body.body if isinstance(node.body, n.Block) else (node.body,)
        return replace(node, body=n.Block(node.body.span, (first, *body)))

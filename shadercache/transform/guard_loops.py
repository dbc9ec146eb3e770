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
from typing import Any

from shadercache.ast import nodes as n
from shadercache.source import NOWHERE
from shadercache.transform.trees import block_of, replace_nodes


def guard_loops(module: n.Module, loops: Set[n.Node], flag: str) -> n.Module:
    """The module with ``if (flag) { break; }`` at the head of each of the loops."""
    leave = n.Block(NOWHERE, (n.Jump(NOWHERE, "break"),))

    def guarded(original: n.Node, node: Any) -> Any:
        if original not in loops:
            return node
        # In the body and not in the condition, which may be missing or declare a variable.
        first = n.If(NOWHERE, n.Name(NOWHERE, flag), leave, None)
        body = block_of(node.body)
        return replace(node, body=replace(body, body=(first, *body.body)))

    return replace_nodes(module, guarded)

"""Write out what a ``discard`` does to the loops behind it since GLSL 1.30 and GLSL ES 3.00.

There it ends the fragment's way through the shader (GLSL 1.30, section 6.4); before, it only kept
the fragment from being written. So Mesa gives each loop of a newer shader one more exit::

    if (v < 0.1) {                        if (v < 0.1) {
        discard;                              sc_discarded = true;
    }                                         discard;
    for (int i = 0; i < 2; i++) {         }
        sum += pow(sum + 0.5, 1.5);  =>   for (int i = 0; i < 2; i++) {
    }                                         sum += pow(sum + 0.5, 1.5);
                                              if (sc_discarded)
                                                  break;
                                          }

No fragment that is seen leaves by it. But a loop with such an exit is not unrolled, and one without
is: then the driver knows ``sum`` in the first round, and evaluates ``pow(0.5, 1.5)`` itself, to
other bits than the machine does. And a fragment that has left gives its neighbours no coordinates
for the level of detail of a ``texture2D`` in the loop. (Levels behind a ``discard`` are undefined,
in so many words since the same versions.) An older shader and the same one raised are alike to the
bit only where both have the exits. So this is for the comparison of the two; nothing that is
shipped has it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.source import NOWHERE
from shadercache.transform.names import FreshNames, all_names
from shadercache.transform.trees import assigned, block_of, replace_nodes

_DESKTOP, _ES = 130, 300
"""The first versions in which a ``discard`` ends the fragment's way."""

_LOOPS = n.For | n.While | n.DoWhile


def leave_discarded(module: n.Module, prefix: str) -> n.Module:
    """The module of an older version, with an exit for discarded fragments in each loop.

    It is the same module where there is no loop or no ``discard``, or where the version has the
    exits anyway.
    """
    nodes = list(walk(module))
    newer = module.version >= (_ES if module.profile == "es" else _DESKTOP)
    if newer or not any(map(_discards, nodes)) or not any(isinstance(x, _LOOPS) for x in nodes):
        return module
    flag = FreshNames(all_names(module)).make(f"{prefix}discarded")
    functions = n.FunctionDef | n.FunctionProto
    first = next(decl for decl in module.decls if isinstance(decl, functions))
    marks = assigned(flag, n.Literal(NOWHERE, "true"))
    leaves = n.If(NOWHERE, n.Name(NOWHERE, flag), n.Jump(NOWHERE, "break"), None)

    def changed(original: n.Node, node: Any) -> Any:
        if original is first:
            return _flag(flag), node
        if _discards(original):
            return marks, node
        # Older versions have no switch, so a break leaves the loop that a continue goes on with.
        if isinstance(original, n.Jump) and original.word == "continue":
            return leaves, node
        # The discard may be in a function that the loop calls: each round ends with the question.
        if isinstance(original, _LOOPS):
            body = block_of(node.body)
            return replace(node, body=replace(body, body=(*body.body, leaves)))
        return node

    return replace_nodes(module, changed)


def _discards(node: n.Node) -> bool:
    return isinstance(node, n.Jump) and node.word == "discard"


def _flag(name: str) -> n.VarDecl:
    variable = n.Declarator(NOWHERE, name, (), n.Literal(NOWHERE, "false"))
    return n.VarDecl(NOWHERE, n.NO_QUALIFIERS, n.TypeSpec(NOWHERE, "bool"), (variable,))

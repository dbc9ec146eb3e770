"""Spell initialiser lists as the constructors they stand for.

A list may stand only where something is initialised, so what moves or copies values could not print
one elsewhere; a constructor is an expression like any other::

    mat2 m = {{1.0, f(p)}, q};      =>      mat2 m = mat2(vec2(1.0, f(p)), q);

A list stays one where its type has no name to construct it by: a struct without a name, or one
whose name another struct has, too.
"""

from __future__ import annotations

from collections import Counter

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import replace_expressions
from shadercache.ast.walk import walk
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE


def spell_lists(module: n.Module, facts: Facts) -> n.Module:
    """The module with constructors in the place of lists (the same module if there are none).

    ``facts`` are those of ``module``. A constructor has the place of its list.
    """
    if not any(isinstance(node, n.InitList) for node in facts.types):
        return module
    structs = Counter(node.name for node in walk(module) if isinstance(node, n.StructDef))

    def spelled(original: n.Expr, node: n.Expr) -> n.Expr:
        if not isinstance(node, n.InitList):
            return node
        kind = facts.types[original]
        if kind.struct is not None and (not kind.struct.name or structs[kind.struct.name] != 1):
            return node
        dims = tuple(n.Literal(NOWHERE, str(size)) if size else None for size in kind.dims)
        return n.Construct(node.span, n.TypeSpec(NOWHERE, kind.name, dims=dims), node.items)

    return replace_expressions(module, spelled)

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
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE


def spell_lists(module: n.Module, facts: Facts) -> n.Module:
    """The module with constructors in the place of lists (the same module if there are none).

    ``facts`` are those of ``module``. A constructor has the place of its list.
    """
    if not any(isinstance(node, n.InitList) for node in facts.types):
        return module
    return _ListSpeller(module, facts).rewrite(module)


class _ListSpeller(Rewriter):
    def __init__(self, module: n.Module, facts: Facts) -> None:
        self._types = facts.types
        structs = (node for node in walk(module) if isinstance(node, n.StructDef))
        counts = Counter(node.name for node in structs if node.name)
        self._structs = {name for name, count in counts.items() if count == 1}

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if not isinstance(node, n.InitList):
            return node
        kind = self._types[original]
        if kind.struct is not None and kind.struct.name not in self._structs:
            return node
        return n.Construct(node.span, _spec(kind), node.items)


def _spec(kind: Type) -> n.TypeSpec:
    dims = tuple(n.Literal(NOWHERE, str(size)) if size else None for size in kind.dims)
    return n.TypeSpec(NOWHERE, kind.name, dims)

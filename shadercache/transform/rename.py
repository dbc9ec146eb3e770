"""Rename functions, variables, types and interface blocks throughout a piece of program.

Works by name, on a module in which every identifier means one thing. Fields of structs and blocks
are not touched, except those of a block without instance name, which are variables.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter

N = TypeVar("N", bound=n.Node)


class Renamer(Rewriter):
    """Asks ``new_name(original node)`` for every node that carries a name of the module."""

    def __init__(self, new_name: Callable[[n.Node], str | None]) -> None:
        self._new_name = new_name

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        if isinstance(node, n.Name | n.Call):
            return self._renamed(node, original)
        return node

    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl | Sequence[n.Decl]:
        return self._renamed(node, original)

    def other(self, node: n.Node, original: n.Node) -> n.Node:
        return self._renamed(node, original)

    def _renamed(self, node: N, original: n.Node) -> N:
        if not isinstance(
            node,
            n.Name
            | n.Call
            | n.Declarator
            | n.Param
            | n.FunctionProto
            | n.TypeSpec
            | n.StructDef
            | n.BlockDecl,
        ):
            return node
        name = self._new_name(original)
        return node if name is None or name == node.name else replace(node, name=name)


def rename(root: N, names: Mapping[str, str]) -> N:
    """The piece of program with every name that is a key of ``names`` replaced by its value."""

    def new_name(node: n.Node) -> str | None:
        return names.get(getattr(node, "name", None) or "")

    renamed = Renamer(new_name).rewrite(root)
    if isinstance(renamed, n.BlockDecl) and renamed.instance and renamed.instance in names:
        return replace(renamed, instance=names[renamed.instance])
    return renamed

"""Rename functions, variables, types and interface blocks throughout a piece of program.

Works by name, on a module in which every identifier means one thing. Fields of structs and blocks
are not touched, except those of a block without instance name, which are variables.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any, TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.transform.trees import replace_nodes

N = TypeVar("N", bound=n.Node)

_NAMED = frozenset(
    (
        *(n.Name, n.Call, n.Declarator, n.Param),
        *(n.FunctionProto, n.TypeSpec, n.StructDef, n.BlockDecl),
    )
)


def rename_nodes(root: N, new_name: Callable[[n.Node], str | None]) -> N:
    """Ask for a new name of every (original) node that carries a name of the module."""

    def renamed(original: n.Node, node: Any) -> Any:
        if type(node) not in _NAMED:
            return node
        name = new_name(original)
        return node if name is None or name == node.name else replace(node, name=name)

    return replace_nodes(root, renamed)


def rename(root: N, names: Mapping[str, str]) -> N:
    """The piece of program with every name that is a key of ``names`` replaced by its value."""
    fields = frozenset(_fields(root))

    def new_name(node: n.Node) -> str | None:
        return None if node in fields else names.get(getattr(node, "name", None) or "")

    renamed = rename_nodes(root, new_name)
    # The name of an instance is no node. Declarations are renamed one by one, so a block is a root.
    if isinstance(renamed, n.BlockDecl) and renamed.instance and renamed.instance in names:
        return replace(renamed, instance=names[renamed.instance])
    return renamed


def _fields(root: n.Node) -> Iterator[n.Node]:
    """The declarators of fields, which may have the name of a variable."""
    for node in walk(root):
        if isinstance(node, n.StructDef) or (isinstance(node, n.BlockDecl) and node.instance):
            for field in node.fields:
                yield from field.declarators

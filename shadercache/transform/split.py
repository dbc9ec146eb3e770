"""One declarator to a declaration, and structs apart from the variables declared with them.

So that liveness can keep one variable and drop its neighbour::

    float a = f(), b = g(a);            float a = f();
                                   =>   float b = g(a);
    struct S { float x; } s;            struct S { float x; };
                                        S s;

The first part of a ``for`` stays as it is: it is one statement.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.transform.trees import change_declarations, replace_nodes


def split_declarations(module: n.Module) -> n.Module:
    """The module with its declarations split (the same module if there is nothing to split)."""
    headers = {node.init for node in walk(module) if isinstance(node, n.For)}

    def split(original: n.Node, node: n.Node) -> n.Node | Sequence[n.Node]:
        match node:
            case n.DeclStmt(decl=n.VarDecl() as decl) if original not in headers:
                parts = _split(decl)
                return node if len(parts) == 1 else [n.DeclStmt(part.span, part) for part in parts]
        return node

    return change_declarations(
        replace_nodes(module, split),
        lambda decl: _split(decl) if isinstance(decl, n.VarDecl) else decl,
    )


def _split(decl: n.VarDecl) -> list[n.VarDecl]:
    if not decl.declarators:
        return [decl]
    parts: list[n.VarDecl] = []
    kind = decl.type
    if kind.struct is not None and kind.name:
        # Qualifiers and sizes belong to the variables.
        parts.append(n.VarDecl(kind.span, n.NO_QUALIFIERS, replace(kind, dims=()), ()))
        kind = replace(kind, struct=None)
    elif len(decl.declarators) == 1 or kind.struct is not None:
        # Variables of a struct without a name have one type only while they stand together.
        return [decl]
    for variable in decl.declarators:
        parts.append(replace(decl, span=variable.span, type=kind, declarators=(variable,)))
    return parts

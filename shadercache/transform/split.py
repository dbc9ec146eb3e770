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
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import walk


def split_declarations(module: n.Module) -> n.Module:
    """The module with its declarations split (the same module if there is nothing to split)."""
    return _Splitter(module).rewrite(module)


class _Splitter(Rewriter):
    def __init__(self, module: n.Module) -> None:
        self._headers = {item.init for item in walk(module) if isinstance(item, n.For)}

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        if original in self._headers or not isinstance(node, n.DeclStmt):
            return node
        if not isinstance(node.decl, n.VarDecl):
            return node
        parts = _split(node.decl)
        return node if len(parts) == 1 else [n.DeclStmt(part.span, part) for part in parts]

    def declaration(self, node: n.Decl, original: n.Decl) -> n.Decl | Sequence[n.Decl]:
        parts = _split(node) if isinstance(node, n.VarDecl) else ()
        return node if len(parts) <= 1 else parts


def _split(decl: n.VarDecl) -> list[n.VarDecl]:
    if not decl.declarators:
        return [decl]
    parts: list[n.VarDecl] = []
    kind = decl.type
    if kind.struct is not None and kind.name:
        bare = replace(kind, dims=())
        parts.append(n.VarDecl(kind.span, n.NO_QUALIFIERS, bare, ()))
        kind = replace(kind, struct=None)
    for item in decl.declarators:
        parts.append(replace(decl, span=item.span, type=kind, declarators=(item,)))
    return parts

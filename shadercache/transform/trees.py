"""What the passes share: rewriting in one call, what is evaluated first, and new statements."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from operator import is_
from typing import Any, TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter
from shadercache.ast.walk import children
from shadercache.source import NOWHERE, Span

N = TypeVar("N", bound=n.Node)


class _Everything(Rewriter):
    def __init__(self, choose: Callable[[Any, Any], Any]) -> None:
        self._choose = choose

    def other(self, node: Any, original: Any) -> Any:
        return self._choose(original, node)

    expression = statement = declaration = other


def replace_nodes(root: N, choose: Callable[[Any, Any], n.Node | Sequence[n.Node]]) -> N:
    """The tree with ``choose(original, rebuilt)`` in the place of every node of any sort, from the
    bottom up; by several where several may stand."""
    return _Everything(choose).rewrite(root)


def copied(root: N, **changes: Span) -> N:
    """The same tree, made of other nodes; with the span that is given, if one is."""

    def copy(_: n.Node, node: n.Node) -> n.Node:
        return node if node is n.NO_QUALIFIERS else replace(node, **changes)

    return replace_nodes(root, copy)


def change_declarations(
    module: n.Module, change: Callable[[n.Decl], n.Decl | Iterable[n.Decl]]
) -> n.Module:
    """The module with each global declaration changed to one or several, or to none.

    It is the same module where nothing changes.
    """
    decls: list[n.Decl] = []
    for decl in module.decls:
        changed = change(decl)
        decls += (changed,) if isinstance(changed, n.Node) else changed
    # Passes run in turns until one gives back the module that it was given.
    same = len(decls) == len(module.decls) and all(map(is_, decls, module.decls))
    return module if same else replace(module, decls=tuple(decls))


def change_functions(
    module: n.Module,
    change: Callable[[n.FunctionDef], n.FunctionDef],
    known: dict[n.FunctionDef, n.FunctionDef] | None = None,
) -> n.Module:
    """The module with each function changed; what is ``known`` already is not asked for again."""
    known = {} if known is None else known

    def changed(decl: n.Decl) -> n.Decl:
        if not isinstance(decl, n.FunctionDef):
            return decl
        if decl not in known:
            known[decl] = change(decl)
        return known[decl]

    return change_declarations(module, changed)


def evaluated_first(node: n.Node) -> Sequence[n.Node]:
    """What is evaluated in every case when a node is, ahead of what the node itself does."""
    match node:
        case n.If(condition=first) | n.Switch(selector=first) | n.Conditional(condition=first):
            return (first,)
        case n.Binary(op="&&" | "||", left=first):
            return (first,)
        # Where only a part of a variable is assigned, its index is evaluated as well.
        case n.Assign(op="=", target=n.Name(), value=value):
            return (value,)
    return children(node)


def unconditional(node: n.Node) -> Iterator[n.Node]:
    """A node and all that is evaluated in every case when it is, in the order of the source."""
    stack = [node]
    while stack:
        node = stack.pop()
        yield node
        stack += evaluated_first(node)[::-1]


def block_of(stmt: n.Stmt) -> n.Block:
    """The statement as a block that has room for others."""
    return stmt if isinstance(stmt, n.Block) else n.Block(stmt.span, (stmt,))


def assigned(name: str, value: n.Expr, span: Span = NOWHERE) -> n.ExprStmt:
    """``name = value;``"""
    return n.ExprStmt(span, n.Assign(span, "=", n.Name(span, name), value))


def declared(
    words: n.Qualifiers, kind: n.TypeSpec, variable: n.Declarator, span: Span = NOWHERE
) -> n.DeclStmt:
    """``words kind variable;``"""
    return n.DeclStmt(span, n.VarDecl(NOWHERE, words, kind, (variable,)))

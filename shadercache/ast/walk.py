"""Walking a tree: the children of a node, all nodes below it, all expressions in it.

Nothing here recurses, so a chain of 100,000 operators is walked as well as a short one.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator
from operator import attrgetter
from typing import Any, cast, get_args

from shadercache.ast.nodes import (
    Assign,
    Binary,
    Block,
    BlockDecl,
    Call,
    Case,
    Comma,
    Conditional,
    Construct,
    Declarator,
    DeclStmt,
    Directive,
    DoWhile,
    Expr,
    ExprStmt,
    For,
    FunctionDef,
    FunctionProto,
    If,
    Index,
    InitList,
    Jump,
    LayoutItem,
    Length,
    Literal,
    Member,
    Module,
    Name,
    Node,
    Param,
    Postfix,
    PrecisionDecl,
    QualifierDecl,
    Qualifiers,
    Return,
    Stmt,
    StructDef,
    Switch,
    TypeSpec,
    Unary,
    VarDecl,
    While,
)

EXPRESSIONS: tuple[type[Node], ...] = get_args(Expr)
"""The classes of expressions, for ``isinstance``."""

STATEMENTS: tuple[type[Node], ...] = get_args(Stmt)
"""The classes of statements, for ``isinstance``."""

_IS_EXPRESSION = frozenset(EXPRESSIONS)

Children = Callable[[Any], tuple[Node, ...]]


def _none(_: Node) -> tuple[Node, ...]:
    return ()


def _one(field: str) -> Children:
    get = attrgetter(field)
    return lambda node: (get(node),)


def _optional(field: str) -> Children:
    get = attrgetter(field)

    def children(node: Node) -> tuple[Node, ...]:
        child = get(node)
        return () if child is None else (child,)

    return children


def _present(*nodes: Node | None) -> tuple[Node, ...]:
    return tuple(node for node in nodes if node is not None)


_CHILDREN: dict[type[Node], Children] = {
    Name: _none,
    Literal: _none,
    Unary: _one("operand"),
    Postfix: _one("operand"),
    Binary: attrgetter("left", "right"),
    Conditional: attrgetter("condition", "then", "other"),
    Assign: attrgetter("target", "value"),
    Comma: attrgetter("left", "right"),
    Call: attrgetter("args"),
    Construct: lambda node: (node.type, *node.args),
    Member: _one("object"),
    Index: attrgetter("object", "index"),
    Length: _one("object"),
    InitList: attrgetter("items"),
    LayoutItem: _optional("value"),
    Qualifiers: lambda node: node.layout or (),
    TypeSpec: lambda node: _present(node.struct, *node.dims),
    StructDef: attrgetter("fields"),
    Declarator: lambda node: _present(*node.dims, node.init),
    VarDecl: lambda node: (node.qualifiers, node.type, *node.declarators),
    BlockDecl: lambda node: (node.qualifiers, *node.fields, *_present(*node.dims)),
    PrecisionDecl: _one("type"),
    QualifierDecl: _one("qualifiers"),
    Param: lambda node: (node.qualifiers, node.type, *_present(*node.dims)),
    FunctionProto: lambda node: (node.qualifiers, node.type, *node.params),
    FunctionDef: attrgetter("proto", "body"),
    Block: attrgetter("body"),
    ExprStmt: _optional("expr"),
    DeclStmt: _one("decl"),
    If: lambda node: _present(node.condition, node.then, node.other),
    Switch: lambda node: (node.selector, *node.body),
    Case: _optional("value"),
    For: lambda node: _present(node.init, node.condition, node.step, node.body),
    While: attrgetter("condition", "body"),
    DoWhile: attrgetter("body", "condition"),
    Return: _optional("value"),
    Jump: _none,
    Directive: _none,
    Module: lambda node: (*node.directives, *node.decls),
}


def children(node: Node) -> tuple[Node, ...]:
    """The nodes directly below a node, in the order of the source."""
    return _CHILDREN[type(node)](node)


def walk(node: Node) -> Iterator[Node]:
    """A node and all nodes below it: each before its children, these in the order of the source."""
    below = _CHILDREN
    stack = [node]
    while stack:
        node = stack.pop()
        yield node
        stack += below[type(node)](node)[::-1]


def postorder(node: Node, done: Container[Node] = ()) -> list[Node]:
    """A node and all nodes below it, each behind its children; without what is ``done``."""
    order: list[Node] = []
    stack = [node]
    while stack:
        node = stack.pop()
        if node not in done:
            order.append(node)
            stack += _CHILDREN[type(node)](node)
    order.reverse()
    return order


def expressions(node: Node) -> Iterator[Expr]:
    """All expressions in a node, itself included, in the order of :func:`walk`.

    Those in array sizes, layouts, initialisers and case labels are among them.
    """
    for inner in walk(node):
        if type(inner) in _IS_EXPRESSION:
            yield cast("Expr", inner)

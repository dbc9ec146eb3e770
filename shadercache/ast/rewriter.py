"""Rewriting a tree: a new tree that shares with the old one whatever did not change.

:class:`Rewriter` is the identity. A pass overrides the hooks it needs and leaves the rest::

    class DropSemicolons(Rewriter):
        def statement(self, node: Stmt, original: Stmt) -> Stmt | Sequence[Stmt]:
            empty = isinstance(node, ExprStmt) and node.expr is None
            return () if empty else node

For passes that only replace expressions there are :func:`replace_expressions` and
:func:`map_expressions_keyed`. Nothing here recurses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, TypeVar, cast

from shadercache.ast import nodes as n
from shadercache.ast.nodes import Decl, Expr, Node, Stmt
from shadercache.ast.walk import CHILD_FIELDS, EXPRESSIONS, STATEMENTS, children
from shadercache.source import NOWHERE

N = TypeVar("N", bound=Node)

Result = Node | Sequence[Node]
"""What a child became: one node, or any number where the place takes them."""


class Rewriter:
    """The identity on trees, with a hook for each sort of node.

    Hooks are called from the bottom up: ``node`` has its children rewritten already and is
    ``original`` itself where none of them changed, so side tables are asked about ``original``.
    A replacement is not visited again.
    """

    def enter(self, node: Node) -> Node | None:
        """Called on the way down. A node returned here replaces ``node`` without a look inside;
        ``None`` goes on to the children."""
        return None

    def expression(self, node: Expr, original: Expr) -> Expr:
        """Replace an expression. Assignment targets and ``out`` arguments come here too."""
        return node

    def statement(self, node: Stmt, original: Stmt) -> Stmt | Sequence[Stmt]:
        """Replace a statement by one or by several; by none to drop it.

        Where only one may stand (``if (c) here``) several become a block and none becomes ``;``,
        or nothing at all after ``else``. The first part of a ``for`` must stay one statement.
        """
        return node

    def declaration(self, node: Decl, original: Decl) -> Decl | Sequence[Decl]:
        """Replace a declaration at global level by one or by several; by none to drop it.

        Declarations in functions come to :meth:`statement`, as ``DeclStmt``.
        """
        return node

    def other(self, node: Node, original: Node) -> Node:
        """Replace a node of any other sort: a type, declarator, parameter, struct, field,
        function head, qualifier list, layout entry or the module."""
        return node

    def rewrite(self, root: N) -> N:
        """The tree that the hooks make of ``root``; ``root`` itself where nothing changed.

        ``root`` may be any node. Raises :class:`TypeError` where a hook puts several nodes in a
        place for one.
        """
        result = _rewrite(self, root)
        if not isinstance(result, Node):
            raise TypeError("the root of a rewrite must stay one node")
        return cast("N", result)


class _OpenNode:
    """A node whose children are being rewritten."""

    __slots__ = ("left", "node", "results", "top")

    def __init__(self, node: Node, top: bool) -> None:
        self.node = node
        self.top = top
        self.left: Iterator[Node] = iter(children(node))
        self.results: list[Result] = []


def _rewrite(rewriter: Rewriter, root: Node) -> Result:
    replaced = rewriter.enter(root)
    if replaced is not None:
        return replaced
    stack = [_OpenNode(root, False)]
    while True:
        frame = stack[-1]
        node = next(frame.left, None)
        if node is not None:
            replaced = rewriter.enter(node)
            if replaced is None:
                stack.append(_OpenNode(node, isinstance(frame.node, n.Module)))
            else:
                frame.results.append(replaced)
            continue
        stack.pop()
        result = _finish(rewriter, frame)
        if not stack:
            return result
        stack[-1].results.append(result)


def _finish(rewriter: Rewriter, frame: _OpenNode) -> Result:
    node: Any = frame.node
    rebuilt: Any = _rebuilt(node, frame.results)
    match _SORTS.get(type(node)):
        case "expression":
            return cast(Node, rewriter.expression(rebuilt, node))
        case "statement":
            return rewriter.statement(rebuilt, node)
    if frame.top:
        return rewriter.declaration(rebuilt, node)
    return rewriter.other(rebuilt, node)


_SORTS: dict[type[Node], str] = {
    **dict.fromkeys(EXPRESSIONS, "expression"),
    **dict.fromkeys(STATEMENTS, "statement"),
}


# --- putting nodes together -----------------------------------------------------------------------


def _rebuilt(node: Node, results: list[Result]) -> Node:
    """The node with its children replaced; the same node where all are the same."""
    if results == list(children(node)):  # Nodes are equal only to themselves.
        return node
    left = iter(results)
    holds_nodes = CHILD_FIELDS[type(node)]
    values: list[Any] = []
    # These are the fields in the order of the constructor; `dataclasses.replace` is far slower.
    for name in type(node).__match_args__:
        value = getattr(node, name)
        if name in holds_nodes and value is not None:
            if isinstance(value, tuple):
                # A size that is left out (`float a[]`) is no child and has no result.
                value = _several(name, [old and next(left) for old in value])
            else:
                value = _single(name, next(left))
        values.append(value)
    if isinstance(node, n.FunctionDef):
        proto, body = values[1:]
        # In other places for one statement any will do; a function needs its braces.
        return n.FunctionDef(node.span, proto, _as_block(body))
    rebuilt: Node = type(node)(*values)
    # A type that defines its struct has the struct's name, which a pass may have changed.
    if isinstance(rebuilt, n.TypeSpec) and rebuilt.struct is not None:
        return n.TypeSpec(rebuilt.span, rebuilt.struct.name, rebuilt.struct, rebuilt.dims)
    return rebuilt


def _as_block(body: Stmt) -> n.Block:
    return body if isinstance(body, n.Block) else n.Block(body.span, (body,))


def _single(field: str, result: Result) -> Node | None:
    """What stands in a field for one node; only statements can be put together to one."""
    if isinstance(result, Node):
        return result
    if field not in ("then", "other", "body"):
        raise TypeError("several nodes in a place for one")
    if len(result) == 1:
        return result[0]
    if not result:
        return None if field == "other" else n.ExprStmt(NOWHERE, None)
    return n.Block(result[0].span.to(result[-1].span), cast("tuple[Stmt, ...]", tuple(result)))


def _several(field: str, results: list[Result | None]) -> tuple[Node | None, ...]:
    """What stands in a field for many nodes; array sizes may be missing."""
    nodes: list[Node | None] = []
    for result in results:
        if result is None or isinstance(result, Node):
            nodes.append(result)
        elif field in ("body", "decls"):
            nodes += result
        else:
            raise TypeError("several nodes in a place for one")
    return tuple(nodes)


# --- expressions only -----------------------------------------------------------------------------


class _EveryExpression(Rewriter):
    def __init__(self, choose: Callable[[Expr, Expr], Expr]) -> None:
        self._choose = choose

    def expression(self, node: Expr, original: Expr) -> Expr:
        return self._choose(original, node)


class _Keyed(Rewriter):
    def __init__(self, replace: Mapping[Expr, Expr]) -> None:
        self._replace: Mapping[Any, Expr] = replace

    def enter(self, node: Node) -> Node | None:
        return cast("Node | None", self._replace.get(node))


def replace_expressions(root: N, choose: Callable[[Expr, Expr], Expr]) -> N:
    """The tree with ``choose(original, rebuilt)`` in the place of every expression.

    Called from the bottom up; ``rebuilt`` has the replacements inside it made.
    """
    return _EveryExpression(choose).rewrite(root)


def map_expressions_keyed(node: N, replace: Mapping[Expr, Expr]) -> N:
    """The tree with the expressions that are keys of ``replace`` replaced by their values.

    Keys are nodes of this very tree. A key inside another key's expression has no effect.
    """
    return _Keyed(replace).rewrite(node)

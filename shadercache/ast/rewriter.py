"""Rewriting a tree: a new tree that shares with the old one whatever did not change.

:class:`Rewriter` is the identity. A pass overrides the hooks it needs and leaves the rest::

    class DropSemicolons(Rewriter):
        def statement(self, node: Stmt, original: Stmt) -> Stmt | Sequence[Stmt]:
            empty = isinstance(node, ExprStmt) and node.expr is None
            return () if empty else node

For passes that only replace expressions there are :func:`map_expressions` and
:func:`map_expressions_keyed`. Nothing here recurses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, TypeVar, cast

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
    Decl,
    Declarator,
    DeclStmt,
    Dims,
    DoWhile,
    Expr,
    ExprStmt,
    For,
    FunctionDef,
    FunctionProto,
    If,
    Index,
    InitList,
    LayoutItem,
    Length,
    Member,
    Module,
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
from shadercache.ast.walk import EXPRESSIONS, STATEMENTS, children
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


class _Frame:
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
    stack = [_Frame(root, False)]
    while True:
        frame = stack[-1]
        node = next(frame.left, None)
        if node is not None:
            replaced = rewriter.enter(node)
            if replaced is None:
                stack.append(_Frame(node, isinstance(frame.node, Module)))
            else:
                frame.results.append(replaced)
            continue
        stack.pop()
        result = _finish(rewriter, frame)
        if not stack:
            return result
        stack[-1].results.append(result)


def _finish(rewriter: Rewriter, frame: _Frame) -> Result:
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


def _rebuilt(node: Node, results: list[Result]) -> Node:
    """The node with its children replaced; the same node where all are the same."""
    if all(old is new for old, new in zip(children(node), results, strict=True)):
        return node
    return _REBUILD[type(node)](node, _Parts(results))


# --- putting nodes together -----------------------------------------------------------------------


class _Parts:
    """The rewritten children of a node, taken from first to last."""

    def __init__(self, results: list[Result]) -> None:
        self._results = iter(results)

    def one(self) -> Any:
        """The next child, which must be one node."""
        result = next(self._results)
        if not isinstance(result, Node):
            raise TypeError("several nodes in a place for one")
        return result

    def maybe(self, old: object) -> Any:
        """The next child where there was one, else ``None``."""
        return None if old is None else self.one()

    def dims(self, old: Dims) -> Dims:
        """As many array sizes as there were."""
        return tuple(self.maybe(size) for size in old)

    def some(self, count: int) -> tuple[Any, ...]:
        """The next ``count`` children, one node each."""
        return tuple(self.one() for _ in range(count))

    def body(self) -> Any:
        """The next child as the one statement that a place takes."""
        result = next(self._results)
        return result if isinstance(result, Node) else _as_one(result)

    def block(self) -> Block:
        """The next child as the body of a function."""
        body = self.body()
        return body if isinstance(body, Block) else Block(body.span, (body,))

    def tail(self, old: object) -> Any:
        """The next child as what follows ``else``, if anything does."""
        if old is None:
            return None
        result = next(self._results)
        if isinstance(result, Node):
            return result
        return _as_one(result) if result else None

    def spliced(self) -> tuple[Any, ...]:
        """All that is left, where any number of nodes may stand."""
        nodes: list[Node] = []
        for result in self._results:
            if isinstance(result, Node):
                nodes.append(result)
            else:
                nodes += result
        return tuple(nodes)


def _as_one(nodes: Sequence[Node]) -> Node:
    if len(nodes) == 1:
        return nodes[0]
    if not nodes:
        return ExprStmt(NOWHERE, None)
    return Block(nodes[0].span.to(nodes[-1].span), cast("tuple[Stmt, ...]", tuple(nodes)))


def _type_spec(n: TypeSpec, p: _Parts) -> Node:
    struct = p.maybe(n.struct)
    return TypeSpec(n.span, n.name if struct is None else struct.name, p.dims(n.dims), struct)


def _param(n: Param, p: _Parts) -> Node:
    return Param(n.span, p.one(), p.one(), n.name, p.dims(n.dims))


def _module(n: Module, p: _Parts) -> Node:
    directives = p.some(len(n.directives))
    return Module(n.span, n.version, n.profile, directives, p.spliced(), n.comments)


def _block_decl(n: BlockDecl, p: _Parts) -> Node:
    qualifiers, fields = p.one(), p.some(len(n.fields))
    return BlockDecl(n.span, qualifiers, n.name, fields, n.instance, p.dims(n.dims))


# Python evaluates the arguments of a call from left to right: the order of the children.
_REBUILD: dict[type[Node], Callable[[Any, _Parts], Node]] = {
    Unary: lambda n, p: Unary(n.span, n.op, p.one()),
    Postfix: lambda n, p: Postfix(n.span, n.op, p.one()),
    Binary: lambda n, p: Binary(n.span, n.op, p.one(), p.one()),
    Conditional: lambda n, p: Conditional(n.span, p.one(), p.one(), p.one()),
    Assign: lambda n, p: Assign(n.span, n.op, p.one(), p.one()),
    Comma: lambda n, p: Comma(n.span, p.one(), p.one()),
    Call: lambda n, p: Call(n.span, n.name, p.some(len(n.args))),
    Construct: lambda n, p: Construct(n.span, p.one(), p.some(len(n.args))),
    Member: lambda n, p: Member(n.span, p.one(), n.name),
    Index: lambda n, p: Index(n.span, p.one(), p.one()),
    Length: lambda n, p: Length(n.span, p.one()),
    InitList: lambda n, p: InitList(n.span, p.some(len(n.items))),
    LayoutItem: lambda n, p: LayoutItem(n.span, n.name, p.one()),
    Qualifiers: lambda n, p: Qualifiers(n.span, n.words, p.some(len(n.layout))),
    TypeSpec: _type_spec,
    StructDef: lambda n, p: StructDef(n.span, n.name, p.some(len(n.fields))),
    Declarator: lambda n, p: Declarator(n.span, n.name, p.dims(n.dims), p.maybe(n.init)),
    VarDecl: lambda n, p: VarDecl(n.span, p.one(), p.one(), p.some(len(n.declarators))),
    BlockDecl: _block_decl,
    PrecisionDecl: lambda n, p: PrecisionDecl(n.span, n.precision, p.one()),
    QualifierDecl: lambda n, p: QualifierDecl(n.span, p.one(), n.names),
    Param: _param,
    FunctionProto: lambda n, p: FunctionProto(
        n.span, p.one(), p.one(), n.name, p.some(len(n.params))
    ),
    FunctionDef: lambda n, p: FunctionDef(n.span, p.one(), p.block()),
    Block: lambda n, p: Block(n.span, p.spliced()),
    ExprStmt: lambda n, p: ExprStmt(n.span, p.one()),
    DeclStmt: lambda n, p: DeclStmt(n.span, p.one()),
    If: lambda n, p: If(n.span, p.one(), p.body(), p.tail(n.other)),
    Switch: lambda n, p: Switch(n.span, p.one(), p.spliced()),
    Case: lambda n, p: Case(n.span, p.one()),
    For: lambda n, p: For(n.span, p.one(), p.maybe(n.condition), p.maybe(n.step), p.body()),
    While: lambda n, p: While(n.span, p.one(), p.body()),
    DoWhile: lambda n, p: DoWhile(n.span, p.body(), p.one()),
    Return: lambda n, p: Return(n.span, p.one()),
    Module: _module,
}


# --- expressions only -----------------------------------------------------------------------------


class _Mapped(Rewriter):
    def __init__(self, fn: Callable[[Expr], Expr]) -> None:
        self._fn = fn

    def expression(self, node: Expr, original: Expr) -> Expr:
        return self._fn(node)


class _Keyed(Rewriter):
    def __init__(self, replace: Mapping[Expr, Expr]) -> None:
        self._replace: Mapping[Any, Expr] = replace

    def enter(self, node: Node) -> Node | None:
        return cast("Node | None", self._replace.get(node))


def map_expressions(node: N, fn: Callable[[Expr], Expr]) -> N:
    """The tree with every expression replaced by what ``fn`` makes of it, from the bottom up.

    ``fn`` is given the expression with its parts replaced already and returns it, or another.
    """
    return _Mapped(fn).rewrite(node)


def map_expressions_keyed(node: N, replace: Mapping[Expr, Expr]) -> N:
    """The tree with the expressions that are keys of ``replace`` replaced by their values.

    Keys are nodes of this very tree. A key inside another key's expression has no effect.
    """
    return _Keyed(replace).rewrite(node)

"""Walking a tree: the children of a node, all nodes below it, all expressions in it.

Nothing here recurses, so a chain of 100,000 operators is walked as well as a short one.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator
from dataclasses import fields
from operator import attrgetter
from typing import Any, cast, get_args

from shadercache.ast import nodes as n
from shadercache.ast.nodes import Expr, Node, Stmt

EXPRESSIONS: tuple[type[Node], ...] = get_args(Expr)
"""The classes of expressions, for ``isinstance``."""

STATEMENTS: tuple[type[Node], ...] = get_args(Stmt)
"""The classes of statements, for ``isinstance``."""

_IS_EXPRESSION = frozenset(EXPRESSIONS)
_HOLDS_NO_NODE = frozenset(
    ("Span", "str", "str | None", "int", "tuple[str, ...]", "tuple[Comment, ...]")
)


def _child_fields(kind: type[Node]) -> dict[str, str]:
    """The fields that hold nodes, each with its type as text."""
    types = {field.name: str(field.type) for field in fields(kind)}
    return {name: text for name, text in types.items() if text not in _HOLDS_NO_NODE}


def _reader(types: dict[str, str]) -> Callable[[Any], tuple[Node, ...]]:
    """The function that reads the children of a node from these fields."""
    # Put together as text, for this runs for every node of every walk.
    single, many = "node.{0},", "*node.{0},"
    optional, with_gaps = "*filter(None, (node.{0},)),", "*filter(None, node.{0} or ()),"
    parts = []
    for name, kind in types.items():
        if kind == "Dims" or "tuple" in kind:
            form = with_gaps if kind == "Dims" or "None" in kind else many
        else:
            form = optional if "None" in kind else single
        parts.append(form.format(name))
    if "*" not in "".join(parts) and len(parts) > 1:
        # The same tuple without a Python frame; of a single field it would be no tuple.
        return attrgetter(*types)
    return cast(Callable[[Any], tuple[Node, ...]], eval(f"lambda node: ({' '.join(parts)})"))


CHILD_FIELDS: dict[type[Node], tuple[str, ...]] = {}
"""The names of the fields that hold nodes, by class and in the order of the source."""

CHILDREN: dict[type[Node], Callable[[Any], tuple[Node, ...]]] = {}
"""What reads the children of a node, by class; for loops in which each call counts."""

for _class in vars(n).values():
    if isinstance(_class, type) and issubclass(_class, Node):
        CHILD_FIELDS[_class] = tuple(_child_fields(_class))
        CHILDREN[_class] = _reader(_child_fields(_class))


def children(node: Node) -> tuple[Node, ...]:
    """The nodes directly below a node, in the order of the source."""
    return CHILDREN[type(node)](node)


def walk(node: Node) -> Iterator[Node]:
    """A node and all nodes below it: each before its children, these in the order of the source."""
    below = CHILDREN
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
            stack += CHILDREN[type(node)](node)
    # Parents stand before their children and the last child first; turned round, all is in order.
    order.reverse()
    return order


def expressions(node: Node) -> Iterator[Expr]:
    """All expressions in a node, itself included, in the order of :func:`walk`.

    Those in array sizes, layouts, initialisers and case labels are among them.
    """
    for inner in walk(node):
        # Expression classes have no subclasses: the type itself decides, faster than `isinstance`.
        if type(inner) in _IS_EXPRESSION:
            yield cast("Expr", inner)

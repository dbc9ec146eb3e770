"""Walking: all nodes, in the order of the source, without recursion."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from pathlib import Path

import pytest

from shadercache.ast import nodes
from shadercache.ast.nodes import NO_QUALIFIERS, Binary, Literal, Name, Node
from shadercache.ast.walk import EXPRESSIONS, STATEMENTS, children, expressions, walk
from shadercache.front.parse import parse
from shadercache.source import NOWHERE, Source

SHADERS = Path(__file__).parent.parent / "front" / "shaders"


def read(name: str) -> nodes.Module:
    return parse(Source(name, (SHADERS / name).read_text()))


@pytest.fixture(scope="module")
def module() -> nodes.Module:
    return read("language.frag")


def by_reflection(node: Node) -> list[Node]:
    """The children as the fields of the class say."""
    found: list[Node] = []
    for field in fields(node):
        value = getattr(node, field.name)
        if field.name != "span":
            found += [part for part in (value if isinstance(value, tuple) else (value,)) if part]
    return [child for child in found if isinstance(child, Node)]


def test_children_are_all_nodes_in_the_fields(module: nodes.Module) -> None:
    seen = set()
    for node in walk(module):
        seen.add(type(node))
        got = children(node)
        expected = by_reflection(node)
        assert len(got) == len(expected)
        assert {id(child) for child in got} == {id(child) for child in expected}
    assert {nodes.Module, nodes.Switch, nodes.LayoutItem, nodes.BlockDecl, nodes.Length} <= seen


def test_every_class_of_nodes_has_children(module: nodes.Module) -> None:
    classes = [
        item
        for item in vars(nodes).values()
        if isinstance(item, type) and issubclass(item, Node) and is_dataclass(item)
    ]
    found = [*walk(module), *walk(read("storage.frag"))]
    # The two shaders have one of each.
    assert {item for item in classes if item is not Node} == {type(node) for node in found}


def test_walk_is_in_the_order_of_the_source(module: nodes.Module) -> None:
    starts = [node.span.start for node in walk(module) if node is not NO_QUALIFIERS]
    assert starts == sorted(starts)


def test_walk_visits_a_node_before_its_children_and_once(module: nodes.Module) -> None:
    order = {id(node): place for place, node in enumerate(walk(module))}
    for node in walk(module):
        if node is not NO_QUALIFIERS:
            below = [child for child in children(node) if child is not NO_QUALIFIERS]
            assert all(order[id(node)] < order[id(child)] for child in below)


def test_expressions_are_those_in_the_walk(module: nodes.Module) -> None:
    expected = [node for node in walk(module) if isinstance(node, EXPRESSIONS)]
    assert list(expressions(module)) == expected
    texts = {node.text for node in expected if isinstance(node, Literal)}
    assert {"0.25", "017", "0xFF", "1e-3", "330"} - texts == {"330"}


def test_expressions_of_an_expression_begin_with_itself() -> None:
    left, right = Name(NOWHERE, "a"), Literal(NOWHERE, "1")
    node = Binary(NOWHERE, "+", left, right)
    assert list(expressions(node)) == [node, left, right]


def test_sorts_of_nodes() -> None:
    assert len(EXPRESSIONS) == 14
    assert len(STATEMENTS) == 11
    assert not set(EXPRESSIONS) & set(STATEMENTS)


def test_a_long_chain_is_walked() -> None:
    node: nodes.Expr = Name(NOWHERE, "a")
    for _ in range(50_000):
        node = Binary(NOWHERE, "+", node, Name(NOWHERE, "b"))
    assert sum(1 for _ in walk(node)) == 100_001

"""Spans: each node's text, taken from the file, is the node."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from shadercache.ast.nodes import (
    NO_QUALIFIERS,
    ExprStmt,
    FunctionDef,
    Module,
    Node,
    Qualifiers,
    TypeSpec,
)
from shadercache.ast.walk import EXPRESSIONS, STATEMENTS, children, expressions, walk
from shadercache.emit.printer import print_node
from shadercache.front.parse import parse
from shadercache.source import Source

LANGUAGE = Path(__file__).parent / "shaders" / "language.frag"


def texts(text: str) -> list[str]:
    """The texts of all expressions of a statement."""
    source = Source("test", f"#version 330\nvoid main() {{ {text}; }}")
    found = list(expressions(parse(source)))
    return [source.text[node.span.start : node.span.end] for node in found]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a", ["a"]),
        (" a  +  b ", ["a  +  b", "a", "b"]),
        ("( a )", ["a"]),
        ("(a + b) * c", ["(a + b) * c", "a + b", "a", "b", "c"]),
        ("a * ((b))", ["a * ((b))", "a", "b"]),
        ("-(a).x++", ["-(a).x++", "(a).x++", "(a).x", "a"]),
        ("f( (a), b )", ["f( (a), b )", "a", "b"]),
        ("(a)[(b)]", ["(a)[(b)]", "a", "b"]),
        ("(a).length( )", ["(a).length( )", "a"]),
        ("(a) ? (b) : (c)", ["(a) ? (b) : (c)", "a", "b", "c"]),
        ("(a) = (b)", ["(a) = (b)", "a", "b"]),
        ("(a), (b)", ["(a), (b)", "a", "b"]),
        ("a + (b) * (c)", ["a + (b) * (c)", "a", "(b) * (c)", "b", "c"]),
        ("(a + b) - c - (d)", ["(a + b) - c - (d)", "(a + b) - c", "a + b", "a", "b", "c", "d"]),
        ("vec2[ ]( a )[0]", ["vec2[ ]( a )[0]", "vec2[ ]( a )", "a", "0"]),
        ("f( void )", ["f( void )"]),
    ],
)
def test_expressions(text: str, expected: list[str]) -> None:
    assert texts(text) == expected


def test_parentheses_belong_to_the_statement() -> None:
    source = Source("test", "#version 330\nvoid main() { (a); return (b); }")
    function = parse(source).decls[0]
    assert isinstance(function, FunctionDef)
    spans = [statement.span for statement in function.body.body]
    assert [source.text[start:end] for start, end in spans] == ["(a);", "return (b);"]


def test_all_of_a_macro_has_the_span_of_its_use() -> None:
    source = Source("test", "#version 330\n#define A (b + c)\nfloat x = A * d;")
    found = [source.text[node.span.start : node.span.end] for node in expressions(parse(source))]
    assert found == ["A * d", "A", "A", "A", "d"]


@pytest.fixture(scope="module")
def language() -> tuple[Source, Module]:
    source = Source("language.frag", LANGUAGE.read_text())
    return source, parse(source)


def test_children_lie_in_their_parents_and_in_order(language: tuple[Source, Module]) -> None:
    _, module = language
    for node in walk(module):
        inner = [child for child in children(node) if child is not NO_QUALIFIERS]
        assert all(node.span.start <= child.span.start for child in inner)
        assert all(child.span.end <= node.span.end for child in inner)
        if not isinstance(node, Module):
            assert all(a.span.end <= b.span.start or a.span == b.span for a, b in pairs(inner))


def pairs(nodes: list[Node]) -> list[tuple[Node, Node]]:
    return list(pairwise(nodes))


def test_the_text_of_a_node_parses_to_the_node(language: tuple[Source, Module]) -> None:
    source, module = language
    # One text for all: what names mean does not matter here, apart from the structs.
    structs = "struct Ray { float a; };"
    macros = "#define PI 3.14159265\n#define TAU (2.0 * PI)\n#define STEPS 4\n"
    for node in walk(module):
        text = source.text[node.span.start : node.span.end]
        if node is NO_QUALIFIERS or text == "TAU":  # All parts of a macro have its span.
            continue
        if isinstance(node, EXPRESSIONS) and "Ray." not in text and text != "Ray":
            inner = f"#version 330\n{macros}{structs}void f() {{ {text}; }}"
            assert print_node(node) == print_node(only_expression(inner))
        elif isinstance(node, (*STATEMENTS, Qualifiers, TypeSpec)):
            assert text == text.strip()
            assert text


def only_expression(text: str) -> Node:
    function = parse(Source("inner", text)).decls[-1]
    assert isinstance(function, FunctionDef)
    (statement,) = function.body.body
    assert isinstance(statement, ExprStmt)
    assert statement.expr is not None
    return statement.expr


def test_statements_end_with_their_last_token(language: tuple[Source, Module]) -> None:
    source, module = language
    for node in walk(module):
        if isinstance(node, STATEMENTS):
            assert source.text[node.span.end - 1] in ";}:"

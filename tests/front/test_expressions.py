"""Expressions: what tree each construct becomes."""

from __future__ import annotations

from dataclasses import fields

import pytest

from shadercache.ast.nodes import ExprStmt, FunctionDef, Literal, Name, Node
from shadercache.front.parse import parse
from shadercache.source import Source


def shape(node: Node) -> str:
    """The tree in prefix notation; names and literals stand for themselves."""
    match node:
        case Name(name=name):
            return name
        case Literal(text=text):
            return text
    parts: list[str] = []
    for field in fields(node):
        value = getattr(node, field.name)
        for part in value if isinstance(value, tuple) else (value,):
            if isinstance(part, Node):
                parts.append(shape(part))
            elif field.name != "span" and isinstance(part, str):
                parts.append(part)
    inner = "".join(f" {part}" for part in parts if part)
    return f"({type(node).__name__}{inner})"


def expression(text: str, before: str = "") -> Node:
    """The tree of the last statement of a function."""
    source = Source("test", f"#version 330\n{before}\nvoid main() {{ {text}; }}")
    function = parse(source).decls[-1]
    assert isinstance(function, FunctionDef)
    statement = function.body.body[-1]
    assert isinstance(statement, ExprStmt)
    assert statement.expr is not None
    return statement.expr


@pytest.mark.parametrize(
    ("text", "tree"),
    [
        ("a", "a"),
        ("1.0", "1.0"),
        ("true", "true"),
        ("-a", "(Unary - a)"),
        ("- -a", "(Unary - (Unary - a))"),
        ("--a", "(Unary -- a)"),
        ("a - -b", "(Binary - a (Unary - b))"),
        ("a---b", "(Binary - (Postfix -- a) b)"),
        ("!~+a", "(Unary ! (Unary ~ (Unary + a)))"),
        ("-a++", "(Unary - (Postfix ++ a))"),
        ("++a--", "(Unary ++ (Postfix -- a))"),
        ("a.x", "(Member a x)"),
        ("a.xy.yx", "(Member (Member a xy) yx)"),
        ("a[b].c[d]", "(Index (Member (Index a b) c) d)"),
        ("a[b, c]", "(Index a (Comma b c))"),
        ("a.length()", "(Length a)"),
        ("a[1].length()", "(Length (Index a 1))"),
        ("f()", "(Call f)"),
        ("f(void)", "(Call f)"),
        ("f(a, b)", "(Call f a b)"),
        ("f((a, b))", "(Call f (Comma a b))"),
        ("f(a)[0].x", "(Member (Index (Call f a) 0) x)"),
        ("vec3(a)", "(Construct (TypeSpec vec3) a)"),
        ("vec3(a).x", "(Member (Construct (TypeSpec vec3) a) x)"),
        ("mat4x3(a)", "(Construct (TypeSpec mat4x3) a)"),
        ("float[2](a, b)", "(Construct (TypeSpec float 2) a b)"),
        ("vec3[](a)[0]", "(Index (Construct (TypeSpec vec3) a) 0)"),
        ("a ? b : c", "(Conditional a b c)"),
        ("a ? b : c ? d : e", "(Conditional a b (Conditional c d e))"),
        ("a ? b ? c : d : e", "(Conditional a (Conditional b c d) e)"),
        ("a ? b, c : d", "(Conditional a (Comma b c) d)"),
        ("a ? b : c = d", "(Conditional a b (Assign = c d))"),
        ("a || b ? c : d", "(Conditional (Binary || a b) c d)"),
        ("a = b = c", "(Assign = a (Assign = b c))"),
        ("a += b ? c : d", "(Assign += a (Conditional b c d))"),
        ("a = b, c = d", "(Comma (Assign = a b) (Assign = c d))"),
        ("a, b, c", "(Comma (Comma a b) c)"),
        ("a.x = b", "(Assign = (Member a x) b)"),
        ("(a)", "a"),
        ("((a + b)) * c", "(Binary * (Binary + a b) c)"),
        ("a - (b - c)", "(Binary - a (Binary - b c))"),
    ],
)
def test_tree(text: str, tree: str) -> None:
    assert shape(expression(text)) == tree


LEVELS = (
    ("||",),
    ("^^",),
    ("&&",),
    ("|",),
    ("^",),
    ("&",),
    ("==", "!="),
    ("<", ">", "<=", ">="),
    ("<<", ">>"),
    ("+", "-"),
    ("*", "/", "%"),
)
"""GLSL 3.30, section 5.1: binary operators from the loosest to the tightest."""

OPERATORS = [(op, level) for level, ops in enumerate(LEVELS) for op in ops]


@pytest.mark.parametrize(("first", "low"), OPERATORS)
def test_precedence_of_each_pair_of_operators(first: str, low: int) -> None:
    for second, high in OPERATORS:
        got = shape(expression(f"a {first} b {second} c"))
        left = f"(Binary {second} (Binary {first} a b) c)"
        right = f"(Binary {first} a (Binary {second} b c))"
        assert got == (right if high > low else left)


@pytest.mark.parametrize("op", ["=", "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|="])
def test_assignment_operators(op: str) -> None:
    assert shape(expression(f"a {op} b")) == f"(Assign {op} a b)"
    assert shape(expression(f"a{op}b")) == f"(Assign {op} a b)"


@pytest.mark.parametrize("op", [op for op, _ in OPERATORS])
def test_operators_are_taken_as_long_as_they_go(op: str) -> None:
    assert shape(expression(f"a{op}b")) == f"(Binary {op} a b)"


def test_a_long_chain_folds_by_precedence() -> None:
    got = shape(expression("a || b && c == d + e * f - g < h || i"))
    product = "(Binary - (Binary + d (Binary * e f)) g)"
    equal = f"(Binary == c (Binary < {product} h))"
    assert got == f"(Binary || (Binary || a (Binary && b {equal})) i)"


@pytest.mark.parametrize(
    "spelling",
    [
        *("0", "7", "017", "0x1F", "0XaBu", "42u", "42U", "2147483648", "0u"),
        *("1.", ".5", "1.0", "1e5", "1E-5", "1.e+3", ".5e2", "1.0f", "1.F", "1e5f", "00.5", "09.0"),
        *("true", "false"),
    ],
)
def test_literals_keep_their_spelling(spelling: str) -> None:
    node = expression(spelling)
    assert isinstance(node, Literal)
    assert node.text == spelling


def test_a_hexadecimal_number_ends_before_a_sign() -> None:
    assert shape(expression("0xE+1")) == "(Binary + 0xE 1)"


def test_the_dot_after_a_number_belongs_to_it() -> None:
    assert shape(expression("1.+.5")) == "(Binary + 1. .5)"
    assert shape(expression("a.x*1.e2")) == "(Binary * (Member a x) 1.e2)"


def test_double_literals_of_later_versions() -> None:
    source = Source("test", "#version 400\ndouble d = 1.0lf + 2.0LF;")
    assert parse(source).decls


def test_type_names_of_later_versions_are_names_before() -> None:
    assert shape(expression("sample + precise * patch")) == (
        "(Binary + sample (Binary * precise patch))"
    )
    assert shape(expression("buffer(coherent)")) == "(Call buffer coherent)"

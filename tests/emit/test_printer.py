"""The printer: what is printed is the same tree again, laid out the same way every time."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from shadercache.ast.nodes import (
    NO_QUALIFIERS,
    Assign,
    Binary,
    Block,
    Call,
    Comma,
    Conditional,
    Construct,
    DoWhile,
    Expr,
    ExprStmt,
    For,
    FunctionDef,
    If,
    Index,
    Length,
    Literal,
    Member,
    Module,
    Name,
    Node,
    Postfix,
    Qualifiers,
    Stmt,
    TypeSpec,
    Unary,
    VarDecl,
    While,
)
from shadercache.ast.walk import walk
from shadercache.emit.printer import print_module, print_node
from shadercache.front.parse import parse
from shadercache.lang.words import ASSIGN_OPS, PRECEDENCE
from shadercache.source import NOWHERE, Source

SHADERS = Path(__file__).parent.parent / "front" / "shaders"


def shape(node: object) -> object:
    """A tree without its spans; a block around one statement counts as that statement, and words
    of qualifiers in any order."""
    if isinstance(node, tuple):
        return [shape(part) for part in node]
    if isinstance(node, Block) and len(node.body) == 1:
        return shape(node.body[0])
    if not isinstance(node, Node):
        return node
    if isinstance(node, Qualifiers):
        return [sorted(node.words), shape(node.layout)]
    inner = [shape(getattr(node, field.name)) for field in fields(node) if field.name != "span"]
    return [type(node).__name__, *inner]


def in_main(text: str) -> Module:
    return parse(Source("test", f"#version 330\nvoid main() {{\n{text}\n}}\n"))


def statements(module: Module) -> tuple[Stmt, ...]:
    (function,) = module.decls
    assert isinstance(function, FunctionDef)
    return function.body.body


def reprinted(text: str) -> str:
    """A statement printed, on one line."""
    (statement,) = statements(in_main(text))
    return " ".join(print_node(statement).split())


# --- round trips ----------------------------------------------------------------------------------


@pytest.mark.parametrize("path", sorted(SHADERS.iterdir()), ids=lambda path: path.name)
def test_whole_shaders(path: Path) -> None:
    module = parse(Source(path.name, path.read_text()))
    printed = print_module(module)
    again = parse(Source("printed", printed))
    assert shape(again.decls) == shape(module.decls)
    assert print_module(again) == printed
    assert (again.version, again.profile) == (module.version, module.profile)
    assert shape(again.directives) == shape(module.directives)


def test_every_node_can_be_printed_alone() -> None:
    for path in SHADERS.iterdir():
        for node in walk(parse(Source(path.name, path.read_text()))):
            text = print_node(node)
            assert text == text.strip() or isinstance(node, Module)
            assert text or node is NO_QUALIFIERS


NAMES = st.sampled_from(["a", "b", "c"]).map(lambda name: Name(NOWHERE, name))
LITERALS = st.sampled_from(["0", "1u", "0xE", "1.", ".5", "1e-3", "true"]).map(
    lambda text: Literal(NOWHERE, text)
)


def operations(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    """Expressions of one more level."""
    args = st.lists(inner, max_size=3).map(tuple)
    types = st.sampled_from(["float", "vec3"])
    sizes = st.one_of(st.just(()), st.just((None,)), inner.map(lambda size: (size,)))
    specs = st.builds(TypeSpec, st.just(NOWHERE), types, dims=sizes)

    def build(kind: Any, *parts: st.SearchStrategy[Any]) -> st.SearchStrategy[Expr]:
        return st.builds(kind, st.just(NOWHERE), *parts)

    return st.one_of(
        build(Unary, st.sampled_from(["+", "-", "!", "~", "++", "--"]), inner),
        build(Postfix, st.sampled_from(["++", "--"]), inner),
        build(Binary, st.sampled_from(sorted(PRECEDENCE)), inner, inner),
        build(Conditional, inner, inner, inner),
        build(Assign, st.sampled_from(sorted(ASSIGN_OPS)), inner, inner),
        build(Comma, inner, inner),
        build(Call, st.sampled_from(["f", "g"]), args),
        build(Construct, specs, args),
        build(Member, inner, st.sampled_from(["x", "yx"])),
        build(Index, inner, inner),
        build(Length, inner),
    )


EXPRESSIONS = st.recursive(st.one_of(NAMES, LITERALS), operations, max_leaves=25)


@settings(max_examples=300, deadline=None)
@given(EXPRESSIONS)
@pytest.mark.slow
def test_random_expressions(expr: Expr) -> None:
    text = print_node(expr)
    (statement,) = statements(in_main(text + ";"))
    assert isinstance(statement, ExprStmt)
    assert shape(statement.expr) == shape(expr)
    assert print_node(statement) == text + ";"


def bodies(inner: st.SearchStrategy[Stmt]) -> st.SearchStrategy[Stmt]:
    """Statements of one more level."""
    maybe = st.none() | inner
    at, a = st.just(NOWHERE), st.just(Name(NOWHERE, "a"))
    start = st.just(ExprStmt(NOWHERE, None))
    return st.one_of(
        st.builds(If, at, a, inner, maybe),
        st.builds(While, at, a, inner),
        st.builds(DoWhile, at, inner, a),
        st.builds(For, at, start, st.none() | a, st.none() | a, inner),
        st.builds(Block, at, st.lists(inner, max_size=3).map(tuple)),
    )


SIMPLE = st.sampled_from(["a", "b", ""]).map(
    lambda name: ExprStmt(NOWHERE, Name(NOWHERE, name) if name else None)
)


@settings(max_examples=300, deadline=None)
@given(st.recursive(SIMPLE, bodies, max_leaves=12))
@pytest.mark.slow
def test_random_statements(statement: Stmt) -> None:
    text = print_node(statement)
    (again,) = statements(in_main(text))
    assert shape(again) == shape(statement)
    assert print_node(again) == text


# --- parentheses and signs ------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "- -a;",
        "-(-a);",
        "+ +a;",
        "- --a;",
        "-(--a);",
        "a - -b;",
        "a - --b;",
        "a + +b;",
        "a + ++b;",
        "a++ + ++b;",
        "a-- - --b;",
        "-+-a;",
        "!!a;",
        "~-a;",
        "- - -a;",
    ],
)
def test_signs_do_not_run_together(text: str) -> None:
    assert shape(statements(in_main(reprinted(text)))) == shape(statements(in_main(text)))


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("((a));", "a;"),
        ("(a + b) * c;", "(a + b) * c;"),
        ("(a * b) + c;", "a * b + c;"),
        ("a - (b - c);", "a - (b - c);"),
        ("(a - b) - c;", "a - b - c;"),
        ("-(a + b);", "-(a + b);"),
        ("(-a).x;", "(-a).x;"),
        ("-(a.x);", "-a.x;"),
        ("(a = b) + c;", "(a = b) + c;"),
        ("a = (b = c);", "a = b = c;"),
        ("f((a, b), c);", "f((a, b), c);"),
        ("(a ? b : c) ? d : e;", "(a ? b : c) ? d : e;"),
        ("a ? b : (c ? d : e);", "a ? b : c ? d : e;"),
        ("a ? (b ? c : d) : e;", "a ? b ? c : d : e;"),
        ("a ? (b, c) : (d = e);", "a ? (b, c) : (d = e);"),
        ("(1).x; ", "(1).x;"),
        ("a[(b, c)];", "a[b, c];"),
        ("float x = (a, b);", "float x = (a, b);"),
        ("1.+.5;", "1. + .5;"),
        ("(a)++;", "a++;"),
        ("(++a)++;", "(++a)++;"),
    ],
)
def test_parentheses_come_from_precedence(text: str, printed: str) -> None:
    assert reprinted(text) == printed


def test_a_negative_literal_that_a_pass_made() -> None:
    minus = Literal(NOWHERE, "-1.0")
    assert print_node(Unary(NOWHERE, "-", minus)) == "- -1.0"
    assert print_node(Member(NOWHERE, minus, "x")) == "(-1.0).x"
    assert print_node(Binary(NOWHERE, "-", minus, minus)) == "-1.0 - -1.0"


@pytest.mark.slow
def test_a_long_chain() -> None:
    text = "a" + " + a" * 100_000 + ";"
    assert reprinted(text) == text


# --- layout ---------------------------------------------------------------------------------------


def test_else_stays_with_its_if() -> None:
    assert reprinted("if (a) { if (b) c; } else d;") == "if (a) { if (b) c; } else d;"
    inner = If(NOWHERE, Name(NOWHERE, "b"), ExprStmt(NOWHERE, Name(NOWHERE, "c")), None)
    loop = While(NOWHERE, Name(NOWHERE, "x"), inner)
    outer = If(NOWHERE, Name(NOWHERE, "a"), loop, ExprStmt(NOWHERE, Name(NOWHERE, "d")))
    expected = "if (a) { while (x) if (b) c; } else d;"
    assert " ".join(print_node(outer).split()) == expected


def test_directives_come_first_and_in_order() -> None:
    text = (
        "#version 450 core\n#pragma optimize(on)\n#extension GL_ARB_gpu_shader5 : enable\n"
        "float a;\n"
        "#extension GL_ARB_shader_bit_encoding : require\nfloat b;\n"
    )
    assert print_module(parse(Source("test", text))) == (
        "#version 450 core\n#pragma optimize(on)\n#extension GL_ARB_gpu_shader5 : enable\n"
        "#extension GL_ARB_shader_bit_encoding : require\n\nfloat a;\nfloat b;\n"
    )


def test_an_empty_shader() -> None:
    assert print_module(parse(Source("test", "#version 330"))) == "#version 330\n"


def test_qualifiers_are_put_in_an_order_that_every_version_takes() -> None:
    node = Qualifiers(NOWHERE, ("highp", "out", "flat", "invariant", "precise"))
    assert print_node(node) == "precise invariant flat out highp"
    assert print_node(NO_QUALIFIERS) == ""


def test_the_layout_of_statements() -> None:
    text = """\
if (a) {
    b;
} else if (c)
    d;
else {
    e;
}
for (int i = 0; i < 3; i++)
    a;
for (;;) {
}
while (a)
    ;
do {
    a;
} while (b);
do
    a;
while (b);
switch (a) {
    case 1:
        b;
        break;
    default:
        c;
}
{
    a;
}
return;"""
    assert "\n".join(print_node(node) for node in statements(in_main(text))) == text


def test_the_layout_of_declarations() -> None:
    text = """\
#version 330

struct S {
    float a, b[2];
};

uniform B {
    layout(row_major) mat4 m;
} block[2];

const float k = 1.0;
S s[2];

float f(const in vec2 a, out float[2], inout S s);
float g(float);
"""
    expected = text.replace("\n\nfloat f(", "\nfloat f(")
    assert print_module(parse(Source("test", text))) == expected


def test_a_struct_in_a_function_is_indented() -> None:
    text = """\
#version 330

void main() {
    struct {
        float a;
    } s;
    s.a;
}
"""
    assert print_module(parse(Source("test", text))) == text


def test_parts_of_declarations() -> None:
    decl = parse(Source("t", "#version 330\nlayout(location = 1) flat in vec3[2] v[3];")).decls[0]
    assert isinstance(decl, VarDecl)
    assert print_node(decl.qualifiers) == "layout(location = 1) flat in"
    assert print_node(decl.type) == "vec3[2]"
    assert print_node(decl.declarators[0]) == "v[3]"

"""Big and deep shaders: no recursion."""

from __future__ import annotations

import pytest
from sema.tools import codes

from shadercache.ast.nodes import (
    NO_QUALIFIERS,
    Assign,
    Binary,
    Block,
    Conditional,
    Declarator,
    DeclStmt,
    Expr,
    ExprStmt,
    FunctionDef,
    FunctionProto,
    If,
    Literal,
    Module,
    Name,
    Stmt,
    TypeSpec,
    Unary,
    VarDecl,
)
from shadercache.sema.facts import Facts
from shadercache.source import NOWHERE, Source
from shadercache.valid.validate import validate

SOURCE = Source("made.frag", "")


def checked(body: tuple[Stmt, ...]) -> Facts:
    """Facts of a module made by hand: ``float x = 1.0;`` and then ``body`` in ``main``."""
    kind = TypeSpec(NOWHERE, "float")
    init = Declarator(NOWHERE, "x", (), Literal(NOWHERE, "1.0"))
    first = DeclStmt(NOWHERE, VarDecl(NOWHERE, NO_QUALIFIERS, kind, (init,)))
    proto = FunctionProto(NOWHERE, NO_QUALIFIERS, TypeSpec(NOWHERE, "void"), "main", ())
    main = FunctionDef(NOWHERE, proto, Block(NOWHERE, (first, *body)))
    return validate(Module(NOWHERE, 330, None, (), (main,)), SOURCE)


def x() -> Name:
    return Name(NOWHERE, "x")


def test_a_chain_of_100_000_additions() -> None:
    chain: Expr = x()
    for _ in range(100_000):
        chain = Binary(NOWHERE, "+", chain, x())
    facts = checked((ExprStmt(NOWHERE, chain),))
    assert len(facts.types) == 200_002


@pytest.mark.parametrize("depth", [20_000])
def test_deep_expressions(depth: int) -> None:
    right: Expr = x()
    unary: Expr = x()
    ternary: Expr = x()
    assigned: Expr = x()
    for _ in range(depth):
        right = Binary(NOWHERE, "+", x(), right)
        unary = Unary(NOWHERE, "-", unary)
        ternary = Conditional(NOWHERE, Literal(NOWHERE, "true"), x(), ternary)
        assigned = Assign(NOWHERE, "=", x(), assigned)
    for deep in (right, unary, ternary, assigned):
        checked((ExprStmt(NOWHERE, deep),))


@pytest.mark.parametrize("depth", [5_000])
def test_deep_statements(depth: int) -> None:
    condition = Literal(NOWHERE, "true")
    nested: Stmt = ExprStmt(NOWHERE, x())
    chain: Stmt = ExprStmt(NOWHERE, x())
    block: Stmt = Block(NOWHERE, ())
    for _ in range(depth):
        nested = If(NOWHERE, condition, nested, None)
        chain = If(NOWHERE, condition, ExprStmt(NOWHERE, x()), chain)
        block = Block(NOWHERE, (block,))
    for deep in (nested, chain, block):
        checked((deep,))


def calls_down(count: int) -> str:
    functions = "".join(
        f"float f{i}(float x) {{ return f{i - 1}(x) + f{i - 1}(x); }}\n" for i in range(1, count)
    )
    return f"float f0(float x) {{ return x; }}\n{functions}void main() {{ f{count - 1}(1.0); }}\n"


def test_a_deep_call_graph_without_recursion() -> None:
    assert codes(f"#version 330\n{calls_down(1500)}") == []


def test_many_overloads() -> None:
    count = 500
    heads = "".join(
        f"struct S{i} {{ float a; }};\nfloat f(S{i} x) {{ return x.a; }}\n" for i in range(count)
    )
    uses = "".join(f"f(S{i}(1.0));\n" for i in range(count))
    assert codes(f"#version 330\n{heads}void main() {{\n{uses}}}\n") == []


def test_many_unknown_names() -> None:
    lines = "".join(f"unknown{i} = 1.0;\n" for i in range(500))
    assert codes(f"#version 330\nvoid main() {{\n{lines}}}\n") == ["SC201"] * 500

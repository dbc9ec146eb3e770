"""Rewriting: what changes is new, what does not is shared, and hooks can do what passes need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from shadercache.ast.nodes import (
    NO_QUALIFIERS,
    Assign,
    Binary,
    Block,
    Call,
    Decl,
    Declarator,
    DeclStmt,
    Expr,
    ExprStmt,
    FunctionDef,
    If,
    Jump,
    Literal,
    Module,
    Name,
    Node,
    Stmt,
    TypeSpec,
    Unary,
    VarDecl,
)
from shadercache.ast.rewriter import Rewriter, map_expressions_keyed, replace_expressions
from shadercache.ast.walk import expressions, walk
from shadercache.emit.printer import print_module, print_node
from shadercache.front.parse import parse
from shadercache.source import NOWHERE, Source

LANGUAGE = Path(__file__).parent.parent / "front" / "shaders" / "language.frag"


def module(text: str) -> Module:
    return parse(Source("test", "#version 330\n" + text))


def body(text: str) -> Module:
    return module(f"void main() {{ {text} }}")


def inside(tree: Module) -> str:
    """The statements of the only function, on one line."""
    (function,) = tree.decls
    assert isinstance(function, FunctionDef)
    return " ".join(" ".join(print_node(node).split()) for node in function.body.body)


def rename(_: Expr, expr: Expr) -> Expr:
    return replace(expr, name="z") if isinstance(expr, Name) and expr.name == "a" else expr


# --- identity and sharing -------------------------------------------------------------------------


def test_the_rewriter_is_the_identity() -> None:
    tree = parse(Source("language.frag", LANGUAGE.read_text()))
    assert Rewriter().rewrite(tree) is tree
    assert replace_expressions(tree, lambda _, expr: expr) is tree
    assert map_expressions_keyed(tree, {}) is tree


def test_every_class_of_nodes_can_be_put_together_again() -> None:
    class Copy(Rewriter):
        """Makes every node anew, so that every parent has to be."""

        def expression(self, node: Expr, original: Expr) -> Expr:
            return replace(node)

        def statement(self, node: Stmt, original: Stmt) -> Stmt:
            return replace(node)

        def declaration(self, node: Decl, original: Decl) -> Decl:
            return replace(node)

        def other(self, node: Node, original: Node) -> Node:
            return replace(node)

    tree = parse(Source("language.frag", LANGUAGE.read_text()))
    copy = Copy().rewrite(tree)
    assert print_module(copy) == print_module(tree)
    assert not {id(node) for node in walk(copy)} & {id(node) for node in walk(tree)}
    assert [node.span for node in walk(copy)] == [node.span for node in walk(tree)]


def test_what_did_not_change_is_shared() -> None:
    tree = module("float b; void f() { b; } void g() { a; b; }")
    after = replace_expressions(tree, rename)
    assert after is not tree
    assert after.decls[0] is tree.decls[0]
    assert after.decls[1] is tree.decls[1]
    first, second = tree.decls[2], after.decls[2]
    assert isinstance(first, FunctionDef)
    assert isinstance(second, FunctionDef)
    assert second is not first
    assert second.body.body[1] is first.body.body[1]
    assert second.span == first.span


# --- expressions ----------------------------------------------------------------------------------


def test_expressions_are_replaced_everywhere() -> None:
    tree = module(
        "layout(location = a) out vec4 o[a]; struct S { float f[a]; };"
        "uniform B { float f[a]; } b[a];"
        "float f(float x[a]) { float y[a] = float[a](a); for (int i = a; a; a) a; while (a) a;"
        "do a; while (a); if (a) a; else a; switch (a) { case a: a; } return a[a] + a.length(); }"
    )
    after = replace_expressions(tree, rename)
    assert not any(isinstance(expr, Name) and expr.name == "a" for expr in expressions(after))
    count = sum(isinstance(expr, Name) and expr.name == "a" for expr in expressions(tree))
    renamed = sum(isinstance(expr, Name) and expr.name == "z" for expr in expressions(after))
    assert renamed == count == 26


def test_the_function_is_given_the_rebuilt_expression() -> None:
    def double(_: Expr, expr: Expr) -> Expr:
        if isinstance(expr, Literal):
            return Literal(expr.span, str(2 * int(expr.text)))
        if isinstance(expr, Binary):
            assert isinstance(expr.left, Literal)
            assert isinstance(expr.right, Literal)
            return Literal(expr.span, str(int(expr.left.text) + int(expr.right.text)))
        return expr

    assert inside(replace_expressions(body("1 + 2 + 3;"), double)) == "12;"


def test_a_replacement_is_not_visited() -> None:
    def grow(_: Expr, expr: Expr) -> Expr:
        return Call(expr.span, "f", (expr,)) if isinstance(expr, Name) else expr

    assert inside(replace_expressions(body("a + b;"), grow)) == "f(a) + f(b);"


def test_keyed_replacement_goes_by_identity() -> None:
    tree = body("a + a * a;")
    second = [expr for expr in expressions(tree) if isinstance(expr, Name)][1]
    after = map_expressions_keyed(tree, {second: Name(NOWHERE, "z")})
    assert inside(after) == "a + z * a;"


def test_an_outer_key_wins() -> None:
    tree = body("a + b * c;")
    product = next(e for e in expressions(tree) if isinstance(e, Binary) and e.op == "*")
    inner = {product: Name(NOWHERE, "p"), product.left: Name(NOWHERE, "q")}
    assert inside(map_expressions_keyed(tree, inner)) == "a + p;"


def test_a_hook_knows_the_original() -> None:
    pairs: list[tuple[Expr, Expr]] = []

    class Note(Rewriter):
        def expression(self, node: Expr, original: Expr) -> Expr:
            pairs.append((node, original))
            return rename(original, node)

    tree = body("f(a, b);")
    Note().rewrite(tree)
    call, *names = expressions(tree)
    assert [original for _, original in pairs] == [*names, call]
    assert pairs[1][0] is pairs[1][1]
    assert pairs[2][0] is not pairs[2][1]


def test_a_long_chain_is_rewritten() -> None:
    tree = body("a" + " + a" * 30_000 + ";")
    after = replace_expressions(tree, rename)
    names = [expr.name for expr in expressions(after) if isinstance(expr, Name)]
    assert names == ["z"] * 30_001


def test_an_expression_can_be_the_root() -> None:
    node = Unary(NOWHERE, "-", Name(NOWHERE, "a"))
    assert print_node(replace_expressions(node, rename)) == "-z"
    assert print_node(map_expressions_keyed(node, {node: Name(NOWHERE, "b")})) == "b"


# --- statements -----------------------------------------------------------------------------------


class Twice(Rewriter):
    """``a;`` twice; ``b;`` not at all."""

    def statement(self, node: Stmt, original: Stmt) -> Stmt | Sequence[Stmt]:
        if isinstance(node, ExprStmt) and isinstance(node.expr, Name):
            return {"a": (node, node), "b": ()}.get(node.expr.name, (node,))
        return node


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("a; c;", "a; a; c;"),
        ("b; c;", "c;"),
        ("{ a; }", "{ a; a; }"),
        ("if (x) a;", "if (x) { a; a; }"),
        ("if (x) b;", "if (x) ;"),
        ("if (x) c; else a;", "if (x) c; else { a; a; }"),
        ("if (x) c; else b;", "if (x) c;"),
        ("for (;;) a;", "for (;;) { a; a; }"),
        ("while (x) b;", "while (x) ;"),
        ("do a; while (x);", "do { a; a; } while (x);"),
        ("switch (x) { case 1: a; b; }", "switch (x) { case 1: a; a; }"),
    ],
)
def test_a_statement_becomes_several_or_none(before: str, after: str) -> None:
    assert inside(Twice().rewrite(body(before))) == after


def test_the_head_of_a_loop_stays_one_statement() -> None:
    with pytest.raises(TypeError, match="several nodes"):
        Twice().rewrite(body("for (a; x; x) ;"))


def test_the_root_stays_one_node() -> None:
    with pytest.raises(TypeError, match="one node"):
        Twice().rewrite(ExprStmt(NOWHERE, Name(NOWHERE, "a")))


def test_a_body_becomes_a_block_again() -> None:
    class Unwrap(Rewriter):
        def statement(self, node: Stmt, original: Stmt) -> Stmt | Sequence[Stmt]:
            return node.body if isinstance(node, Block) else node

    assert inside(Unwrap().rewrite(body("a; { b; { c; } }"))) == "a; b; c;"
    assert inside(Unwrap().rewrite(body("a;"))) == "a;"


# --- declarations and the rest --------------------------------------------------------------------


def test_declarations_are_dropped_and_added() -> None:
    class Edit(Rewriter):
        def declaration(self, node: Decl, original: Decl) -> Decl | Sequence[Decl]:
            return () if isinstance(node, FunctionDef) else (node, node)

    after = Edit().rewrite(module("float a; void f() { float b; }"))
    assert print_module(after) == "#version 330\n\nfloat a;\nfloat a;\n"


def test_types_and_names_are_rewritten() -> None:
    class Rename(Rewriter):
        def other(self, node: Node, original: Node) -> Node:
            if isinstance(node, Declarator):
                return replace(node, name=node.name + "_1")
            return replace(node, name="vec2") if isinstance(node, TypeSpec) else node

    after = Rename().rewrite(body("float a = float(1), b;"))
    assert inside(after) == "vec2 a_1 = vec2(1), b_1;"


def test_enter_replaces_without_a_look_inside() -> None:
    seen: list[str] = []

    class Cut(Rewriter):
        def enter(self, node: Node) -> Node | None:
            return Jump(node.span, "discard") if isinstance(node, If) else None

        def expression(self, node: Expr, original: Expr) -> Expr:
            seen.append(print_node(node))
            return node

    assert inside(Cut().rewrite(body("if (a) b; c;"))) == "discard; c;"
    assert seen == ["c"]


def test_a_new_statement_before_another() -> None:
    """What a hoisting pass does: a statement becomes a declaration and itself."""

    class Hoist(Rewriter):
        def statement(self, node: Stmt, original: Stmt) -> Stmt | Sequence[Stmt]:
            if not (isinstance(node, ExprStmt) and isinstance(node.expr, Assign)):
                return node
            declarator = Declarator(NOWHERE, "t", (), node.expr.value)
            type_spec = TypeSpec(NOWHERE, "float")
            decl = DeclStmt(NOWHERE, VarDecl(NOWHERE, NO_QUALIFIERS, type_spec, (declarator,)))
            assign = replace(node.expr, value=Name(NOWHERE, "t"))
            return decl, replace(node, expr=assign)

    assert inside(Hoist().rewrite(body("a = b + c;"))) == "float t = b + c; a = t;"

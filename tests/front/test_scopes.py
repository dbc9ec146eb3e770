"""Is a word a type or a variable? Struct names follow the scopes, and variables may hide them."""

from __future__ import annotations

import pytest

from shadercache.ast.nodes import Binary, Call, Construct, Declarator, Expr, Name, Node
from shadercache.ast.walk import walk
from shadercache.diagnostics import InputError
from shadercache.front.parse import parse
from shadercache.source import Source

STRUCT = "struct S { float a; };\n"


def nodes(text: str) -> list[Node]:
    return list(walk(parse(Source("test", "#version 330\n" + text))))


def initialiser(text: str) -> Expr:
    """The initialiser of the variable ``it``."""
    for node in nodes(text):
        if isinstance(node, Declarator) and node.name == "it":
            assert node.init is not None
            return node.init
    raise AssertionError("no variable called 'it'")


def test_a_struct_name_declares_and_constructs() -> None:
    assert isinstance(initialiser(STRUCT + "S it = S(1.0);"), Construct)


def test_a_variable_may_have_the_name_of_its_type() -> None:
    found = nodes(STRUCT + "void f() { S S = S(1.0); S.a; }")
    assert any(isinstance(node, Declarator) and node.name == "S" for node in found)
    assert any(isinstance(node, Construct) for node in found)
    assert any(isinstance(node, Name) and node.name == "S" for node in found)


def test_the_initialiser_sees_the_type_and_the_next_name_the_variable() -> None:
    text = STRUCT + "void f() { S S = S(1.0), it = S; }"
    assert isinstance(initialiser(text), Name)


def test_a_parameter_hides_a_type_in_the_body_only() -> None:
    text = STRUCT + "float f(S S) { return S.a; }\nS it = S(1.0);"
    assert isinstance(initialiser(text), Construct)


def test_a_parameter_of_a_prototype_hides_nothing() -> None:
    text = STRUCT + "float f(S S);\nS it = S(1.0);"
    assert isinstance(initialiser(text), Construct)


def test_the_first_token_after_a_function_is_judged_outside_it() -> None:
    found = nodes(STRUCT + "void f(float S) { }\nS g() { return S(1.0); }")
    assert sum(isinstance(node, Construct) for node in found) == 1


@pytest.mark.parametrize(
    "inner",
    [
        "{ float S = 1.0; S; }",
        "for (float S = 1.0; ; ) { S; }",
        "for (float S = 1.0; ; ) S;",
        "while (bool S = true) { S; }",
        "while (bool S = true) S;",
        "if (true) float S = 1.0;",
        "if (true) { float S; } else { float S; }",
        "do { float S; } while (true);",
        "do float S = 1.0; while (true);",
        "switch (1) { case 1: float S = 1.0; }",
        "{ { float S; } { float S; } }",
    ],
)
def test_a_type_is_back_when_the_scope_that_hides_it_ends(inner: str) -> None:
    text = STRUCT + f"void f() {{ {inner} S it = S(1.0); }}"
    assert isinstance(initialiser(text), Construct)


def test_the_header_of_a_loop_is_in_scope_in_its_body() -> None:
    text = STRUCT + "void f() { for (float S = 1.0; ; ) { float it = S + 1.0; } }"
    node = initialiser(text)
    assert isinstance(node, Binary)
    assert isinstance(node.left, Name)


def test_a_struct_of_an_inner_block_ends_with_it() -> None:
    text = "void f() { { struct S { float a; }; S s = S(1.0); } float S; float it = S; }"
    assert isinstance(initialiser(text), Name)


def test_a_struct_may_hide_a_variable() -> None:
    text = "float S; void f() { struct S { float a; }; S it = S(1.0); }"
    assert isinstance(initialiser(text), Construct)


def test_a_hidden_struct_called_like_a_function_is_a_call() -> None:
    text = STRUCT + "void f() { float S; float it = S(1.0); }"
    assert isinstance(initialiser(text), Call)


def test_fields_hide_nothing() -> None:
    text = STRUCT + "struct T { float S; }; S it = S(1.0);"
    assert isinstance(initialiser(text), Construct)
    assert nodes(STRUCT + "struct T { float S; }; void f(T t) { t.S; }")


def test_fields_of_a_block_without_instance_are_variables() -> None:
    found = nodes("struct S { float a; }; uniform B { float q; }; float it = q;")
    assert any(isinstance(node, Name) and node.name == "q" for node in found)


def test_an_array_of_structs() -> None:
    found = nodes(STRUCT + "S[2] a = S[2](S(1.0), S(2.0)); void f() { S S[2]; S[0] = S[1]; }")
    assert sum(isinstance(node, Construct) for node in found) == 3


def test_a_name_that_is_no_type_cannot_declare() -> None:
    with pytest.raises(InputError, match="'T' is not the name of a type"):
        nodes(STRUCT + "T t;")

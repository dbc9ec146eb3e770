"""The verifier finds what a wrong rewrite leaves behind."""

from __future__ import annotations

from dataclasses import replace

import pytest
from sema.tools import checked, initialisers
from verify_tree import InternalError, verify_module

from shadercache.ast.nodes import Expr, FunctionDef, Literal, Member, Module, Name
from shadercache.ast.rewriter import replace_expressions
from shadercache.source import NOWHERE

TEXT = """#version 330
in vec3 v_a;
out vec4 o_color;
float f(float x) { float y = x; return y; }
void main() {
    float x = 1.0;
    { vec2 x = vec2(2.0); o_color.xy = x; }
    o_color.z = f(v_a.x) + x;
}
"""


def test_a_valid_module_passes() -> None:
    module, facts = checked(TEXT)
    assert set(verify_module(module).types) == set(facts.types)


def test_a_rewritten_module_passes() -> None:
    def double(_: Expr, expr: Expr) -> Expr:
        return Literal(NOWHERE, "2.0") if isinstance(expr, Literal) else expr

    module, _ = checked(TEXT)
    facts = verify_module(replace_expressions(module, double))
    assert 2.0 in facts.constants.values()


def renamed(old: str, new: str) -> Module:
    def rename(_: Expr, expr: Expr) -> Expr:
        return Name(NOWHERE, new) if isinstance(expr, Name) and expr.name == old else expr

    return replace_expressions(checked(TEXT)[0], rename)


def test_a_name_that_is_gone() -> None:
    with pytest.raises(InternalError, match=r"invalid after renaming:\n.*'gone'"):
        verify_module(renamed("v_a", "gone"), after="renaming")


def test_a_type_that_does_not_fit() -> None:
    def drop_swizzle(_: Expr, expr: Expr) -> Expr:
        return expr.object if isinstance(expr, Member) and expr.name == "x" else expr

    with pytest.raises(InternalError, match="SC206"):
        verify_module(replace_expressions(checked(TEXT)[0], drop_swizzle))


def test_a_function_that_is_gone() -> None:
    module, _ = checked(TEXT)
    kept = tuple(d for d in module.decls if not (isinstance(d, FunctionDef) and d.name == "f"))
    with pytest.raises(InternalError, match="undeclared function 'f'"):
        verify_module(replace(module, decls=kept))


def test_a_name_twice_in_a_scope() -> None:
    module, _ = checked(TEXT)
    with pytest.raises(InternalError, match="already declared"):
        verify_module(replace(module, decls=(module.decls[0], *module.decls)))


def test_a_node_with_two_meanings() -> None:
    """The ``x`` of the inner block is put where the outer one is meant."""
    module, facts = checked(TEXT)
    inner = next(n for n, s in facts.symbols.items() if n.name == "x" and str(s.type) == "float")

    def share(_: Expr, expr: Expr) -> Expr:
        return inner if isinstance(expr, Name) and expr.name == "x" else expr

    with pytest.raises(InternalError, match="the name 'x' stands at two places"):
        verify_module(replace_expressions(module, share))


def test_a_shared_node_with_one_meaning_passes() -> None:
    module, _ = checked(TEXT)
    value = initialisers(module)["y"]

    def share(_: Expr, expr: Expr) -> Expr:
        return value if isinstance(expr, Name) and expr.name == "y" else expr

    verify_module(replace_expressions(module, share))


def test_unique_names_on_request() -> None:
    module, _ = checked(TEXT)
    verify_module(module)
    with pytest.raises(InternalError, match="two things are called 'x' after unique_names"):
        verify_module(module, after="unique_names", unique_names=True)


def test_unique_names_are_asked_of_functions_too() -> None:
    text = "#version 330\nvoid f() { }\nvoid f(int a) { }\nvoid main() { }\n"
    with pytest.raises(InternalError, match="'f'"):
        verify_module(checked(text)[0], unique_names=True)


def test_the_error_is_an_assertion() -> None:
    assert issubclass(InternalError, AssertionError)

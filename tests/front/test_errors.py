"""Syntax errors: where they are told, and in which words."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import InputError
from shadercache.front.parse import parse
from shadercache.source import Source


def told(text: str) -> str:
    """``line:column code message`` of the one error of a shader, and its hint."""
    with pytest.raises(InputError) as caught:
        parse(Source("test.frag", text))
    (item,) = caught.value.diagnostics
    assert item.source is not None
    assert item.span is not None
    line, column = item.source.position(item.span.start)
    hint = f" ({item.hint})" if item.hint else ""
    return f"{line}:{column} {item.code} {item.message}{hint}"


IN_FUNCTION = [
    ("float a = 1.0\nfloat b;", "3:14 SC103 expected ';' after declaration"),
    ("a = b\nc = d;", "3:6 SC103 expected ';' after expression"),
    ("a = b", "3:6 SC103 expected ';' after expression"),
    ("f(a)", "3:5 SC103 expected ';' after expression"),
    ("float a float b;", "3:8 SC103 expected ';' after declaration"),
    ("return a", "3:9 SC103 expected ';' after 'return'"),
    ("return", "3:7 SC103 expected ';' after 'return'"),
    ("break", "3:6 SC103 expected ';' after 'break'"),
    ("discard", "3:8 SC103 expected ';' after 'discard'"),
    ("do a; while (b)", "3:16 SC103 expected ';' after 'do ... while'"),
    ("for (int i = 0; i < 3, i++) a;", "3:27 SC103 expected ';' before ')'"),
    ("struct S { float a; }\nfloat b;", "3:22 SC103 expected ';' after the block"),
    ("a = (b + c;", "3:11 SC103 expected ')' before ';' (the '(' at 3:5 is open)"),
    ("f(a b);", "3:4 SC103 expected ',' or ')' before 'b' (the '(' at 3:2 is open)"),
    ("a[1;", "3:4 SC103 expected ']' before ';' (the '[' at 3:2 is open)"),
    ("(a]);", "3:3 SC103 expected ')' before ']' (the '(' at 3:1 is open)"),
    ("f(a", "3:4 SC103 expected ')' before '}' (the '(' at 3:2 is open)"),
    ("if (a > b c;", "3:10 SC103 expected ')' before 'c' (the '(' at 3:4 is open)"),
    ("a;)", "3:3 SC103 this ')' closes nothing"),
    ("a + );", "3:5 SC103 this ')' closes nothing"),
    ("{ a;", "2:13 SC103 this '{' is never closed"),
    ("a; } }", "3:6 SC103 this '}' closes nothing"),
    ("a = ;", "3:5 SC103 expected an expression after '='"),
    ("a = b + ;", "3:9 SC103 expected an expression after '+'"),
    ("a = * b;", "3:5 SC103 expected an expression after '='"),
    ("f(, a);", "3:3 SC103 expected an expression after '('"),
    ("a ? b : ;", "3:9 SC103 expected an expression after ':'"),
    ("a ? b;", "3:6 SC103 expected ':' after the second part of ?:"),
    ("while () a;", "3:8 SC103 expected an expression after '('"),
    ("if a > b c;", "3:4 SC103 expected '(' before 'a'"),
    ("if (a)", "4:1 SC103 expected a statement before '}'"),
    ("if (a) else b;", "3:8 SC103 expected a statement before 'else'"),
    ("else a;", "3:1 SC103 'else' without an 'if'"),
    (
        "if (a) b; c; else d;",
        "3:14 SC103 'else' without an 'if' (several statements before 'else' need braces)",
    ),
    ("case 1: a;", "3:1 SC103 'case' outside a 'switch'"),
    ("switch (a) { case 1 b; }", "3:20 SC103 expected ':' after the label"),
    ("Foo bar;", "3:1 SC103 'Foo' is not the name of a type"),
    ("const Foo bar;", "3:7 SC103 'Foo' is not the name of a type"),
    ("const a = 1;", "3:7 SC103 expected a type before 'a'"),
    ("in a;", "3:4 SC103 expected a type before 'a'"),
    ("float = 1;", "3:6 SC103 expected a name after 'float'"),
    ("a.;", "3:3 SC103 expected a name after '.'"),
    ("a.b();", "3:3 SC110 there is no method 'b'"),
    ("float in = 1.0;", "3:7 SC106 'in' is a keyword and cannot be a name"),
    ("float half;", "3:7 SC106 'half' is a reserved word of GLSL 3.30 (choose another name)"),
    (
        "precise float a;",
        "3:1 SC106 'precise' has no meaning in GLSL 3.30 (it needs #version 400 or later)",
    ),
    (
        "float a[2] = {1.0, 2.0};",
        "3:14 SC110 initialiser lists in braces need GLSL 4.20"
        " (write a constructor, such as float[2](1.0, 2.0))",
    ),
    ("uniform B { float a; } b;", "3:1 SC110 an interface block must not stand in a function"),
    (
        "float f() { return 1.0; }",
        "3:10 SC103 expected ';' after the function; one cannot be defined in another",
    ),
    ("precision in float;", "3:11 SC103 expected highp, mediump or lowp after 'precision'"),
    ("precision float;", "3:11 SC103 expected highp, mediump or lowp before 'float'"),
    ("a = 08;", "3:5 SC102 '08' is not a number of GLSL"),
    ("a = 1.0e;", "3:5 SC102 '1.0e' is not a number of GLSL"),
    ("a = 0x;", "3:5 SC102 '0x' is not a number of GLSL"),
    ("a = 2x;", "3:5 SC102 '2x' is not a number of GLSL"),
    ("a @ b;", "3:3 SC101 unexpected character '@'"),
    ("a # b;", "3:3 SC101 unexpected character '#'"),
    (
        "a = \u00a7b;",
        "3:5 SC101 unexpected character '\u00a7',"
        " which is not ASCII and may stand in comments only",
    ),
    ("a = \x01;", "3:5 SC101 unexpected character U+0001"),
    ("f(float);", "3:3 SC103 expected '(' after the type 'float'"),
]


@pytest.mark.parametrize(("text", "expected"), IN_FUNCTION)
def test_in_a_function(text: str, expected: str) -> None:
    assert told(f"#version 330\nvoid main() {{\n{text}\n}}\n") == expected


OUTSIDE = [
    ("float a", "2:8 SC103 expected ';' after declaration"),
    ("float f()", "2:10 SC103 expected ';' after declaration"),
    ("float f(", "2:8 SC103 this '(' is never closed"),
    ("float f(float a;", "2:16 SC103 expected ')' before ';' (the '(' at 2:8 is open)"),
    ("struct", "2:7 SC103 expected a name after 'struct'"),
    ("struct S", "2:9 SC103 expected '{' at the end of the file"),
    ("struct S {", "2:10 SC103 this '{' is never closed"),
    ("struct S { float a }", "2:19 SC103 expected ';' after declaration"),
    ("uniform", "2:8 SC103 expected a type after 'uniform'"),
    ("uniform B { float a; } b", "2:25 SC103 expected ';' after the block"),
    (
        "layout(location = 0 out vec4 a;",
        "2:20 SC103 expected ')' before 'out' (the '(' at 2:7 is open)",
    ),
    ("}", "2:1 SC103 this '}' closes nothing"),
    (
        "return;",
        "2:1 SC103 expected a declaration, found 'return'"
        " (outside functions there are only declarations)",
    ),
    (
        "a = 1;",
        "2:1 SC103 'a' is not the name of a type (outside functions there are only declarations)",
    ),
    ("void main() { a", "2:16 SC103 expected ';' after expression"),
    ("float a[", "2:8 SC103 this '[' is never closed"),
    ("float a = ", "2:10 SC103 expected an expression after '='"),
    (
        "buffer B { float a; };",
        "2:1 SC106 'buffer' has no meaning in GLSL 3.30 (it needs #version 430 or later)",
    ),
]


@pytest.mark.parametrize(("text", "expected"), OUTSIDE)
def test_outside_functions(text: str, expected: str) -> None:
    assert told(f"#version 330\n{text}").startswith(expected)


def test_an_error_in_a_macro_is_told_where_it_is_used() -> None:
    text = "#version 330\n#define BAD 1.0 +\nfloat a = BAD;\n"
    assert told(text) == "3:14 SC103 expected an expression after '+'"


def test_a_subroutine_is_refused() -> None:
    told_text = told("#version 400\nsubroutine float f();\n")
    assert told_text.startswith("2:1 SC111 subroutines are not supported")


def test_no_message_names_a_terminal_of_the_grammar() -> None:
    names = ("RPAR", "SEMICOLON", "BASIC_TYPE", "TYPE_NAME", "QUALIFIER", "$END", "LITERAL")
    for text, _ in IN_FUNCTION:
        message = told(f"#version 330\nvoid main() {{\n{text}\n}}\n")
        assert not any(name in message for name in names)

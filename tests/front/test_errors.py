"""Syntax errors: where they are told, and in which words."""

from __future__ import annotations

import pytest
from preprocessing import placed

from shadercache.diagnostics import InputError
from shadercache.front.parse import parse
from shadercache.source import Source


def told(text: str) -> str:
    """``line:column code message`` of the one error of a shader, and its hint."""
    with pytest.raises(InputError) as caught:
        parse(Source("test.frag", text))
    (item,) = caught.value.diagnostics
    hint = f" ({item.hint})" if item.hint else ""
    return f"{placed(item)} {item.message}{hint}"


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
    ("a = * b;", "3:5 SC103 expected an expression after '=' (GLSL has no pointers)"),
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
        "3:10 SC103 expected ';' after the function; one cannot be defined in another"
        " (the '{' at 2:13 is open)",
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


FOREIGN = [
    ("float3 a;", "3:1 SC103 'float3' is not the name of a type (write 'vec3')"),
    ("float4x4 a;", "3:1 SC103 'float4x4' is not the name of a type (write 'mat4')"),
    ("float3x4 a;", "3:1 SC103 'float3x4' is not the name of a type (write 'mat4x3')"),
    ("Texture2D a;", "3:1 SC103 'Texture2D' is not the name of a type (write 'sampler2D')"),
    ("flaot a;", "3:1 SC103 'flaot' is not the name of a type (did you mean 'float'?)"),
    (
        "struct Light { vec3 a; }; Ligth b;",
        "3:27 SC103 'Ligth' is not the name of a type (did you mean 'Light'?)",
    ),
    (
        "let a = 1;",
        "3:1 SC103 'let' is not the name of a type (a declaration begins with its type)",
    ),
    ("a = (float)b;", "3:11 SC103 GLSL has no casts (write float(...))"),
    ("a = (int) 1.0;", "3:9 SC103 GLSL has no casts (write int(...))"),
    ("a = a->b;", "3:6 SC103 '->' is no operator of GLSL (write '.')"),
    ("if (a === b) c;", "3:7 SC103 '===' is no operator of GLSL (write '==')"),
    ("if (a => b) c;", "3:7 SC103 '=>' is no operator of GLSL (write '>=')"),
    ("if (a <> b) c;", "3:7 SC103 '<>' is no operator of GLSL (write '!=')"),
    ("a = b ** 2;", "3:7 SC103 '**' is no operator of GLSL (write pow(x, y))"),
    ("a := 2;", "3:3 SC103 ':=' is no operator of GLSL (write '=')"),
    ("if (a and b) c;", "3:7 SC103 'and' is no operator of GLSL (write '&&')"),
    ("float *a;", "3:6 SC103 expected a name after 'float' (GLSL has no pointers)"),
    ("a = &b;", "3:5 SC103 expected an expression after '=' (GLSL has no pointers)"),
    (
        "float a[2] = [1.0, 2.0];",
        "3:14 SC103 expected an expression after '='"
        " (write an array's constructor, such as float[2](1.0, 2.0))",
    ),
    ('a = "b";', "3:5 SC101 unexpected character '\"' (GLSL has no strings)"),
    ("if (a) b; elseif (c) d;", "3:22 SC103 'elseif' is no word of GLSL (write 'else if')"),
    (
        "struct S s;",
        "3:10 SC103 expected '{' before 's' (the name of a struct is its type: S s)",
    ),
    (
        "float a = 1.0, float b;",
        "3:16 SC103 expected a name before 'float'"
        " (the names share one type; a declaration with another type begins after ';')",
    ),
    ("static float a;", "3:1 SC106 'static' is a reserved word of GLSL 3.30 (leave it out)"),
    ("unsigned int a;", "3:1 SC106 'unsigned' is a reserved word of GLSL 3.30 (write 'uint')"),
    ("half a;", "3:1 SC106 'half' is a reserved word of GLSL 3.30 (write 'float')"),
    ("float a 1.0;", "3:9 SC103 expected '=' before '1.0'"),
    ("a = 1.0.0;", "3:8 SC103 expected an operator before '.0'"),
]
"""What people write who come from C or HLSL."""


@pytest.mark.parametrize(("text", "expected"), FOREIGN)
def test_habits_of_other_languages(text: str, expected: str) -> None:
    assert told(f"#version 330\nvoid main() {{\n{text}\n}}\n") == expected


FOREIGN_OUTSIDE = [
    (
        "main() { }",
        "2:1 SC103 expected a type before 'main'"
        " (a function that returns nothing begins with 'void main(')",
    ),
    ("void main { }", "2:10 SC103 expected '(' after 'main'"),
    ("struct S { float a; }\nvoid main() { }", "2:22 SC103 expected ';' after the block"),
    (
        "int f(int a, b) { }",
        "2:14 SC103 'b' is not the name of a type (each parameter has a type of its own)",
    ),
    (
        "out vec4 color : SV_Target;",
        "2:16 SC103 unexpected ':' (GLSL has no semantics; variables meet by their names or by"
        " layout(location = ...))",
    ),
    ("cbuffer B { float a; };", "2:1 SC103 'cbuffer' is not the name of a type (write 'uniform')"),
    (
        "enum E { A };",
        "2:1 SC106 'enum' is a reserved word of GLSL 3.30 (write 'const int' variables)",
    ),
]


@pytest.mark.parametrize(("text", "expected"), FOREIGN_OUTSIDE)
def test_habits_of_other_languages_outside_functions(text: str, expected: str) -> None:
    assert told(f"#version 330\n{text}\n") == expected


VERSIONS = [
    ("100", "switch (1) { }", "'switch' is a reserved word of GLSL ES 1.00 (write a chain of if"),
    ("300 es", "varying vec2 a;", "'varying' is a reserved word of GLSL ES 3.00 (write 'out' in"),
    ("300 es", "uniform image2D a;", "'image2D' is a reserved word of GLSL ES 3.00 (it needs"),
    ("300 es", "float sample;", "'sample' is a reserved word of GLSL ES 3.00 (choose another"),
    ("120", "layout(location = 0) float a;", "'layout' has no meaning in GLSL 1.20 (it needs"),
    ("100", "uint a;", "'uint' has no meaning in GLSL ES 1.00 (it needs #version 300 es or later"),
    (
        "330",
        "buffer B { float a; };",
        "'buffer' has no meaning in GLSL 3.30 (it needs #version 430",
    ),
    ("100", "float a = 1.0f;", "GLSL ES 1.00 has no numbers that end in 'f' (write 1.0)"),
    ("120", "int a = 3u;", "GLSL 1.20 has no numbers that end in 'u' (write 3)"),
    ("330", "float a = 1.0lf;", "GLSL 3.30 has no numbers that end in 'lf' (write 1.0)"),
    ("300 es", "float a[1] = {1.0};", "initialiser lists in braces need GLSL 4.20 (write a"),
    ("450", "layout(in) in vec4 a;", "'in' is a keyword and cannot be a layout"),
]


@pytest.mark.parametrize(("version", "text", "expected"), VERSIONS)
def test_what_another_version_has(version: str, text: str, expected: str) -> None:
    line, _, message = told(f"#version {version}\n\nvoid f() {{ {text} }}\n").split(" ", 2)
    assert line.startswith("3:")
    assert message.startswith(expected)


def test_an_error_in_a_macro_is_told_where_it_is_used() -> None:
    text = "#version 330\n#define BAD 1.0 +\nfloat a = BAD;\n"
    assert told(text) == "3:14 SC103 expected an expression after '+'"


@pytest.mark.parametrize("version", ["330", "400"])
@pytest.mark.parametrize("text", ["subroutine float f();", "subroutine(T) float f() { }"])
def test_a_subroutine_is_refused(version: str, text: str) -> None:
    told_text = told(f"#version {version}\n{text}\n")
    assert told_text.startswith("2:1 SC111 subroutines are not supported")


def test_no_message_names_a_terminal_of_the_grammar() -> None:
    names = ("RPAR", "SEMICOLON", "BASIC_TYPE", "TYPE_NAME", "QUALIFIER", "$END", "LITERAL")
    for text, _ in IN_FUNCTION + FOREIGN:
        message = told(f"#version 330\nvoid main() {{\n{text}\n}}\n")
        assert not any(name in message for name in names)

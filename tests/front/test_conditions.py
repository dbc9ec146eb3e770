"""``#if`` and its kin: which groups are read, and the values of expressions (section 3.3)."""

from __future__ import annotations

import pytest
from preprocessing import errors, problem, rejected, words


def holds(expression: str, version: str = "450", before: str = "") -> bool:
    found = words(f"{before}\n#if {expression}\nyes\n#else\nno\n#endif\n", version)
    assert found in ("yes", "no")
    return found == "yes"


def wrong(expression: str, version: str = "450", before: str = "#") -> str:
    """The message about an expression, which stands in line 3."""
    found = problem(f"{before}\n#if {expression}\na\n#elif 1\nb\n#else\nc\n#endif\n", version)
    place, code, message = found.split(" ", 2)
    assert (place, code) == ("3:1", "SC122")
    return message


# --- expressions ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "expression",
    [
        *("1", "-1", "0x10 == 16", "0XfF == 255", "010 == 8", "4294967295 == -1"),
        *("!0 + 1 == 2", "1 - 1 - 1 == -1", "1 == 1 == 1", "~0 == -1", "- - 1", "+-+1", "!!2 == 1"),
        *("3 & 2 == 2", "1 | 0 ^ 1 & 0", "6 & 3 ^ 1 | 8", "1 << 2 + 1 == 8", "2 < 3 == 1"),
        *("1 && 0 || 1", "!(0 || 1 && 0)", "(1 || 1) && !0", "2 && 4", "0 || 8"),
        *("10 / 3 == 3", "-7 / 2 == -3", "-7 % 2 == -1", "7 % -2 == 1", "2 + 3 * 4 % 5 == 4"),
        *("1 << 33 == 2", "-1 >> 1 == -1", "2147483647 + 1 < 0", "1 << 31 < 0"),
        *("3 > 2", "3 >= 3", "2 <= 2", "1 != 2", "__LINE__ == 3", "__VERSION__ >= 450"),
        *("X == 0", "!X", "true == 0", "GL_core_profile", "( ( 1 ) )"),
        *("0 && 1 / 0 || 1", "1 || 1 / 0", "1 || 1 % 0", "0 && (1 / 0 + 1) || 1"),
    ],
)
def test_expressions_that_hold(expression: str) -> None:
    assert holds(expression)
    assert not holds(f"!({expression})")


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        ("", "a value is missing at the end of this expression"),
        ("1 +", "a value is missing at the end of this expression"),
        ("* 1", "expected a value before '*'"),
        ("1 2", "'2' is out of place in this expression"),
        ("a b", "'b' is out of place in this expression"),
        ("1 ? 1 : 0", "'?' is out of place in this expression"),
        ("1 = 1", "'=' is out of place in this expression"),
        ("1 , 0", "',' is out of place in this expression"),
        ("1 ^^ 0", "'^^' is out of place in this expression"),
        ("1 \u00e4", "'\u00e4' is out of place in this expression"),
        ("\u00e4", "expected a value before '\u00e4'"),
        ("(1", "a ')' is missing in this expression"),
        ("1)", "this expression has a ')' without a '('"),
        ("()", "expected a value before ')'"),
        ("1.0", "'1.0' is not an integer"),
        ("1u", "'1u' is not an integer"),
        ("08", "'08' is not an integer"),
        ("99999999999", "'99999999999' needs more than 32 bits"),
        ("0x100000000", "'0x100000000' needs more than 32 bits"),
        ("1 / 0", "division by zero"),
        ("1 && 1 % (1 - 1)", "division by zero"),
    ],
)
def test_expressions_that_are_wrong(expression: str, message: str) -> None:
    assert wrong(expression) == message


def test_defined() -> None:
    before = "#define A"
    for yes in (
        "defined A",
        "defined(A)",
        "defined ( A )",
        "!defined B",
        "defined A && !defined(B)",
    ):
        assert holds(yes, before=before)
    assert holds("defined GL_ES", "300 es")
    assert not holds("defined GL_ES")


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        ("defined", "'defined' needs the name of a macro"),
        ("defined(1)", "'defined' needs the name of a macro"),
        ("defined(", "'defined' needs the name of a macro"),
        ("defined(A", "expected ')' after 'defined(A'"),
        ("defined A B", "'B' is out of place in this expression"),
        ("D", "'defined' comes out of a macro, which compilers do not take"),
    ],
)
def test_defined_that_is_wrong(expression: str, message: str) -> None:
    assert wrong(expression, before="#define D defined(A)") == message


def test_macros_in_expressions() -> None:
    assert holds("A == 5 && F(2) == 4", before="#define A 2 + 3\n#define F(x) x * 2")
    assert not holds("F", before="#define F(x) x")
    assert problem("#define F(x) x\n#if F(1, 2)\n#endif\n").startswith("3:1 SC124")
    assert wrong("A", before="#define A") == "a value is missing at the end of this expression"


@pytest.mark.parametrize("version", ["100", "300 es"])
def test_es_section_3_4_a_name_that_is_no_macro_is_an_error(version: str) -> None:
    assert wrong("X", version) == "'X' is not defined, which GLSL ES forbids"
    assert wrong("1 && X > 1", version) == "'X' is not defined, which GLSL ES forbids"
    assert not holds("defined(X) && X > 1", version)
    assert holds("!defined(X) || X", version)


# --- groups ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("#ifdef A\na\n#endif\n", "a"),
        ("#ifndef A\na\n#else\nb\n#endif\n", "b"),
        ("#if 0\na\n#elif 1\nb\n#elif 1\nc\n#else\nd\n#endif\n", "b"),
        ("#if 0\na\n#elif 0\nb\n#else\nc\n#endif\n", "c"),
        ("#if 1\na\n#if 0\nb\n#else\nc\n#endif\nd\n#endif\ne\n", "a c d e"),
        ("#if 0\n#if 1\na\n#else\nb\n#endif\n#else\nc\n#endif\n", "c"),
        ("#if 0\n#if 0\n#elif 1\na\n#else\nb\n#endif\n#elif 1\nc\n#endif\n", "c"),
        ("  #  if 1 // yes\na\n # endif /* end */\n", "a"),
        ("float a[\n#if 1\n2\n#endif\n];", "float a [ 2 ] ;"),
    ],
)
def test_groups(text: str, expected: str) -> None:
    assert words(f"#define A\n{text}") == expected


def test_what_is_skipped_may_be_anything() -> None:
    inside = (
        '#if junk (\n#elif 1/0\n#else z\n#endif q\n#foo\n#define 1\n#include "x"\n#ifdef\n#endif\n'
    )
    assert words(f"#if 0\n{inside}@ don't \u00e4 \\ \n#else\na\n#endif\n") == "a"


def test_the_condition_of_a_branch_that_cannot_be_read_is_not_looked_at() -> None:
    assert words("#if 1\na\n#elif 1 / 0 junk (\nb\n#elif\n#endif\n") == "a"


def test_macros_are_defined_in_the_groups_that_are_read() -> None:
    assert words("#if 0\n#define A 1\n#else\n#define A 2\n#endif\nA") == "2"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("#if 1\nx\n", ["2:1 SC121"]),
        ("#if 0\nx\n", ["2:1 SC121"]),
        ("#if 1\n  #ifdef X\n#else\n", ["3:3 SC121"]),
        ("#endif\n#else\n#elif 1\n", ["2:1 SC121", "3:1 SC121", "4:1 SC121"]),
        ("#if 1\n#else\n#else\n#endif\n", ["4:1 SC121"]),
        ("#if 1\n#else\n#elif 1\n#endif\n", ["4:1 SC121"]),
        ("#if 1\n#else x\n#endif y\n", ["3:1 SC121", "4:1 SC121"]),
        ("#ifdef\n#foo\n#else\n#bar\n#endif\n", ["2:1 SC121"]),
        ("#ifdef 1\n#endif\n#ifndef A B\n#endif\n", ["2:1 SC121", "4:1 SC121"]),
        ("#if 0\n#elif +\n#foo\n#else\n#bar\n#endif\n", ["3:1 SC122"]),
    ],
)
def test_groups_that_are_wrong(text: str, expected: list[str]) -> None:
    assert errors(f"#version 330\n{text}") == expected


@pytest.mark.parametrize(
    "text",
    [
        "#if 1\n" * 50_000 + "a\n" + "#endif\n" * 50_000,
        "#if 0\n" + "#elif 0\n" * 50_000 + "#else\na\n#endif\n",
        "#if " + "(" * 100_000 + "1" + ")" * 100_000 + "\na\n#endif\n",
        "#if " + "!" * 100_000 + "1\na\n#endif\n",
        "#if " + "1+" * 100_000 + "1\na\n#endif\n",
    ],
    ids=lambda text: text[:12],
)
@pytest.mark.slow
def test_conditions_may_be_deep_and_long(text: str) -> None:
    assert words(text) == "a"


def test_a_number_of_many_digits_is_one_error() -> None:
    assert wrong("9" * 100_000).endswith("needs more than 32 bits")
    assert errors("#version " + "9" * 100_000) == ["1:1 SC100"]


def test_groups_without_an_end_are_told_once() -> None:
    (error,) = rejected("#version 330\n#if 1\n#ifdef X\n#if 0\n")
    assert error.hint == "nor have the 2 around it"
    (error,) = rejected("#version 330\n#if 1\n")
    assert error.hint is None

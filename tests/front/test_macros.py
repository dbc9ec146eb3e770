"""``#define``, ``#undef`` and the expansion of macros (section 3.3).

The expected texts are those of glslang 12 and, where that has bugs or limits, of the C standard.
"""

from __future__ import annotations

import re

import pytest
from preprocessing import errors, problem, rejected, words

from shadercache.front.read_options import ReadOptions


def test_a_macro_is_replaced_from_its_line_on() -> None:
    assert words("A\n#define A 1 + 2\nA\n#undef A\nA") == "A 1 + 2 A"


def test_macros_in_macros_are_those_of_the_place_of_use() -> None:
    assert words("#define A B\n#define B 1\nA\n#undef B\n#define B 2\nA") == "1 2"


def test_a_macro_may_be_empty() -> None:
    assert words("#define highp\nhighp float a;") == "float a ;"


def test_a_keyword_may_be_a_macro() -> None:
    assert words("#define float vec4\nfloat a;\n#undef float\nfloat b;") == "vec4 a ; float b ;"


def test_a_body_keeps_the_spelling_of_numbers() -> None:
    assert words("#define SIZE .03\n#define ONE(x) x.f\nSIZE ONE(1)") == ".03 1 . f"


# --- definitions ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("first", "second", "same"),
    [
        ("A 1 +  1", "A   1 + 1 // why", True),
        ("A 1+1", "A 1 + 1", False),
        ("A 1", "A 2", False),
        ("A", "A", True),
        ("A(x) x", "A(x) x", True),
        ("A(x) x", "A(y) y", False),
        ("A(x) x", "A x", False),
        ("A() 1", "A 1", False),
    ],
)
def test_a_macro_may_be_defined_again_in_the_same_way(first: str, second: str, same: bool) -> None:
    text = f"#define {first}\n#define {second}\n"
    if same:
        assert words(text) == ""
    else:
        assert problem(text) == "3:1 SC108 macro 'A' is defined again in another way"
        assert words(text.replace("\n", "\n#undef A\n", 1)) == ""


@pytest.mark.parametrize(
    "rest",
    [
        *("A(x", "A(x y) 1", "A(x,) 1", "A(,x) 1", "A(x,,y) 1", "A(1) 1", "A(...) 1", "A(x,x) 1"),
        *("A ## x", "A x ##", "A(x) ## x", "\u00e4 1"),
        *("GL_X", "GL_ES 1", "defined", "__LINE__ 1", "__FILE__", "__VERSION__ 1"),
    ],
)
def test_definitions_that_are_wrong(rest: str) -> None:
    assert errors(f"#version 330\n#define {rest}\n") == ["2:1 SC108"]


@pytest.mark.parametrize("rest", ["GL_core_profile", "__LINE__", "A B"])
def test_undefinitions_that_are_wrong(rest: str) -> None:
    assert errors(f"#version 330\n#undef {rest}\n") == ["2:1 SC108"]


def test_two_underscores_are_reserved_in_es_100() -> None:
    assert words("#define a__b 1\na__b", "300 es") == "1"
    assert errors("#version 100\n#define a__b 1\n") == ["2:1 SC108"]


# --- arguments ------------------------------------------------------------------------------------

F = "#define F(x) [x]\n#define G(x, y) [x|y]\n#define N() [n]\n"


@pytest.mark.parametrize(
    ("use", "expected"),
    [
        ("F(1) F (2) F\n(3)", "[ 1 ] [ 2 ] [ 3 ]"),
        ("F", "F"),
        ("F F(1)", "F [ 1 ]"),
        ("F((1, 2)) F([1])", "[ ( 1 , 2 ) ] [ [ 1 ] ]"),
        ("F() G(,) G(1,)", "[ ] [ | ] [ 1 | ]"),
        ("N() N ( )", "[ n ] [ n ]"),
        ("F(F(1)) G(F(1), G(2, 3))", "[ [ 1 ] ] [ [ 1 ] | [ 2 | 3 ] ]"),
        ("F(F)(1)", "[ F ] ( 1 )"),
        ("F(/* 1 */ 2 // 3\n)", "[ 2 ]"),
    ],
)
def test_arguments(use: str, expected: str) -> None:
    assert words(F + use) == expected


@pytest.mark.parametrize(
    ("use", "message"),
    [
        ("G(1)", "macro 'G' has 2 parameters, but 1 are given"),
        ("F(1, 2)", "macro 'F' has 1 parameter, but 2 are given"),
        ("N(1)", "macro 'N' has 0 parameters, but 1 are given"),
        ("G(1, (2)", "the '(' of macro 'G' is never closed"),
        ("F(\n#define X\n1)", "the '(' of macro 'F' is never closed"),
        ("F(F()\n#if 0\n#endif\n", "the '(' of macro 'F' is never closed"),
    ],
)
def test_wrong_arguments(use: str, message: str) -> None:
    assert problem(F + use) == f"5:1 SC124 {message}"


def test_reading_goes_on_behind_a_wrong_call() -> None:
    assert errors(f"#version 330\n{F}F(1, 2) x N(1)\nG(1)") == [
        "5:1 SC124",
        "5:11 SC124",
        "6:1 SC124",
    ]


# --- rescanning -----------------------------------------------------------------------------------


def test_a_macro_never_expands_in_itself() -> None:
    assert words("#define A A + B\n#define B A\nA | B") == "A + A | A + B"
    assert words("#define f(x) x f\nf(1)(2)") == "1 f ( 2 )"
    assert words("#define f(a) a*g\n#define g(a) f(a)\nf(2)(9)") == "2 * 9 * g"


def test_a_name_without_arguments_may_find_them_behind_the_macro() -> None:
    assert words("#define F(x) [x]\n#define G F\n#define H F(\nG(1) H 2)") == "[ 1 ] [ 2 ]"
    assert words("#define F(x) [x]\n#define LP (\nF LP 1)") == "F ( 1 )"


def test_the_example_of_the_c_standard() -> None:
    text = """
#define x 3
#define f(a) f(x * (a))
#undef x
#define x 2
#define g f
#define z z[0]
#define h g(~
#define m(a) a(w)
#define w 0,1
#define t(a) a
f(y+1) + f(f(z)) % t(t(g)(0) + t)(1);
g(x+(3,4)-w) | h 5) & m(f)^m(m);
"""
    assert words(text).replace(" ", "") == (
        "f(2*(y+1))+f(2*(f(2*(z[0]))))%f(2*(0))+t(1);"
        "f(2*(2+(3,4)-0,1))|f(2*(~5))&f(2*(0,1))^m(0,1);"
    )


def test_an_argument_that_is_not_used_is_not_expanded() -> None:
    assert words("#define F(x) 1\n#define G(x, y) x\nF(G(2))") == "1"


# --- ## -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ("x, y", "xy"),
        ("a, 1", "a1"),
        ("1, u", "1u"),
        ("+, +", "++"),
        ("<, <=", "<<="),
        ("a.b, c", "a . bc"),
        ("q,", "q"),
        (", q", "q"),
        (",", ""),
        ("A, B", "AB"),
    ],
)
def test_pasting(arguments: str, expected: str) -> None:
    assert words(f"#define A 1\n#define P(x, y) x##y\nP({arguments})") == expected


def test_pasting_takes_arguments_as_they_are_written() -> None:
    text = "#define P(a) pre_##a##_post\n#define M z\n#define W(a) P(a)\nP(M) W(M)"
    assert words(text) == "pre_M_post pre_z_post"
    assert words("#define P(a) a a##1\n#define M z\nP(M)") == "z M1"


def test_what_is_pasted_is_expanded() -> None:
    assert words("#define AB 7\n#define P(x, y) x ## y\n#define Q A ## B\nP(A, B) Q") == "7 7"


def test_what_does_not_make_one_word_cannot_be_pasted() -> None:
    text = "#define P(x, y) x##y\nP(-, 1)"
    assert problem(text) == "3:1 SC124 '##' makes '-1', which is not one word"


# --- predefined macros ----------------------------------------------------------------------------


def test_predefined_macros() -> None:
    assert words("\n__LINE__ __FILE__ __VERSION__ GL_core_profile") == "3 0 330 1"
    assert words("#define HERE __LINE__\n\nHERE\nHERE") == "4 5"


# --- bombs ----------------------------------------------------------------------------------------

DOUBLING = "".join(f"#define A{n + 1} A{n} A{n}\n" for n in range(60))


@pytest.mark.parametrize(
    "text",
    [
        f"#define A0 x\n{DOUBLING}A60\n",
        f"#define A0\n{DOUBLING}A60\n",
        f"{DOUBLING}A60\n",
        f"{DOUBLING}#if A60\n#endif\n",
        "#define D(x) x x\n" + "D(" * 50 + "y" + ")" * 50,
        "#define D(x) x x\n" + "D(" * 10_000 + "y" + ")" * 10_000,
        "#define P(x) x##x x##x\n" + "P(" * 50 + "y" + ")" * 50,
        "#define A " + "x " * 1000 + "\n" + "A\n" * 100_000,
    ],
    ids=lambda text: text[:16],
)
@pytest.mark.slow
def test_macros_cannot_ask_for_billions_of_words(text: str) -> None:
    (found,) = errors("#version 330\n" + text)
    assert found.split()[1] in ("SC109", "SC124")


def test_a_short_text_has_its_bomb_told_at_once() -> None:
    (error,) = rejected(f"#version 330\n#define A0 x\n{DOUBLING}A60\n")
    assert re.fullmatch(r"macros expand to more than 2\d{5} tokens", error.message)
    assert error.hint == "--max-tokens gives another limit"


@pytest.mark.parametrize(("length", "limit"), [(0, 99_000), (1_000, 99_000), (1_000, 9_000)])
def test_the_longer_the_text_the_more_its_macros_may_make(length: int, limit: int) -> None:
    # A tenth of the limit, and 20 for each character, but never more than the limit.
    text = f"#version 330\n// {'x' * length}\n#define A {'x ' * 200}\n"
    text += "A\n" * 300
    allowed = min(limit, limit // 10 + 20 * len(text))
    (error,) = rejected(text, ReadOptions(max_tokens=limit))
    assert error.message == f"macros expand to more than {allowed} tokens"


def test_a_pasted_word_cannot_grow_for_ever() -> None:
    doubling = "".join(f"#define D{n + 1}(x) D{n}(x##x)\n" for n in range(40))
    text = f"#define D0(x) x\n{doubling}D40(a)\n"
    assert "more than 1024 characters" in problem(text)


@pytest.mark.parametrize(
    "text",
    [
        "#define A B\n#define B A\n" + "A " * 100_000,
        "".join(f"#define A{n} A{n + 1}\n" for n in range(20_000)) + "A0",
        "#define F(x) x\n" + "".join(f"#define A{n} F(1) A{n + 1}\n" for n in range(10_000)) + "A0",
        "".join(f"#define A{n}(x) A{n + 1}(x)\n" for n in range(10_000)) + "A0(1)",
    ],
    ids=lambda text: text[:16],
)
@pytest.mark.slow
def test_long_chains_of_macros_are_taken(text: str) -> None:
    assert words(text)


def test_many_calls_that_are_never_closed_take_no_time() -> None:
    assert errors("#version 330\n#define F(x) x\n" + "F( " * 100_000) == ["3:1 SC124"]

"""The preprocessor: versions, directives, macros, comments and line continuations."""

from __future__ import annotations

import time

import pytest

from shadercache.diagnostics import InputError
from shadercache.front.preprocess import Preprocessed, preprocess
from shadercache.source import Source


def run(text: str) -> Preprocessed:
    return preprocess(Source("test.frag", text))


def words(body: str) -> list[str]:
    """The lexemes of what stands below ``#version 330``."""
    return run(f"#version 330\n{body}").lexemes.texts


def errors(text: str) -> list[str]:
    """``line:column code`` of each error."""
    with pytest.raises(InputError) as caught:
        run(text)
    found = []
    for item in caught.value.diagnostics:
        assert item.source is not None
        assert item.span is not None
        line, column = item.source.position(item.span.start)
        found.append(f"{line}:{column} {item.code}")
    return found


# --- #version -------------------------------------------------------------------------------------


@pytest.mark.parametrize("version", [330, 400, 410, 420, 430, 440, 450, 460])
@pytest.mark.parametrize("profile", [None, "core", "compatibility"])
def test_versions(version: int, profile: str | None) -> None:
    result = run(f"// first\n\n  #  version {version} {profile or ''} // last\nfloat a;")
    assert (result.version, result.profile) == (version, profile)


@pytest.mark.parametrize(
    "line",
    [
        "#version 110",
        "#version 300 es",
        "#version 330 es",
        "#version 331",
        "#version",
        "#version x",
    ],
)
def test_other_versions_are_refused(line: str) -> None:
    assert errors(f"\n{line}\n") == ["2:1 SC100"]


def test_a_missing_version_means_110() -> None:
    assert errors("// nothing\n  out vec4 o;\n") == ["2:3 SC100"]
    with pytest.raises(InputError, match=r"GLSL 1\.10.*330 or 400 to 460"):
        run("float a;")
    assert errors("") == ["1:1 SC100"]


def test_version_comes_first_and_once() -> None:
    assert errors("float a;\n#version 330\n") == ["2:1 SC100"]
    assert errors("#version 330\n#version 330\n") == ["2:1 SC100"]
    assert errors("#define A\n#version 330\n") == ["2:1 SC100"]


# --- kept directives ------------------------------------------------------------------------------


def test_extensions_and_pragmas_are_kept_in_order() -> None:
    result = run(
        "#version 330\n#pragma  optimize(on)\n#extension GL_X : \\\n enable // why\n#\n"
        "float a;\n  #pragma debug(off)\n"
    )
    assert [directive.text for directive in result.directives] == [
        "#pragma optimize(on)",
        "#extension GL_X : enable",
        "#pragma debug(off)",
    ]
    assert result.lexemes.texts == ["float", "a", ";"]


@pytest.mark.parametrize(
    "line",
    [
        *("#if 1", "#ifdef A", "#ifndef A", "#elif 1", "#else", "#endif"),
        *("#line 3", '#include "a"', "#define F(x) x"),
    ],
)
def test_what_the_next_release_brings_is_refused(line: str) -> None:
    with pytest.raises(InputError, match="not supported yet"):
        run(f"#version 330\n{line}\n")
    assert errors(f"#version 330\n  {line}\n") == ["2:3 SC107"]


def test_a_conditional_is_one_error() -> None:
    assert errors("#version 330\n#if 1\n#else\n#endif\n#ifdef A\n#endif\n") == [
        "2:1 SC107",
        "5:1 SC107",
    ]


@pytest.mark.parametrize(
    "line",
    ["#foo", "#define", "#define 1", "#undef", "#undef 1", "#error no", "#1", "#define GL_X"],
)
def test_malformed_directives(line: str) -> None:
    assert errors(f"#version 330\n{line}\n") == ["2:1 SC108"]


def test_all_errors_are_told_in_order() -> None:
    assert errors("#foo\n#bar\n/*") == ["1:1 SC108", "1:1 SC100", "2:1 SC108", "3:1 SC104"]


# --- macros ---------------------------------------------------------------------------------------


def test_a_macro_is_replaced_from_its_line_on() -> None:
    assert words("A\n#define A 1 + 2\nA\n#undef A\nA") == ["A", "1", "+", "2", "A"]


def test_macros_in_macros_are_those_of_the_place_of_use() -> None:
    assert words("#define A B\n#define B 1\nA\n#undef B\n#define B 2\nA") == ["1", "2"]


def test_a_macro_may_be_empty() -> None:
    assert words("#define highp\nhighp float a;") == ["float", "a", ";"]


def test_a_macro_never_expands_in_itself() -> None:
    assert words("#define A A + B\n#define B A\nA") == ["A", "+", "A"]


def test_a_keyword_may_be_a_macro() -> None:
    assert words("#define float vec4\nfloat a;") == ["vec4", "a", ";"]


def test_the_same_definition_twice_is_allowed_and_another_is_not() -> None:
    assert words("#define A 1+1\n#define A 1 + 1\nA") == ["1", "+", "1"]
    assert errors("#version 330\n#define A 1\n#define A 2\n") == ["3:1 SC108"]


def test_a_body_may_begin_with_a_bracket_after_a_blank() -> None:
    assert words("#define A (1)\nA") == ["(", "1", ")"]


def test_a_body_keeps_the_spelling_of_numbers() -> None:
    assert words("#define SIZE .03\nSIZE") == [".03"]


def test_predefined_macros() -> None:
    assert words("\n__LINE__ __FILE__ __VERSION__ GL_core_profile") == ["3", "0", "330", "1"]
    compatibility = run("#version 330 compatibility\nGL_core_profile")
    assert compatibility.lexemes.texts == ["GL_core_profile"]


def test_all_of_a_macro_has_the_place_of_its_use() -> None:
    result = run("#version 330\n#define TAU (2.0 * PI)\n#define PI 3.14\nx = TAU;")
    places = dict(zip(result.lexemes.texts, result.lexemes.starts, strict=True))
    assert places["x"] < places["3.14"] == places["("] == places[")"] < places[";"]


def test_macros_cannot_ask_for_billions_of_words() -> None:
    doubling = "".join(f"#define A{n + 1} A{n} A{n}\n" for n in range(60))
    assert errors(f"#version 330\n{doubling}A60\n") == ["62:1 SC109"]
    empty = "#define A0\n" + doubling
    assert errors(f"#version 330\n{empty}A60\n") == ["63:1 SC109"]


# --- comments, lines, characters ------------------------------------------------------------------


def test_comments_are_blanks() -> None:
    assert words("a/**/b//c\nd/*\n*/e/***/f/*/*/g // \u00e4\u2264\U0001f600") == [*"abdefg"]


def test_offsets_are_those_of_the_file() -> None:
    text = "#version 330\r\n/* \u00e4 */ a \\\r\n b\rc"
    lexemes = run(text).lexemes
    places = zip(lexemes.starts, lexemes.ends, strict=True)
    assert [text[start:end] for start, end in places] == ["a", "b", "c"]


def test_a_comment_that_is_never_closed() -> None:
    assert errors("#version 330\n a /* b\n") == ["2:4 SC104"]


def test_long_blanks_and_open_comments_take_no_time() -> None:
    begin = time.perf_counter()
    assert words("a" + " " * 500_000 + "b" + " \n" * 250_000) == ["a", "b"]
    assert words("/*" + "*" * 500_000 + "/" + "//" * 250_000) == []
    assert errors("#version 330\n" + "/* " * 250_000) == ["2:1 SC104"]
    assert words("#define A 1" + " " * 500_000 + "\nA") == ["1"]
    assert time.perf_counter() - begin < 2.0


def test_a_byte_order_mark_is_no_part_of_the_shader() -> None:
    assert run("\ufeff#version 330\na").lexemes.starts == [14]


def test_a_line_continuation_joins_lines() -> None:
    assert words("#define A 1 \\\n + 2\nA \\\n A") == ["1", "+", "2", "1", "+", "2"]


def test_a_line_continuation_in_a_word_is_refused() -> None:
    assert errors("#version 330\nfl\\\noat a;") == ["2:3 SC107"]
    assert errors("#version 330\na +\\\n+ b;") == ["2:4 SC107"]


def test_a_comment_that_ends_in_a_backslash_must_not_hide_code() -> None:
    assert errors("#version 330\n// a \\\nfloat b;") == ["2:6 SC104"]
    assert words("// a \\\n// b \\\n\nc") == ["c"]


def test_a_carriage_return_ends_a_line() -> None:
    assert words("a // b\rc\r\nd") == ["a", "c", "d"]


def test_characters_that_are_not_ascii_stand_in_comments_only() -> None:
    assert errors("#version 330\n#pragma \u00e4\n") == ["2:1 SC101"]


def test_nul_is_refused_everywhere() -> None:
    assert errors("#version 330\n// a\0b\n") == ["2:5 SC101"]

"""The preprocessor: kept directives, comments and lines, places, options, limits."""

from __future__ import annotations

import pytest
from preprocessing import errors, problem, rejected, run, words

from shadercache.front.parse import parse
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

# --- kept directives ------------------------------------------------------------------------------


def test_extensions_and_pragmas_are_kept_in_order() -> None:
    result = run(
        "#version 330\n#pragma  optimize(on)\n#extension GL_X:\\\n enable // why\n#\n"
        "float a;\n  #pragma debug(off)\n#extension all : warn"
    )
    assert [directive.text for directive in result.directives] == [
        "#pragma optimize(on)",
        "#extension GL_X : enable",
        "#pragma debug(off)",
        "#extension all : warn",
    ]
    assert result.lexemes.texts == ["float", "a", ";"]


def test_kept_directives_are_those_of_the_groups_that_are_read() -> None:
    result = run("#version 330\n#ifdef GL_ES\n#pragma a\n#else\n#pragma b\n#endif\n")
    assert [directive.text for directive in result.directives] == ["#pragma b"]


def test_extensions_for_the_preprocessor_are_not_kept() -> None:
    result = run("#version 330\n#extension GL_GOOGLE_include_directive : require\n")
    assert result.directives == ()


@pytest.mark.parametrize(
    "rest",
    [
        *("", ": enable", "GL_X", "GL_X enable", "GL_X :", "GL_X : enable x", '"x" : enable'),
        *("GL_X : on", "all : enable", "all : require"),
        "GL_X : require",
    ],
)
def test_section_3_3_extension_lines_that_are_wrong(rest: str) -> None:
    assert errors(f"#version 330\n#extension {rest}\n") == ["2:1 SC108"]


def test_extensions_that_compilers_know_may_be_required_and_are_macros() -> None:
    required = "#extension GL_ARB_gpu_shader5 : require\nGL_ARB_gpu_shader5"
    assert words(required) == "1"
    assert words("GL_OES_standard_derivatives", "100") == "1"
    assert words("GL_OES_standard_derivatives") == "GL_OES_standard_derivatives"
    assert words("GL_OVR_multiview", "300 es") == "1"
    assert words("GL_OVR_multiview", "100") == "GL_OVR_multiview"


@pytest.mark.parametrize(
    "line",
    ["#foo", "#define", "#define 1", "#undef", "#undef 1", "#error no", "#1", "#define GL_X"],
)
def test_malformed_directives(line: str) -> None:
    assert errors(f"#version 330\n{line}\n") == ["2:1 SC108"]


def test_the_words_of_an_error_directive_are_told() -> None:
    assert problem("#error say don't, \u00e4\n") == "2:1 SC108 #error say don't, \u00e4"


def test_all_errors_are_told_in_order() -> None:
    text = "#foo\n#bar\n#if\n#endif\n#endif\n/*"
    assert errors(text) == ["1:1 SC108", "2:1 SC108", "3:1 SC122", "5:1 SC121", "6:1 SC104"]


def test_a_hundred_errors_are_enough() -> None:
    assert len(rejected("#foo\n" * 1000)) == 100


# --- comments, lines, characters ------------------------------------------------------------------


def test_section_3_4_comments_are_blanks() -> None:
    text = "a/**/b//c\nd/*\n*/e/***/f/*/*/g // \u00e4\u2264\U0001f600"
    assert words(text) == "a b d e f g"


def test_section_3_4_a_comment_of_several_lines_does_not_end_a_directive() -> None:
    assert words("#define A /* x\n y */ 1\nA") == "1"
    assert words("/* x\n*/ #define A 1\n# /**/ define B 2\nA B") == "1 2"


def test_offsets_are_those_of_the_file() -> None:
    text = "#version 330\r\n/* \u00e4 */ a \\\r\n b\rc"
    lexemes = run(text).lexemes
    places = zip(lexemes.starts, lexemes.ends, strict=True)
    assert [text[start:end] for start, end in places] == ["a", "b", "c"]


def test_a_comment_that_is_never_closed() -> None:
    assert errors("#version 330\n a /* b\n") == ["2:4 SC104"]
    assert errors("#version 330\n#if 0\n a /* b\n#endif\n") == ["2:1 SC121", "3:4 SC104"]


def test_long_blanks_and_open_comments_take_no_time() -> None:
    assert words("a" + " " * 500_000 + "b" + " \n" * 250_000) == "a b"
    assert words("/*" + "*" * 500_000 + "/" + "//" * 250_000) == ""
    assert errors("#version 330\n" + "/* " * 250_000) == ["2:1 SC104"]
    assert words("#define A 1" + " " * 500_000 + "\nA") == "1"


def test_a_byte_order_mark_is_no_part_of_the_shader() -> None:
    assert run("\ufeff#version 330\na").lexemes.starts == [14]


def test_a_line_continuation_joins_lines() -> None:
    assert words("#define A 1 \\\n + 2\nA \\\n A\\\r\n\\\n") == "1 + 2 1 + 2"
    assert words("#de\\\nfine A 1\nA") == "1"


def test_a_line_continuation_may_stand_in_a_word_or_operator() -> None:
    text = "#version 330\nfl\\\noat a; a +\\\r\n+; b\\\n\\\nc de\\\n"
    lexemes = run(text).lexemes
    assert lexemes.texts == ["float", "a", ";", "a", "++", ";", "bc", "de"]
    places = zip(lexemes.starts, lexemes.ends, strict=True)
    raw = ["fl\\\noat", "a", ";", "a", "+\\\r\n+", ";", "b\\\n\\\nc", "de"]
    assert [text[start:end] for start, end in places] == raw


@pytest.mark.parametrize("version", ["420", "460", "300 es"])
def test_section_3_1_lines_are_joined_before_comments_are_found(version: str) -> None:
    assert words("// a \\\nfloat b;\nc /\\\n/ d\n/\\\n* e */", version) == "c"
    text = f"#version {version}\n/\\\n* \\\n b"
    assert errors(text) == ["2:1 SC104"]


def test_a_comment_that_ends_in_a_backslash_must_not_hide_code_in_earlier_versions() -> None:
    assert errors("#version 330\n// a \\\nfloat b;") == ["2:6 SC104"]
    assert errors("#version 100\n// a \\\r\nfloat b;") == ["2:6 SC104"]
    assert words("// a \\\n// b \\\n\nc") == "c"


def test_blanks_behind_a_backslash_are_told() -> None:
    assert problem("#define A 1 \\ \n + 2\n") == "2:1 SC104 this '\\' continues no line"


def test_a_carriage_return_ends_a_line() -> None:
    result = run("#version 330\ra // b\rc\r\nd __LINE__")
    assert result.lexemes.texts == ["a", "c", "d", "4"]


def test_characters_that_are_not_ascii_stand_in_comments_and_skipped_groups() -> None:
    assert errors("#version 330\n#line \u00e4\n") == ["2:1 SC101"]
    # Emulators show the user what their pragmas say.
    assert words('#pragma parameter P "\u21b3 tint" 1.0\nb') == "b"
    assert words("#if 0\n\u00e4 @ ` don't\n#foo \u00e4\n#endif\nb") == "b"


def test_nul_is_refused_everywhere() -> None:
    assert errors("#version 330\n// a\0b\n") == ["2:5 SC101"]


# --- #line ----------------------------------------------------------------------------------------


def test_section_3_3_line_changes_what_the_next_lines_say() -> None:
    assert words("__LINE__\n#line 10 3\n__LINE__ __FILE__\n__LINE__") == "2 10 3 11"
    assert words("#line 10\n__LINE__ __FILE__", "300 es") == "10 0"


def test_section_3_3_before_330_line_gives_its_number_to_itself() -> None:
    assert words("#line 10\n__LINE__", "150") == "11"


def test_section_3_3_line_takes_expressions() -> None:
    assert words("#define L 7\n#line L + (1)\n__LINE__ __FILE__") == "8 0"
    assert words("#define L 7\n#line (L) 2\n__LINE__ __FILE__") == "7 2"
    assert words("#line 5 - 3\n__LINE__ __FILE__") == "2 0"


def test_diagnostics_know_nothing_of_line() -> None:
    assert errors("#version 330\n#line 100\n#foo\n") == ["3:1 SC108"]


@pytest.mark.parametrize("rest", ["", "x y", "1.0", "1 2 3", '1 "a.frag"', "99999999999"])
def test_line_directives_that_are_wrong(rest: str) -> None:
    assert len(errors(f"#version 330\n#line {rest}\n")) == 1


def test_a_file_name_in_a_line_directive_needs_an_extension() -> None:
    on = "#extension GL_GOOGLE_cpp_style_line_directive : enable"
    assert words(f'{on}\n#line 9 "a"\n__LINE__') == "9"
    assert words(f'{on}\n#extension all : warn\n#line 9 "a"\n__LINE__') == "9"
    for disabled in ("", f"{on}\n#extension all : disable"):
        assert errors(f'#version 330\n{disabled}\n#line 9 "a"\n')[0].endswith("SC108")


# --- places ---------------------------------------------------------------------------------------


def test_all_of_a_macro_has_the_place_of_its_use() -> None:
    text = "#version 330\n#define TAU(n) (2.0 * PI * n)\n#define PI 3.14\nx = TAU ( a\n) ;"
    lexemes = run(text).lexemes
    found = zip(lexemes.texts, lexemes.starts, lexemes.ends, strict=True)
    places = {word: text[start:end] for word, start, end in found}
    assert places["x"] == "x"
    assert places[";"] == ";"
    assert {places[word] for word in ("3.14", "(", "a", "2.0")} == {"TAU ( a\n)"}


def test_a_use_takes_the_arguments_that_its_last_word_finds() -> None:
    text = "#version 330\n#define F(x) x\n#define G F\nG (a) b"
    lexemes = run(text).lexemes
    assert [text[s:e] for s, e in zip(lexemes.starts, lexemes.ends, strict=True)] == ["G (a)", "b"]


# --- options --------------------------------------------------------------------------------------


def test_options_define_macros() -> None:
    defines = (("A", "1"), ("F(x)", "x + x"), ("EMPTY", ""))
    assert words("A F(2) EMPTY", options=ReadOptions(defines=defines)) == "1 2 + 2"
    assert words("#if A == 1\nb\n#endif", options=ReadOptions(defines=defines)) == "b"


def test_options_undefine_what_is_predefined() -> None:
    options = ReadOptions(undefined=("GL_ARB_gpu_shader5", "NONE"))
    assert words("#ifdef GL_ARB_gpu_shader5\na\n#endif\nb", options=options) == "b"


def test_options_that_define_no_macro_are_told() -> None:
    (item,) = rejected("#version 330\n", ReadOptions(defines=(("1x", "1"),)))
    assert (item.code, item.span) == ("SC108", None)
    assert "'1x'" in item.message


def test_the_parser_takes_the_options() -> None:
    source = Source("test", "#version 330\nfloat NAME;\n")
    module = parse(source, ReadOptions(defines=(("NAME", "a, b"),)))
    assert len(module.decls[0].declarators) == 2  # type: ignore[union-attr]


# --- limits ---------------------------------------------------------------------------------------


def test_the_number_of_tokens_is_limited() -> None:
    options = ReadOptions(max_tokens=10)
    assert words("a " * 10, options=options) == " ".join("a" * 10)
    (item,) = rejected("#version 330\n#if 1\na a a a a a\n#endif\na a a a b", options)
    assert item.code == "SC120"
    assert item.source is not None
    assert item.span is not None
    assert item.source.excerpt(item.span) == "b"
    assert "10 tokens" in item.message


def test_a_file_far_beyond_the_limit_is_not_read_to_its_end() -> None:
    assert errors("a " * 5_000_000, ReadOptions(max_tokens=1000)) == ["1:2001 SC120"]


@pytest.mark.parametrize(
    "line", ["vec3 a = b + c * 2.0;\n", "#ifdef b\nvec3 a = b;\n#endif\n", "vec3 a = SQ(c + d);\n"]
)
@pytest.mark.slow
def test_a_long_file_takes_a_few_seconds_at_the_most(line: str) -> None:
    head = "#define b (q + 1)\n#define SQ(x) ((x)*(x))\n"
    assert words(head + line * (1_000_000 // len(line)))


# --- sources --------------------------------------------------------------------------------------


def test_a_snippet_of_a_very_long_line_is_short() -> None:
    (item,) = rejected("#version 330\n#error " + "x" * 100_000 + "\n")
    snippet = item.render().split("\n", 1)[1]
    assert len(snippet) < 1000

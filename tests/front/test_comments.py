"""Comments: which are found, what they belong to, and that printing keeps them in their places."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.ast.nodes import FunctionDef, Module, Stmt
from shadercache.ast.rewriter import Rewriter
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source


def read(text: str) -> Module:
    return parse(Source("test", "#version 330\n" + text))


def printed(text: str) -> str:
    """A shader printed, without its version; printing it again changes nothing."""
    first = print_module(read(text))
    assert print_module(parse(Source("printed", first))) == first
    return first.removeprefix("#version 330\n").strip("\n")


def in_function(text: str) -> str:
    lines = printed(f"void f() {{\n{text}\n}}").split("\n")
    return "\n".join(line.removeprefix("    ") for line in lines[1:-1])


# --- what is printed ------------------------------------------------------------------------------

KEPT = [
    "// before\nfloat a;",
    "float a; // behind",
    "float a; /* behind */ // and more",
    "// one\n// two\nfloat a; // three\nfloat b;\n\n// four\nfloat c;\nfloat d;",
    "/* over\n   lines */\nfloat a;",
    "// before\nvoid f() {\n    a;\n} // behind",
    "float a;\n\n// at the end",
    "// alone",
    "struct S {\n    // first\n    float a; // its end\n    float b;\n    // last\n} s; // behind",
    "uniform B {\n    vec4 a; // inside\n    // last\n} b; // behind",
    "// the file\n\nfloat a;",
    "// the file\n\n// the variable\nfloat a;",
    "// g\u00fcltig \u2264 \U0001f600\nfloat a;",
]
KEPT_IN_FUNCTIONS = [
    "// before\na;",
    "a; // behind",
    "// empty",
    "a;\n// last",
    "return; // behind",
    "float a; // behind",
    "{\n    // inside\n}",
    "if (a) {\n    // first\n    b;\n    // last\n} // behind",
    "if (a)\n    b; // inside\nelse\n    c; // inside",
    "if (a) {\n    b;\n} else {\n    // why\n    c;\n}",
    "if (a) {\n    b;\n} else if (c) {\n    // why\n    d;\n}",
    "for (;;)\n    // why\n    a;",
    "while (a) {\n    b; // inside\n} // behind",
    "do {\n    a;\n    // last\n} while (b); // behind",
    "switch (a) {\n    // first\n    case 0: // zero\n        b; // inside\n    default:\n"
    "        // why\n        c;\n        // last\n} // behind",
]


@pytest.mark.parametrize("text", KEPT)
def test_a_comment_stays_in_its_place(text: str) -> None:
    assert printed(text) == text


@pytest.mark.parametrize("text", KEPT_IN_FUNCTIONS)
def test_a_comment_in_a_function_stays_in_its_place(text: str) -> None:
    assert in_function(text) == text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("/* x */ a;", "/* x */\na;"),
        ("a = /* x */ b; // y", "/* x */\na = b; // y"),
        ("f(a, // x\n  b); // y", "// x\nf(a, b); // y"),
        ("if (a) // x\n    b;", "if (a)\n    // x\n    b;"),
        ("if (a /* x */) { // y\n    b; }", "if (a) {\n    /* x */\n    // y\n    b;\n}"),
        ("if (a) { b; } // x\nelse { c; }", "if (a) {\n    b;\n} else {\n    // x\n    c;\n}"),
        ("if (a) b;\n// x\nelse if (c) d;", "if (a)\n    b;\nelse if (c)\n    // x\n    d;"),
        ("for (a; /* x */ b; c) { }", "for (a; b; c) {\n    /* x */\n}"),
    ],
)
def test_a_comment_inside_a_statement_goes_before_it_or_into_its_body(
    text: str, expected: str
) -> None:
    assert in_function(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("float f(float a, // x\n float b) { }", "float f(float a, float b) {\n    // x\n}"),
        ("float f() // x\n{\n}", "float f() {\n    // x\n}"),
        ("float f(float a /* x */);", "/* x */\nfloat f(float a);"),
        ("struct S // x\n{ float a; };", "struct S {\n    // x\n    float a;\n};"),
        ("float a[2] = float[](1., // x\n 2.); // y", "// x\nfloat a[2] = float[](1., 2.); // y"),
    ],
)
def test_a_comment_inside_a_declaration(text: str, expected: str) -> None:
    assert printed(text) == expected


def test_comments_at_the_beginning_stand_behind_the_directives() -> None:
    text = "// licence\n#extension all : warn\n\n/* the file */\n\n// the variable\nfloat a;"
    assert printed(text) == (
        "#extension all : warn\n\n// licence\n/* the file */\n\n// the variable\nfloat a;"
    )


def test_a_comment_in_a_directive_is_no_comment_of_the_code() -> None:
    assert printed("#define A 1 // one\n#define B \\\n 2 // two\nfloat a = A;") == "float a = 1;"


def test_a_backslash_at_the_end_cannot_swallow_the_next_line() -> None:
    assert printed("float a; // x \\\n\nfloat b;") == "float a; // x\nfloat b;"
    assert printed("// /\\_\\ \\ \\\n\nfloat a;") == "// /\\_\n\nfloat a;"


def test_line_ends_become_newlines() -> None:
    assert printed("/* x\r\n   y */\r\nfloat a; // z\r\n") == "/* x\n   y */\nfloat a; // z"


def test_spans_are_places_in_the_file() -> None:
    source = Source("test", "#version 330\r\nfloat a; // b\r\n/* c */ float d;")
    found = [source.text[start:end] for start, end in (c.span for c in parse(source).comments)]
    assert found == ["// b", "/* c */"]


# --- what rewriting does --------------------------------------------------------------------------

REWRITTEN = """\
void f() {
    // gone
    a; // gone
    // stays
    b; // stays
}"""


class Without(Rewriter):
    """Drops the first statement."""

    def statement(self, node: Stmt, original: Stmt) -> Stmt | tuple[()]:
        text = REWRITTEN[node.span.start - 13 : node.span.end - 13]
        return () if text == "a;" else node


def test_a_comment_goes_with_what_it_is_about() -> None:
    module = Without().rewrite(read(REWRITTEN))
    lines = [line.strip() for line in print_module(module).split("\n")]
    assert lines == ["#version 330", "", "void f() {", "// stays", "b; // stays", "}", ""]


def test_a_clone_does_not_repeat_the_comments() -> None:
    class Twice(Rewriter):
        def declaration(self, node: object, original: object) -> tuple[FunctionDef, ...]:
            assert isinstance(node, FunctionDef)
            return (node, node)

    text = print_module(Twice().rewrite(read(REWRITTEN)))
    assert text.count("void f()") == 2
    assert text.count("// stays") == 2


def test_shaders_with_every_construct() -> None:
    for path in (Path(__file__).parent / "shaders").iterdir():
        module = parse(Source(path.name, path.read_text()))
        text = print_module(module)
        assert module.comments or path.name == "precise.frag"
        assert all(comment.text in text for comment in module.comments if "define" not in text)


# --- what the preprocessor leaves out or brings in ------------------------------------------------


def test_comments_of_a_group_that_does_not_hold_are_left_out() -> None:
    text = """\
#define ONE
#ifdef ONE
// one
float a;
#else
// two
float b;
#endif
#if 0
// three
#else
float c; // four
#endif
// five
#define TWO
// six
"""
    assert printed(text) == "// one\nfloat a;\nfloat c; // four\n\n// five\n// six"


def test_comments_around_conditions_stay_with_the_code() -> None:
    text = "// one\n#if 1\nfloat a;\n#endif\n// two\nfloat b;"
    assert printed(text) == "// one\n\nfloat a;\n\n// two\nfloat b;"


def test_a_comment_at_the_use_of_a_macro_stays() -> None:
    text = "#define F(x, y) float x = y;\nF(a, /* one */ 2.0) // two\nfloat b;"
    assert printed(text) == "/* one */\nfloat a = 2.0; // two\nfloat b;"


def test_comments_of_included_files_are_left_out(tmp_path: Path) -> None:
    (tmp_path / "part.glsl").write_text("// in the part\nfloat part; // its end\n")
    text = '#version 330\n// before\n#include "part.glsl"\n// behind\nfloat a; // end\n'
    options = ReadOptions(include_folders=(tmp_path,))
    module = parse(Source("test", text), options)
    assert [comment.text for comment in module.comments] == ["// before", "// behind", "// end"]
    lines = print_module(module).split("\n")
    assert lines[-5:] == ["float part;", "", "// behind", "float a; // end", ""]

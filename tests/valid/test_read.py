"""Mistakes in front of the one that keeps a file from being parsed are told with it."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import InputError, Severity
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.valid.read import read

HEAD = "#version 330\nout vec4 o;\n"


def told(text: str, options: ReadOptions | None = None) -> list[tuple[str, int]]:
    """Code and line of each error of a text."""
    source = Source("test.frag", text)
    try:
        read(source, "fragment", options or ReadOptions())
    except InputError as error:
        return [
            (item.code, source.position(item.span.start).line if item.span else 0)
            for item in error.diagnostics
            if item.severity is Severity.ERROR
        ]
    return []


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("float f() { return a; }\nfloat g() { return 1 + ; }", [("SC201", 3), ("SC103", 4)]),
        ("void main() { o = b;\nif (true) { o = 1 + ; } }", [("SC201", 3), ("SC103", 4)]),
        (
            "void main() { o = b;\nif (true) { o = c;\no = 1 + ; } }",
            [("SC201", n) for n in (3, 4)] + [("SC103", 5)],
        ),
        ("void main() { o = b; }\n#nothing\n", [("SC201", 3), ("SC108", 4)]),
        # A mistake of syntax in front of one of the preprocessor, and a name in front of both.
        (
            "float f() { return a; }\nfloat g() { return 1 + ; }\n#nothing\n",
            [("SC201", 3), ("SC103", 4), ("SC108", 5)],
        ),
    ],
    ids=str,
)
def test_in_front(body: str, expected: list[tuple[str, int]]) -> None:
    assert told(HEAD + body) == expected


@pytest.mark.parametrize(
    "body",
    [
        "float f() {\nif (true) { return 1.0; }\nelse { return 1 + ; } }",  # no 'missing return'
        "int a[];\nvoid main() { o = 1 + ; }\nint a[3];",  # the size may come later
        "struct S { float a; \n float +; } s;",
        "void main() { float a[2] = float[2](1.0, \n +; }",
        "void main() { do { o = vec4(1.0); \n o = 1 + ; } while (b); }",
        "void main() { switch (1) { case 0: o = vec4(0.0); \n case : } }",
        "void main() { o = vec4(1.0); }\n}\nfloat f() { return a; }",
    ],
    ids=str,
)
def test_what_stands_behind_or_would_be_put_right_is_not_told(body: str) -> None:
    assert [code for code, _ in told(HEAD + body)] == ["SC103"]


def test_a_sound_shader_has_a_tree_and_facts() -> None:
    module, facts = read(Source("test.frag", HEAD + "void main() { o = vec4(1.0); }"))
    assert len(module.decls) == 2
    assert not facts.warnings


def test_the_dialect_holds_for_the_beginning_too() -> None:
    text = "void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime);\nc = q;\nc = 1 + ; }"
    assert told(text, ReadOptions(dialect="shadertoy")) == [("SC201", 2), ("SC103", 3)]


def test_limits_hold_for_the_beginning_too() -> None:
    deep = f"float f() {{ return {'(' * 1200}1.0{')' * 1200}; }}\n#nothing\n"
    assert told(HEAD + deep) == [("SC105", 3), ("SC108", 4)]


def test_a_right_file_has_a_tree_and_facts() -> None:
    module, facts = read(Source("test.frag", "#version 330\nvoid main() { float a = 1.0; }\n"))
    assert facts.functions == module.decls


def test_mistakes_of_types_before_one_of_syntax() -> None:
    text = "#version 330\nfloat f = true;\nvoid main() {\n  int i = 1.5;\n  x = 2;\n  i = i +;\n}\n"
    assert told(text) == [("SC210", 2), ("SC210", 4), ("SC201", 5), ("SC103", 6)]


def test_statements_in_open_braces_count() -> None:
    text = "#version 330\nvoid main() {\n  if (true) {\n    while (true) { y = 1.0;\n    1 1;\n"
    assert told(text) == [("SC201", 4), ("SC103", 5)]


def test_what_follows_is_not_missed() -> None:
    """The function has no return yet, the switch no statement after its last label, the struct no
    semicolon: nothing of that is a mistake."""
    assert told("#version 330\nfloat f() {\n  int a;\n  a a;\n  return 1.0; }\n") == [("SC103", 4)]
    assert told("#version 330\nvoid f() {\n  switch (1) {\n  case 1:\n  a b c;\n  }\n}") == [
        ("SC103", 5)
    ]
    assert told("#version 330\nstruct S { float a;\n  float +; };\nS s;\n") == [("SC103", 3)]


def test_mistakes_before_one_of_the_preprocessor() -> None:
    text = (
        "#version 330\nfloat f = true;\n#if 1\nfloat g = false;\n#error no\n#endif\nfloat h = ;\n"
    )
    assert told(text) == [("SC210", 2), ("SC210", 4), ("SC108", 5)]


def test_a_mistake_of_syntax_before_one_of_the_preprocessor() -> None:
    text = "#version 330\nfloat f = true;\nfloat g = 1 1;\nfloat h = true;\n#error no\n"
    assert told(text) == [("SC210", 2), ("SC103", 3), ("SC108", 5)]


def test_places_behind_macros() -> None:
    text = "#version 330\n#define ONE(x) ((x) + \\\n  true)\nfloat f = ONE(1);\n}\n"
    assert told(text) == [("SC205", 4), ("SC103", 5)]


def test_hosts_stand_around_the_part() -> None:
    text = "void mainImage(out vec4 c, in vec2 p) {\n  c = iTime;\n  c = ;\n}\n"
    assert told(text, ReadOptions(dialect="shadertoy")) == [("SC210", 2), ("SC103", 3)]


@pytest.mark.parametrize("text", ["", "}", "#error no", "#version 330\n)", "#version 1\n;;"])
def test_nothing_before(text: str) -> None:
    assert len(told(text)) <= 1

"""Section 3.3 and 6 of 4.60 have errors of all sorts; a file's are told together, in order."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import InputError, Severity
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.valid.read import read


def told(text: str, options: ReadOptions | None = None) -> list[tuple[int, str]]:
    """Line and code of each error."""
    source = Source("test.frag", text)
    try:
        read(source, "fragment", options or ReadOptions())
    except InputError as error:
        return [
            (source.position(item.span.start).line if item.span else 0, item.code)
            for item in error.diagnostics
            if item.severity is Severity.ERROR
        ]
    return []


def test_a_right_file_has_a_tree_and_facts() -> None:
    module, facts = read(Source("test.frag", "#version 330\nvoid main() { float a = 1.0; }\n"))
    assert facts.functions == module.decls


def test_mistakes_of_types_before_one_of_syntax() -> None:
    text = "#version 330\nfloat f = true;\nvoid main() {\n  int i = 1.5;\n  x = 2;\n  i = i +;\n}\n"
    assert told(text) == [(2, "SC210"), (4, "SC210"), (5, "SC201"), (6, "SC103")]


def test_statements_in_open_braces_count() -> None:
    text = "#version 330\nvoid main() {\n  if (true) {\n    while (true) { y = 1.0;\n    1 1;\n"
    assert told(text) == [(4, "SC201"), (5, "SC103")]


def test_what_follows_is_not_missed() -> None:
    """The function has no return yet, the switch no statement after its last label, the struct no
    semicolon: nothing of that is a mistake."""
    assert told("#version 330\nfloat f() {\n  int a;\n  a a;\n  return 1.0; }\n") == [(4, "SC103")]
    assert told("#version 330\nvoid f() {\n  switch (1) {\n  case 1:\n  a b c;\n  }\n}") == [
        (5, "SC103")
    ]
    assert told("#version 330\nstruct S { float a;\n  float +; };\nS s;\n") == [(3, "SC103")]


def test_mistakes_before_one_of_the_preprocessor() -> None:
    text = (
        "#version 330\nfloat f = true;\n#if 1\nfloat g = false;\n#error no\n#endif\nfloat h = ;\n"
    )
    assert told(text) == [(2, "SC210"), (4, "SC210"), (5, "SC108")]


def test_a_mistake_of_syntax_before_one_of_the_preprocessor() -> None:
    text = "#version 330\nfloat f = true;\nfloat g = 1 1;\nfloat h = true;\n#error no\n"
    assert told(text) == [(2, "SC210"), (3, "SC103"), (5, "SC108")]


def test_places_behind_macros() -> None:
    text = "#version 330\n#define ONE(x) ((x) + \\\n  true)\nfloat f = ONE(1);\n}\n"
    assert told(text) == [(4, "SC205"), (5, "SC103")]


def test_hosts_stand_around_the_part() -> None:
    text = "void mainImage(out vec4 c, in vec2 p) {\n  c = iTime;\n  c = ;\n}\n"
    assert told(text, ReadOptions(dialect="shadertoy")) == [(2, "SC210"), (3, "SC103")]


@pytest.mark.parametrize("text", ["", "}", "#error no", "#version 330\n)", "#version 1\n;;"])
def test_nothing_before(text: str) -> None:
    assert len(told(text)) <= 1

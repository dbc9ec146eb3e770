"""Mistakes in front of the one that keeps a file from being parsed are told with it."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.valid.read import read

HEAD = "#version 330\nout vec4 o;\n"


def told(text: str, options: ReadOptions | None = None) -> list[tuple[str, int]]:
    """Code and line of everything that is wrong with a text."""
    source = Source("test.frag", text)
    with pytest.raises(InputError) as caught:
        read(source, "fragment", options or ReadOptions())
    return [
        (item.code, source.position(item.span.start).line if item.span else 0)
        for item in caught.value.diagnostics
    ]


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

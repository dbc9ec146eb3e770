"""Whatever the input, the parser takes it or tells what is wrong; nothing else is ever raised."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from shadercache.ast.nodes import Module
from shadercache.ast.walk import walk
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.front.preprocess import spellings
from shadercache.source import Source

LANGUAGE = (Path(__file__).parent / "shaders" / "language.frag").read_text()
START = "#version 330\n"


def survive(text: str) -> Module | None:
    """Parse, and print what is accepted; ``None`` where the input is rejected."""
    try:
        module = parse(Source("test.frag", text))
    except InputError as error:
        assert error.diagnostics
        assert all(item.message and item.code.startswith("SC1") for item in error.diagnostics)
        assert all(item.render() for item in error.diagnostics)
        return None
    print_module(module)
    return module


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200))
def test_random_bytes(data: bytes) -> None:
    survive(data.decode("latin-1"))
    survive(START + data.decode("utf-8", "replace"))


WORDS = sorted({*spellings(LANGUAGE), "#", "\\", '"', "/*", "//", "\n", "\r", "\0", "\u00e4"})


@settings(max_examples=200, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=40))
def test_random_words(found: list[str]) -> None:
    survive(START + " ".join(found))
    survive(START + "void main() { " + " ".join(found) + " }")


def test_deleted_and_doubled_words() -> None:
    body = list(spellings(LANGUAGE[LANGUAGE.index("struct") :]))
    pick = random.Random(7)
    for _ in range(60):
        at = pick.randrange(len(body))
        survive(START + " ".join(body[:at] + body[at + 1 :]))
        survive(START + " ".join([*body[:at], body[at], *body[at:]]))
        survive(START + " ".join(body[:at]))


def in_main(text: str) -> str:
    return f"{START}void main() {{ {text} }}"


@pytest.mark.parametrize(
    "text",
    [
        "float x = " + "(" * 10_000 + "1" + ")" * 10_000 + ";",
        "float x = " + "(" * 10_000,
        "x" + "[0" * 5_000 + "]" * 5_000 + ";",
        "f(" * 5_000 + ")" * 5_000 + ";",
        "float x = " + "- " * 10_000 + "1;",
        "float x = " + "-(" * 5_000 + "1" + ")" * 5_000 + ";",
        "if (a) b; " + "else if (a) b; " * 10_000,
        "if (a) " * 10_000 + "b;",
        "{" * 10_000 + "}" * 10_000,
        "for (;;) " * 10_000 + ";",
        "float x = " + "a ? b : " * 10_000 + "c;",
        "float x = " + "a ? " * 10_000 + "b" + " : c" * 10_000 + ";",
        "a = " * 10_000 + "b;",
        "struct S {" * 5_000,
        "float x = " + "{" * 10_000 + "1" + "}" * 10_000 + ";",
        "float x[" + "float[" * 5_000 + "1" + "]" * 5_000 + "];",
        "while (a) do " * 5_000 + ";",
        "switch (a) { case 0: " * 5_000 + "}" * 5_000,
        "!" * 10_000 + "a;",
        "/* " * 10_000 + "*/ (" * 5_000,
    ],
    ids=lambda text: text[:24],
)
def test_what_nests_too_deeply_is_told(text: str) -> None:
    source = Source("test.frag", in_main(text))
    with pytest.raises(InputError) as caught:
        parse(source)
    assert len(caught.value.diagnostics) == 1
    assert caught.value.diagnostics[0].code in ("SC105", "SC103")


@pytest.mark.parametrize(
    "text",
    [
        "float x = " + "(" * 990 + "1" + ")" * 990 + ";",
        "f(a, b + " * 990 + "1" + ")" * 990 + ";",
        "float x = " + "- " * 900 + "1;",
        "if (a) b; " + "else if (a) b; " * 250,
        "{" * 250 + "}" * 250,
        "float x = " + "a ? b : " * 400 + "c;",
        "float x = " + "float[" * 900 + "1" + "](1)" * 900 + ";",
        "float x[" + "float[](1)[" * 400 + "1" + "]" * 400 + "];",
        "// x\n{ // y\n" * 200 + "}" * 200,
    ],
    ids=lambda text: text[:24],
)
def test_what_nests_within_the_limits_is_taken(text: str) -> None:
    assert survive(in_main(text)) is not None


@pytest.mark.parametrize(
    ("text", "nodes"),
    [
        ("x = 1" + "+1" * 100_000 + ";", 200_000),
        ("x = 1" + "*2+3<4" * 20_000 + ";", 120_000),
        ("x" + ".x" * 20_000 + ";", 20_000),
        ("x" + "[0]" * 20_000 + ";", 40_000),
        ("x" + "++" * 20_000 + ";", 20_000),
        ("x" + ", x" * 20_000 + ";", 40_000),
        ("f(x" + ", x" * 20_000 + ");", 20_000),
        ("float x" + ", x" * 20_000 + ";", 20_000),
        ("x; " * 20_000, 40_000),
        ("float x = " + "a * b - c / d % e << 1 + " * 20_000 + "2;", 200_000),
        ("// x\nx; // y\n" * 20_000, 40_000),
    ],
    ids=lambda value: str(value)[:12],
)
@pytest.mark.slow
def test_long_is_not_deep(text: str, nodes: int) -> None:
    module = survive(in_main(text))
    assert module is not None
    assert sum(1 for _ in walk(module)) > nodes


@pytest.mark.parametrize(
    "word",
    ["{}a", "1{}", "0{}", "0x{}", "1{}u", "1{}.0", "0.{}1", "1.0e{}1", ".{}f"],
)
def test_words_and_numbers_have_1024_characters_at_the_most(word: str) -> None:
    filler = "a" if word == "{}a" else "0"
    head = "float " if word == "{}a" else "x = "
    longest = word.format(filler * (1024 - len(word.format(""))))
    assert survive(in_main(f"{head}{longest};")) is not None
    for length in (1, 100_000):
        with pytest.raises(InputError) as caught:
            parse(Source("test.frag", in_main(f"{head}{word.format(filler * (1024 + length))};")))
        (error,) = caught.value.diagnostics
        assert error.code == "SC102"
        assert error.message.endswith("' has more than 1024 characters")


def test_initialiser_lists_nest_within_the_limits() -> None:
    text = "float x = " + "{" * 990 + "1" + "}" * 990 + ";"
    module = survive("#version 420\n" + text)
    assert module is not None
    assert text in print_module(module)


@pytest.mark.slow
def test_many_lines_are_taken() -> None:
    assert survive(START + "float x = a + 1.0; // line\n" * 20_000) is not None


def test_many_errors_in_a_row_leave_nothing_behind() -> None:
    good = in_main("float S = 1.0; S;")
    before = print_module(parse(Source("good", good)))
    for bad in ("struct S { float a; }; void f(S S) { S", "{ ( [", "struct S { float a; }; S S S"):
        assert survive(START + bad) is None
        assert print_module(parse(Source("good", good))) == before

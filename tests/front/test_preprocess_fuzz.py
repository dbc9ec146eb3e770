"""Whatever the preprocessor reads: it is accepted or there are diagnostics, never a traceback."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from shadercache.diagnostics import InputError
from shadercache.front.preprocess import preprocess, spellings
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

pytestmark = pytest.mark.slow

OPTIONS = ReadOptions(max_tokens=5000)
NAMES = ["A", "B", "F", "G", "GL_ES", "__LINE__", "defined"]
PIECES = [
    *NAMES,
    *("(", ")", ",", "##", "#", "1", "0x", "/", "&&", "||", "!", "<<", "@", "\u00e4", "'", '"'),
    *("\\\n", "\\", "\r\n", "\r", "\n", "/*", "*/", "//", " ", "\t", "\v"),
]
HEADS = [
    *("#define A ", "#define F(x) ", "#define G(x, y) ", "#define B() ", "#define ", "#undef "),
    *("#if ", "#ifdef ", "#ifndef ", "#elif ", "#else ", "#endif ", "#line ", "#version ", "#"),
    *("#extension GL_X : ", "#pragma ", "#include ", "#error ", "A", "F(", "G("),
]
LINES = st.tuples(st.sampled_from(HEADS), st.lists(st.sampled_from(PIECES), max_size=6))


def survive(text: str) -> None:
    source = Source("<test>", text)
    try:
        result = preprocess(source, OPTIONS)
    except InputError as error:
        assert error.diagnostics
        assert all(item.render() and item.code.startswith("SC1") for item in error.diagnostics)
        return
    lexemes = result.lexemes
    assert len(lexemes.texts) == len(lexemes.starts) == len(lexemes.ends)
    spans = list(zip(lexemes.starts, lexemes.ends, strict=True))
    assert all(0 <= start < end <= len(text) for start, end in spans)
    assert spans == sorted(spans)


@settings(max_examples=300, deadline=None)
@given(st.lists(LINES, max_size=12), st.sampled_from(["330", "450", "300 es", "100"]))
def test_random_directives(lines: list[tuple[str, list[str]]], version: str) -> None:
    body = "\n".join(head + "".join(pieces) for head, pieces in lines)
    survive(f"#version {version}\n{body}")
    survive(body)


@settings(max_examples=200, deadline=None)
@given(st.text(max_size=100))
def test_any_text(text: str) -> None:
    survive(text)
    survive(f"#version 450\n#if 0\n{text}\n#endif\n#define A {text}\nA A")


@settings(max_examples=100, deadline=None)
@given(
    st.lists(st.sampled_from(["a", "+=", "1.0e5", "/* b */", "// c\n", "\\\n ", "\n"]), max_size=30)
)
def test_a_text_without_macros_stays_as_it_is(pieces: list[str]) -> None:
    source = Source("<test>", "#version 460\n" + " ".join(pieces))
    lexemes = preprocess(source).lexemes
    places = zip(lexemes.starts, lexemes.ends, strict=True)
    assert [source.text[start:end] for start, end in places] == lexemes.texts
    expected = " ".join(piece for piece in pieces if piece[0] not in "/\\")
    assert tuple(lexemes.texts) == spellings(expected)

"""What the versions differ in: words, literals, initialiser lists (section numbers are those of
the specifications, ES 3.00 and desktop alike where no other is named)."""

from __future__ import annotations

import pytest

from shadercache.ast.nodes import Declarator, InitList, Jump, Literal, Module
from shadercache.ast.walk import walk
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.source import Source

DESKTOP = ("110", "120", "130", "140", "150", "330", "400", "420", "430", "460")
EMBEDDED = ("100", "300 es", "310 es", "320 es")


def read(version: str, text: str) -> Module:
    return parse(Source("test", f"#version {version}\n{text}\n"))


def taken(version: str, text: str) -> bool:
    try:
        module = read(version, text)
    except InputError as error:
        assert len(error.diagnostics) == 1
        return False
    again = print_module(module)
    assert print_module(parse(Source("printed", again))) == again
    return True


def versions_with(text: str) -> list[str]:
    """The versions in which a text is right, desktop and embedded."""
    return [version for version in (*DESKTOP, *EMBEDDED) if taken(version, text)]


def since(desktop: str | None, embedded: str | None) -> list[str]:
    first = DESKTOP.index(desktop) if desktop else len(DESKTOP)
    first_es = EMBEDDED.index(embedded) if embedded else len(EMBEDDED)
    return [*DESKTOP[first:], *EMBEDDED[first_es:]]


# --- statements and declarations ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "desktop", "embedded"),
    [
        ("void f() { switch (1) { case 0: break; default: ; } }", "130", "300 es"),
        ("layout(location = 0) in vec4 a;", "140", "300 es"),
        ("layout(std140) uniform B { vec4 a; } b[2];", "140", "300 es"),
        ("precision highp float;", "130", "100"),
        ("highp float a;", "130", "100"),
        ("invariant a;", "120", "100"),
        ("centroid varying vec2 a;", "120", None),
        ("flat in int a;", "130", "300 es"),
        ("noperspective in vec2 a;", "130", None),
        ("sample in vec2 a;", "400", "320 es"),
        ("patch in vec2 a;", "400", "320 es"),
        ("precise float a;", "400", "320 es"),
        ("buffer B { float a[]; };", "430", "310 es"),
        ("readonly coherent volatile restrict writeonly uniform int a;", "420", "310 es"),
        ("uniform image2D a;", "420", "310 es"),
        ("uniform imageBuffer a;", "420", "320 es"),
        ("uniform image1D a;", "420", None),
        ("uniform sampler3D a;", "110", "300 es"),
        ("uniform sampler1D a;", "110", None),
        ("uniform sampler2DMSArray a;", "150", "320 es"),
        ("uniform atomic_uint a;", "420", "310 es"),
        ("dmat2x3 a; dvec4 b; double c;", "400", None),
        ("mat2x3 a;", "120", "300 es"),
        ("uvec2 a; uint b;", "130", "300 es"),
        ("attribute vec2 a; varying vec2 b;", "110", None),
        ("layout(early_fragment_tests) in; layout(std430) buffer;", "430", "310 es"),
    ],
)
def test_since_which_version_section_3_6(
    text: str, desktop: str | None, embedded: str | None
) -> None:
    expected = since(desktop, embedded)
    if text.startswith("attribute"):
        expected.append("100")
    assert versions_with(text) == expected


@pytest.mark.parametrize(
    ("name", "versions"),
    [
        ("sample", (*DESKTOP[:6], "100")),
        ("precise", (*DESKTOP[:6], "100", "300 es")),
        ("buffer", (*DESKTOP[:8], "100", "300 es")),
        ("highp", ("110", "120")),
        ("layout", ("110", "120", "130", "100")),
        ("uint", ("110", "120", "100")),
        ("switch", ()),
        ("input", ()),
        ("texture", (*DESKTOP, *EMBEDDED)),
        ("texture2D", (*DESKTOP, *EMBEDDED)),
        ("row_major", (*DESKTOP, *EMBEDDED)),
        ("std140", (*DESKTOP, *EMBEDDED)),
        ("demote", (*DESKTOP, *EMBEDDED)),
    ],
)
def test_a_word_of_another_version_is_a_name_section_3_6(
    name: str, versions: tuple[str, ...]
) -> None:
    assert versions_with(f"float {name}; float f(float {name}) {{ return {name}; }}") == [*versions]


def test_an_extension_brings_words() -> None:
    text = "void f() { demote; }"
    for behaviour, is_jump in (("require", True), ("enable", True), ("disable", False)):
        line = f"#extension GL_EXT_demote_to_helper_invocation : {behaviour}"
        jumps = [node for node in walk(read("330", f"{line}\n{text}")) if isinstance(node, Jump)]
        assert [jump.word for jump in jumps] == ["demote"] * is_jump
    assert not taken("100", "uniform sampler3D s;")
    assert taken("100", "#extension GL_OES_texture_3D : enable\nuniform sampler3D s;")


# --- literals -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("literal", "desktop", "embedded"),
    [
        ("1.0f", "120", "300 es"),
        ("1.F", "120", "300 es"),
        ("1e3f", "120", "300 es"),
        ("1u", "130", "300 es"),
        ("0xFFU", "130", "300 es"),
        ("017u", "130", "300 es"),
        ("1.0lf", "400", None),
        (".5LF", "400", None),
        ("0x1f", "110", "100"),
        ("0XF", "110", "100"),
        ("017", "110", "100"),
        ("1.", "110", "100"),
        ("09.5", "110", "100"),
    ],
)
def test_suffixes_of_literals_section_4_1(
    literal: str, desktop: str | None, embedded: str | None
) -> None:
    assert versions_with(f"float a = {literal};") == since(desktop, embedded)


@pytest.mark.parametrize("literal", ["08", "0x", "1f", "1.0l", "1.0ff", "1.0e", "1uu", "1.0Lf"])
def test_what_no_version_takes_for_a_literal_section_4_1(literal: str) -> None:
    assert versions_with(f"float a = {literal};") == []


def test_literals_keep_their_spelling() -> None:
    module = read("400", "double a = 1.0lf + .5LF + 1.F + 0x1fU;")
    texts = [node.text for node in walk(module) if isinstance(node, Literal)]
    assert texts == ["1.0lf", ".5LF", "1.F", "0x1fU"]


# --- initialiser lists ----------------------------------------------------------------------------


def test_initialiser_lists_section_4_1_11() -> None:
    assert versions_with("float a[2] = {1.0, 2.0};") == since("420", None)
    module = read("420", "struct S { float a; }; S s = {1.0, {2.0, {f(x), 3.0,},}}, t = {x = 1};")
    _, first, second = (node for node in walk(module) if isinstance(node, Declarator))
    assert isinstance(first.init, InitList)
    assert [type(item).__name__ for item in first.init.items] == ["Literal", "InitList"]
    assert "S s = {1.0, {2.0, {f(x), 3.0}}}, t = {x = 1};" in print_module(module)
    assert isinstance(second.init, InitList)


@pytest.mark.parametrize(
    "text",
    [
        "float a = {};",
        "float a = {,};",
        "float a = {1.0,,};",
        "void f() { a = {1.0}; }",
        "float f() { return {1.0}; }",
        "float a = float({1.0});",
    ],
)
def test_where_no_initialiser_list_stands_section_4_1_11(text: str) -> None:
    assert not taken("420", text)


def test_a_version_without_lists_takes_them_with_the_extension() -> None:
    text = "float a[2] = {1.0, 2.0};"
    assert taken("330", f"#extension GL_ARB_shading_language_420pack : enable\n{text}")


# --- the version line -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "line", ["100", "300 es", "310 es", "320 es", "110", "120", "150", "330 core", "450"]
)
def test_the_version_is_printed_as_its_language_writes_it(line: str) -> None:
    assert print_module(read(line, "")) == f"#version {line}\n"

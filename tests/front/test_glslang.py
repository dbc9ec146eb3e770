"""The reference compiler and this parser accept the same; what is printed it accepts too."""

from __future__ import annotations

import re
from pathlib import Path

from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.source import Source
from tests.glslang import errors_of, needs_glslang

pytestmark = needs_glslang

SHADERS = Path(__file__).parent / "shaders"

STRUCT = "struct S { float a; };"
BOTH_TAKE = [
    "int sample = 1;",
    "int packed, row_major;",
    "float f(float f) { return f; }",
    "float x = 1.0; void main2() { float x = x + 1.0; }",
    f"{STRUCT} float f(S S) {{ return S.a; }}",
    f"{STRUCT} S f() {{ S S = S(1.0); return S; }} S s;",
    f"{STRUCT} void f() {{ for (float S = 1.0; S < 2.0; S++) ; S s = S(1.0); }}",
    f"{STRUCT} void f() {{ {{ float S; }} S s; }}",
    f"{STRUCT} void f() {{ if (true) {{ float S; }} S s; }}",
    "void f() { int a = 1, b = a---1; b = a- -1; b = - -a; b = +-+a; b = !true ? ~-1 : 2; }",
    "void f() { int a = 8; a >>= 1; a = a >> 1 << 2; a <<= 1; bool b = a < 1 == a >= 2; }",
    "void f() { if (true) if (false) ; else ; else ; }",
    "void f() { switch (1) { case 0: case 1: { } break; default: break; } }",
    "void f() { for (int i = 0, j = 1; i < j; i++, j--) continue; for (;;) break; }",
    "void f() { do ; while (false); while (bool b = false) ; }",
    "void f() { float a[2] = float[2](1., .5); float[] b = float[](a[0], a[1]); a.length(); }",
    "float f(void); float f(void) { return 1e3 + 1.e-3 + 0.5f + float(0x1Fu) + float(017); }",
    "const vec3 a[2] = vec3[2](vec3(1.0), vec3(2.0)), b = vec3(a[1].zyx);",
    "uniform B { vec4 a; layout(row_major) mat4 m; } b[2];",
    "layout(std140) uniform; layout(std140) uniform B { float a, b; };",
    "layout(location = 0) out vec4 o; invariant gl_FragDepth;",
    "noperspective centroid in vec2 a; flat in ivec2 b; smooth in mat2x3 c;",
    "precision highp float; precision lowp sampler2D; highp float a; uniform mediump int b;",
    "void f(in float, const in vec2 a, out vec3 b[2], inout highp int c) { b[0] = vec3(c); }",
    "struct { float a; } s; struct T { float a[2], b; vec2[2] c; } t[2], u;",
    "void f() { float x = true ? 1.0 : false ? 2.0 : 3.0; x = (x, 2.0), x; }",
    "void f() { float f(float); precision lowp int; }",
    "#define A (1.0 + B)\n#define B 2.0 \nfloat a = A * B;",
    "#define highp\nhighp float a;",
    "#pragma anything at all\n#extension all : disable\n#\nint a = __LINE__ + __VERSION__;",
    "float a; // \u00e4 \u2264\n/* \u4e16 ** // */ float b;",
]

NEITHER_TAKES = [
    "float a",
    "float 1a;",
    "float a = 08;",
    "float a = 1.0e;",
    "float a = ;",
    "float half;",
    "double a;",
    "precise float a;",
    "subroutine float f();",
    "float a = (1.0;",
    "float a = 1.0);",
    "void f() { a b; }",
    "void f() { if (true) }",
    "void f() { else ; }",
    "void f() { case 1: ; }",
    "void f() { for (int i = 0; i < 2) ; }",
    "void f() { while () ; }",
    "void f() { do ; while (true) }",
    "void f() { float g() { return 1.0; } }",
    "void f() { uniform B { float a; }; }",
    "void f() { return 1.0 }",
    "void f() { int a = 1 +; }",
    "void f() { int a = 1 @ 2; }",
    "void f(float a b);",
    "struct S { float a }",
    "struct S { float a; } float b;",
    "const a = 1.0;",
    "in a;",
    "goto a;",
    "void f() { float a[2]; a.size(); }",
    "layout(location = 0 out vec4 o;",
    "float a = \u00e4;",
    "/* never closed",
    "float a[1, 2];",
    f"{STRUCT} void f() {{ float S; S s; }}",
    f"void f() {{ {{ {STRUCT} }} S s; }}",
]


def complaints(texts: list[str], folder: Path) -> list[list[str]]:
    """What glslang says against each of these shaders."""
    files = {}
    for number, text in enumerate(texts):
        stage = "vert" if "gl_Position" in text else "frag"
        files[folder / f"{number}.{stage}"] = text
    for file, text in files.items():
        file.write_text(text)
    return list(errors_of(files).values())


def reference(texts: list[str], folder: Path) -> list[bool]:
    """Does glslang take each of these shaders?"""
    return [not errors for errors in complaints(texts, folder)]


def shader(text: str) -> str:
    return f"#version 330\n{text}\nvoid main() {{ }}\n"


def ours(text: str) -> bool:
    try:
        parse(Source("test", text))
    except InputError:
        return False
    return True


def test_both_take_or_neither(tmp_path: Path) -> None:
    texts = [shader(text) for text in BOTH_TAKE + NEITHER_TAKES]
    expected = [True] * len(BOTH_TAKE) + [False] * len(NEITHER_TAKES)
    for text, taken, right in zip(texts, reference(texts, tmp_path), expected, strict=True):
        assert (text, ours(text), taken) == (text, right, right)


def test_it_takes_what_is_printed(tmp_path: Path) -> None:
    texts = [path.read_text() for path in sorted(SHADERS.iterdir())]
    texts += [shader(text) for text in BOTH_TAKE]
    printed = [print_module(parse(Source("test", text))) for text in texts]
    for text, taken in zip(printed, reference(printed, tmp_path), strict=True):
        assert (text, taken) == (text, True)


SNIPPETS = (Path(__file__).parent / "snippets.txt").read_text().splitlines()
VERSIONS = ("100", "300 es", "310 es", "320 es", "110", "120", "130", "150", "330", "420", "460")
SYNTAX = re.compile("syntax error|Reserved word|style initializers|suffix|unsigned literal")
"""What glslang says of errors that a parser finds; others are for the checker of types."""


def in_version(version: str, text: str) -> str:
    precision = "precision mediump float; precision mediump int;"
    defaults = precision if version == "100" or version.endswith("es") else ""
    main = "" if "main(" in text else "void main() { }"
    return f"#version {version}\n{defaults}\n{text}\n{main}\n"


def test_snippets_in_versions(tmp_path: Path) -> None:
    """Each snippet in two versions, which move on from snippet to snippet: all would take long."""
    pairs = [(text, place) for place, text in enumerate(SNIPPETS)]
    places = [(text, (place * step) % len(VERSIONS)) for text, place in pairs for step in (1, 3)]
    texts = [in_version(VERSIONS[place], text) for text, place in places]
    printed = []
    for text, errors in zip(texts, complaints(texts, tmp_path), strict=True):
        if not errors:
            printed.append(print_module(parse(Source("test", text))))
        elif SYNTAX.search(errors[0]):
            assert (text, ours(text)) == (text, False)
    assert len(printed) > 100
    for text, errors in zip(printed, complaints(printed, tmp_path), strict=True):
        assert (text, errors) == (text, [])

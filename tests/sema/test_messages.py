"""What the user is told: all mistakes, in order, at the right place, without cascades."""

from __future__ import annotations

import pytest
from sema.tools import message


def said(body: str, declarations: str = "") -> str:
    return message(f"#version 330\n{declarations}void main() {{\n{body}\n}}\n")


def test_a_diagnostic_has_place_snippet_and_code() -> None:
    assert said("float x = vec2(1.0);") == (
        "test.glsl:3:11: error: cannot initialise 'x' of type float with vec2 [SC210]\n"
        "    3 | float x = vec2(1.0);\n"
        "      |           ^~~~~~~~~"
    )


def test_all_mistakes_are_told_in_source_order() -> None:
    found = said("one = 1.0;\nfloat x = true;\ntwo(2.0);\nif (3) { }")
    lines = [line.split(":")[1] for line in found.splitlines() if ": error:" in line]
    assert lines == ["3", "4", "5", "6"]


@pytest.mark.parametrize(
    ("body", "hint"),
    [
        ("float radius = 1.0; radios += 1.0;", "did you mean 'radius'?"),
        ("vec3 x = normalise(vec3(1.0));", "did you mean 'normalize'?"),
        ("vec2 p = gl_FragCord.xy;", "did you mean 'gl_FragCoord'?"),
        ("Ray r = Ray(1.0); r.origin2 = 1.0;", "did you mean 'origin'?"),
    ],
)
def test_near_misses_get_a_hint(body: str, hint: str) -> None:
    assert hint in said(body, "struct Ray { float origin; };\n")


def test_functions_of_later_versions_are_no_hint() -> None:
    assert "hint" not in said("float x = fmaa(1.0, 2.0, 3.0);")


def test_candidates_are_listed() -> None:
    declarations = (
        "float f(int a, out vec2 b) { b = vec2(a); return 1.0; }\nfloat f(vec3 a) { return a.x; }\n"
    )
    found = said("float x = f(true);", declarations)
    assert "no function fits the call f(bool) [SC206]" in found
    assert "hint: candidates: float f(vec3)" in found
    found = said("float x = f(1, 2, 3);", declarations)
    assert "'f' takes 1 or 2 arguments, not 3 [SC207]" in found
    assert "candidates: float f(int, out vec2), float f(vec3)" in found


def test_long_lists_of_candidates_are_cut() -> None:
    assert " more" in said("float x = texture(1.0, 2.0);")


def test_an_ambiguous_call_names_its_candidates() -> None:
    declarations = (
        "float f(float a, int b) { return 1.0; }\nfloat f(int a, float b) { return 1.0; }\n"
    )
    found = said("float x = f(1, 1);", declarations)
    assert "the call f(int, int) is ambiguous [SC208]" in found
    assert "float f(float, int), float f(int, float)" in found


@pytest.mark.parametrize(
    ("body", "text"),
    [
        ("vec3 a = vec3(1.0) * mat2(1.0);", "'*' does not apply to vec3 and mat2"),
        ("vec3 a; a.xx = vec2(1.0);", "the swizzle 'xx' names a component twice"),
        ("gl_FragCoord.x = 1.0;", "'gl_FragCoord' is read-only: it cannot be changed"),
        ("vec2 a = vec2(1.0, 2.0, 3.0);", "vec2 has 2 components, the last argument is not used"),
        ("mat2 a = mat2(1.0, 2.0);", "mat2 needs 4 components, the arguments have 2"),
        ("float a[3]; a[7] = 1.0;", "index 7 is outside of float[3]"),
        ("if (1) { }", "the condition is int, not bool"),
    ],
)
def test_messages_say_what_is_wrong(body: str, text: str) -> None:
    assert text in said(body)


def test_recursion_names_the_cycle() -> None:
    text = message(
        "#version 330\nvoid a(); void b() { a(); } void c() { b(); } void a() { c(); }\n"
        "void main() { a(); }\n"
    )
    assert text.count("SC216") == 1
    assert "recursion is not allowed: b > a > c > b" in text


def test_errors_do_not_cascade() -> None:
    body = (
        "vec3 a = nothing(1.0); float b = a.x + missing; b = b * missing; a = vec3(missing, b, b);"
    )
    found = said(body)
    assert found.count("error:") == 2


def test_a_missing_main_is_told() -> None:
    assert "there is no function 'void main()' [SC217]" in message("#version 330\nfloat a;\n")

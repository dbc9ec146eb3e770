"""Dead code goes, and nothing else."""

from __future__ import annotations

import pytest

from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.remove_dead import remove_dead

HEAD = """#version 330
uniform float u_a;
uniform float u_b;
in vec3 v_a;
in vec3 v_b;
out vec4 color;
out vec4 store;
"""


def pruned(text: str, *wanted: str) -> str:
    """The text of a shader with :data:`HEAD` after the pass."""
    module = parse(Source("test.frag", HEAD + text))
    return print_module(remove_dead(module, wanted or ("color",)))


def main_of(body: str, *wanted: str) -> list[str]:
    """The statements of ``main`` that are left, white space removed."""
    text = pruned(f"void main() {{ {body} }}", *wanted)
    inside = text.split("void main() {", 1)[1].rsplit("}", 1)[0]
    return [line.strip() for line in inside.strip().splitlines()]


@pytest.mark.parametrize(
    ("body", "left"),
    [
        ("float a = u_a; color = vec4(u_b);", ["color = vec4(u_b);"]),
        ("float a = u_a; color = vec4(a);", ["float a = u_a;", "color = vec4(a);"]),
        # An overwritten value is dead, a partly overwritten one is not.
        (
            "vec4 a = vec4(u_a); a = vec4(u_b); color = a;",
            ["vec4 a;", "a = vec4(u_b);", "color = a;"],
        ),
        (
            "vec4 a = vec4(u_a); a.x = u_b; color = a;",
            ["vec4 a = vec4(u_a);", "a.x = u_b;", "color = a;"],
        ),
        ("color = vec4(u_a); color = vec4(u_b);", ["color = vec4(u_b);"]),
        ("color = vec4(u_a); color.x = u_b;", ["color = vec4(u_a);", "color.x = u_b;"]),
        ("color = vec4(u_a); color += vec4(u_b);", ["color = vec4(u_a);", "color += vec4(u_b);"]),
        # What is written under a condition may survive it.
        (
            "float a = u_a; if (u_b > 0.0) a = 1.0; color = vec4(a);",
            ["float a = u_a;", "if (u_b > 0.0)", "a = 1.0;", "color = vec4(a);"],
        ),
        ("float a = u_a; if (u_b > 0.0) a = 1.0; color = vec4(u_a);", ["color = vec4(u_a);"]),
        (
            "if (u_b > 0.0) { float a = u_a; } else { color = vec4(u_a); } color.x = 1.0;",
            ["if (!(u_b > 0.0)) {", "color = vec4(u_a);", "}", "color.x = 1.0;"],
        ),
        # A return decides what comes after it.
        (
            "color = vec4(0.0); float a = u_a; if (a > 0.0) return; color = vec4(u_b);",
            [
                "color = vec4(0.0);",
                "float a = u_a;",
                "if (a > 0.0)",
                "return;",
                "color = vec4(u_b);",
            ],
        ),
        (
            "float a = 0.0; for (int i = 0; i < 3; i++) { float b = u_b; } color = vec4(a);",
            ["float a = 0.0;", "color = vec4(a);"],
        ),
        (
            "int i = 0; for (; i < 3; i++) { float b = u_b; } color = vec4(i);",
            ["int i = 0;", "for (; i < 3; i++) {", "}", "color = vec4(i);"],
        ),
        # Loops: carried values live, unused loops go.
        (
            "float s = 0.0; for (int i = 0; i < 3; i++) { s += u_a; } color = vec4(u_b);",
            ["color = vec4(u_b);"],
        ),
        (
            "float s = 0.0; float t = 0.0; for (int i = 0; i < 3; i++) { t += u_b; s += u_a; }"
            " color = vec4(s);",
            [
                "float s = 0.0;",
                "for (int i = 0; i < 3; i++) {",
                "s += u_a;",
                "}",
                "color = vec4(s);",
            ],
        ),
        (
            "float a = 0.0; float b = u_b; while (a < 3.0) { a = a + b; b = u_a; }"
            " color = vec4(a);",
            [
                "float a = 0.0;",
                "float b = u_b;",
                "while (a < 3.0) {",
                "a = a + b;",
                "b = u_a;",
                "}",
                "color = vec4(a);",
            ],
        ),
        (
            "float a = 0.0; float b = u_b; for (;;) { if (b > 3.0) break; a = b; b += u_a; }"
            " color = vec4(a);",
            None,
        ),
        # A discard is never removed, nor what decides it.
        (
            "float a = u_a; if (a > 0.0) discard; color = vec4(u_b);",
            ["float a = u_a;", "if (a > 0.0)", "discard;", "color = vec4(u_b);"],
        ),
        # A switch goes where nothing of it is left.
        (
            "float a = 0.0; switch (1) { case 1: a = u_a; } color = vec4(u_b);",
            ["color = vec4(u_b);"],
        ),
        (
            "float a = u_a; switch (1) { case 1: a = u_b; break; default: a += 1.0; }"
            " color = vec4(a);",
            None,
        ),
    ],
)
def test_statements(body: str, left: list[str] | None) -> None:
    """``None``: nothing may go but a declaration that nobody reads."""
    found = main_of(body)
    if left is None:
        whole = main_of(body, "color", "store")
        assert [line for line in whole if "float a = u_a" not in line or "if" in line] or found
        assert "color" in " ".join(found)
        kept = " ".join(found)
        for part in ("break;", "a += 1.0;", "b += u_a;", "color.x = 1.0;"):
            assert (part in body) == (part in kept)
    else:
        assert found == left


def test_an_array_element_written_in_a_loop_keeps_the_array() -> None:
    found = main_of("float a[3]; for (int i = 0; i < 3; i++) a[i] = u_a; color = vec4(a[1]);")
    assert found[0] == "float a[3];"
    assert "a[i] = u_a;" in " ".join(found)


def test_calls_stay_for_what_they_write() -> None:
    text = pruned(
        """float g;
        float dead;
        void set(float x) { g = x; }
        void ignore(float x) { dead = x; }
        void give(float x, out float y) { y = x; }
        void main() { set(u_a); ignore(u_b); float a; give(u_a, a); float b; give(u_b, b);
                      color = vec4(g + a); }""",
    )
    assert "ignore" not in text and "dead" not in text
    assert "set(u_a);" in text and "give(u_a, a);" in text
    assert "u_b" not in text


FUNCTIONS = """float g;
float h;
float set(float x) { g = x; return x * 2.0; }
float count(float x) { h += 1.0; return x; }
float last(float x) { h = x; return x; }
"""


@pytest.mark.parametrize(
    ("body", "left"),
    [
        ("float a = 2.0 * set(u_a) + u_b; color = vec4(g);", ["set(u_a);", "color = vec4(g);"]),
        ("float a; a = -set(u_a); a *= u_b; color = vec4(g);", ["set(u_a);", "color = vec4(g);"]),
        (
            "vec2 a; a.x = vec2(count(u_a), set(u_b)).y; color = vec4(g);",
            ["set(u_b);", "color = vec4(g);"],
        ),
        (
            "if (set(u_a) > u_b) h = 1.0; color = vec4(g);",
            ["set(u_a);", "color = vec4(g);"],
        ),
        # Whether it is called at all still hangs on the left side.
        (
            "bool a = u_a > 0.0 && set(u_a) > u_b; color = vec4(g);",
            ["u_a > 0.0 && set(u_a) > u_b;", "color = vec4(g);"],
        ),
        # A counter that only counts itself is dead; so is what is left behind the last reader.
        ("count(u_a); color = vec4(u_b);", ["color = vec4(u_b);"]),
        ("color = vec4(h); last(u_a);", ["color = vec4(h);"]),
        ("last(u_a); color = vec4(h);", ["last(u_a);", "color = vec4(h);"]),
        ("for (int i = 0; i < 3; i++) { color = vec4(h); last(u_a); }", None),
        ("color = vec4(last(u_a) + h);", None),
        ("color = vec4(h + last(u_a));", None),
        ("float a = last(last(u_a) + h); color = vec4(a);", None),
    ],
)
def test_what_a_call_leaves_behind(body: str, left: list[str] | None) -> None:
    """``None``: all of it stays, the body of ``last`` included."""
    text = pruned(f"{FUNCTIONS}void main() {{ {body} }}")
    found = [line.strip() for line in text.split("void main() {", 1)[1].splitlines()]
    if left is not None:
        assert [line for line in found if line not in ("", "}")] == left
    else:
        assert "h = x;" in text and "last(u_a)" in text


@pytest.mark.parametrize(
    ("body", "left"),
    [
        # Only what is wanted behind the switch is left of its groups; the last label needs a body.
        (
            "float a = 0.0; float d = 0.0; switch (1) { case 1: a = u_a; d = u_b; break;"
            " case 2: d += 1.0; default: d += 2.0; } color = vec4(a);",
            [
                "float a = 0.0;",
                "switch (1) {",
                *("case 1:", "a = u_a;", "break;", "case 2:", "default:", "break;"),
                "}",
                "color = vec4(a);",
            ],
        ),
        # A group falls through to the next, so what that reads is wanted.
        (
            "float a = 0.0; float d; switch (1) { case 1: d = u_b; case 2: a = d; break; }"
            " color = vec4(a);",
            None,
        ),
        ("float a; switch (1) { case 1: if (u_a > 0.0) discard; } color = vec4(u_b);", None),
    ],
)
def test_a_switch_is_pruned_inside(body: str, left: list[str] | None) -> None:
    if left is None:
        left = [part for part in main_of(body, "color", "store") if part != "float a;"]
    assert main_of(body) == left


@pytest.mark.parametrize(
    ("body", "left"),
    [
        ("color = vec4(u_a); if (u_b > 0.0) { store = color; return; }", ["color = vec4(u_a);"]),
        (
            "color = vec4(u_a); if (u_b > 0.0) return; else { if (u_a > 0.0) { return; } }",
            ["color = vec4(u_a);"],
        ),
        ("if (u_b > 0.0) return; color = vec4(u_a);", None),
        ("if (u_b > 0.0) { color = vec4(u_b); return; } color = vec4(u_a);", None),
        ("for (;;) { if (u_b > 0.0) { color = vec4(u_a); return; } }", None),
    ],
)
def test_a_return_behind_which_nothing_comes_goes(body: str, left: list[str] | None) -> None:
    assert main_of(body) == (left or main_of(body, "color", "store"))
    assert left is not None or "return" in " ".join(main_of(body))


def test_only_the_wanted_outputs_are_left() -> None:
    text = pruned("void main() { color = vec4(v_a, u_a); store = vec4(v_b, u_b); }", "store")
    for name in ("color", "v_a", "u_a"):
        assert name not in text
    assert "in vec3 v_b;" in text and "uniform float u_b;" in text


def test_an_output_that_is_read_becomes_a_variable() -> None:
    text = pruned("void main() { color = vec4(u_a); store = color; }", "store")
    assert "\nvec4 color;" in text and "out vec4 color" not in text


def test_functions_structs_and_constants_are_kept_while_used() -> None:
    text = pruned(
        """struct Used { float x; };
        struct Unused { float x; };
        const int N = 2;
        const int M = 3;
        float helper(Used u[N]) { return u[1].x; }
        float unused() { return 1.0; }
        void main() { Used u[N]; u[0].x = u_a; u[1].x = u_a; color = vec4(helper(u)); }"""
    )
    assert "struct Used" in text and "const int N" in text and "helper" in text
    assert "Unused" not in text and "int M" not in text and "unused" not in text


def test_uniform_blocks_are_kept_whole() -> None:
    declarations = "layout(std140) uniform Block { float x; float y; };\n"
    used = pruned(declarations + "void main() { color = vec4(x); }")
    assert "uniform Block" in used and "float y;" in used
    assert "Block" not in pruned(declarations + "void main() { color = vec4(u_a); }")


def test_a_module_with_nothing_dead_is_returned_itself() -> None:
    text = "#version 330\nout vec4 color;\nvoid main() { color = vec4(1.0); }"
    module = parse(Source("test.frag", text))
    assert remove_dead(module, ("color",)) is module


def test_what_a_function_leaves_in_its_out_parameters_is_needed() -> None:
    text = pruned(
        """void scale(inout vec2 v) { v = v.yx * u_a; }
        void split(float x, out float y, out float z) { y = x; z = x * u_b; }
        void main() { vec2 v = v_a.xy; scale(v); float y; float z; split(v.x, y, z);
                      color = vec4(v, y, z); }"""
    )
    for part in ("v = v.yx * u_a;", "y = x;", "z = x * u_b;"):
        assert part in text


def test_a_continue_inside_a_switch_leads_to_the_next_round() -> None:
    found = main_of(
        "float x = u_a; float s = 0.0; for (int i = 0; i < 3; i++) {"
        " x = u_b; switch (i) { case 1: continue; } s += 1.0; x = 2.0; }"
        " color = vec4(x + s);"
    )
    assert "x = u_b;" in found and "switch (i) {" in found and "continue;" in found

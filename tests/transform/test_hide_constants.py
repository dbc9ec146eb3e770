"""Constants that become values are hidden from the driver; operands and constants are not."""

from __future__ import annotations

import pytest

from shadercache.ast.memo import Memo
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.sema.check import check
from shadercache.source import Source
from shadercache.transform.hide_constants import hide_constants

HEAD = """#version 330
in vec3 v_a;
out vec4 color;
const float K = 0.25;
struct Pair { float one; vec2 two; };
float f(float x, int k) { return x * float(k); }
"""

ZERO = "(gl_FragCoord.x < 0.0)"


def hidden(body: str, head: str = HEAD) -> str:
    text = f"{head}{body}"
    made = print_module(hide_constants(parse(Source("test.frag", text)), Memo()))
    check(parse(Source("made.frag", made)), Source("made.frag", made))
    return made


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("float a = 0.5;", f"float a = 0.5 - float{ZERO};"),
        ("float a = 1;", f"float a = 1 - int{ZERO};"),
        ("vec3 a = vec3(0.5, 1, K);", f"vec3 a = vec3(0.5, 1, K) - vec3{ZERO};"),
        ("mat2 a = mat2(2.0);", f"mat2 a = mat2(2.0) - mat2{ZERO};"),
        ("float a = -(0.5 + K) * 3.0;", f"float a = -(0.5 + K) * 3.0 - float{ZERO};"),
        ("vec4 a = vec4(v_a, 1.0);", f"vec4 a = vec4(v_a, 1.0 - float{ZERO});"),
        ("vec4 a = vec4(v_a, 1);", f"vec4 a = vec4(v_a, 1 - int{ZERO});"),
        ("vec3 a = v_a; a.y = 0.5;", f"a.y = 0.5 - float{ZERO};"),
        ("float a = v_a.x > K ? 0.5 : K;", f"v_a.x > K ? 0.5 - float{ZERO} : K - float{ZERO};"),
        ("float a = f(0.5, 3);", f"f(0.5 - float{ZERO}, 3);"),
        ("Pair a = Pair(0.5, v_a.xy);", f"Pair(0.5 - float{ZERO}, v_a.xy);"),
        (
            "float a[2] = float[2](0.5, v_a.x);",
            f"float[2](0.5 - float{ZERO}, v_a.x);",
        ),
    ],
)
def test_what_becomes_a_value(before: str, after: str) -> None:
    assert after in hidden(f"void main() {{ {before} color = vec4(v_a, v_a.x); }}")


@pytest.mark.parametrize(
    "kept",
    [
        "const float a = 0.5;",
        "float a = v_a.x * 0.5 + K;",
        "vec3 a = mix(v_a, vec3(0.5), 0.25);",
        "int a = 3;",
        "bool a = true;",
        "int a = 0; a = 7;",
        "float a = texture(u_map, v_a.xy, 0.5).x;",
        "ivec2 a = ivec2(3, int(v_a.x));",
        "float a = v_a[1];",
    ],
)
def test_what_stays(kept: str) -> None:
    head = HEAD + "uniform sampler2D u_map;\n"
    made = hidden(f"void main() {{ {kept} color = vec4(v_a, v_a.x); }}", head)
    assert kept.split(";")[-2].strip() in made
    assert "gl_FragCoord" not in made


def test_loops_and_results() -> None:
    made = hidden(
        "float g() { return K; } void main() { for (float i = 0.0; i < 3.0; i += 1.0) {"
        " float K = v_a.x; color.x = K; } color.y = g(); }"
    )
    assert "for (float i = 0.0; i < 3.0; i += 1.0)" in made
    assert "return K;" in made, "a name that is also another variable's may be no constant"
    assert f"return 0.5 - float{ZERO};" in hidden(
        "float g() { return 0.5; } void main() { color = vec4(g()); }"
    )


def test_functions_that_are_shared_are_made_once() -> None:
    memo = Memo()
    module = parse(Source("test.frag", HEAD + "void main() { color.x = 0.5; }"))
    assert hide_constants(module, memo).decls[-1] is hide_constants(module, memo).decls[-1]

"""Arguments of roots, powers and sines are hidden from the driver; what must be constant is not."""

from __future__ import annotations

import pytest

from shadercache.ast.memo import Memo
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.proof.opaque_arguments import make_arguments_opaque
from shadercache.valid.validate import validate

HEAD = """#version 330
in vec3 v_a;
out vec4 color;
const float K = 0.25;
const float Z = sqrt(0.25) - 0.5;
const float W[2] = float[2](0.5, 0.0);
float sin(float x, int k) { return x * float(k); }
float exp(float x) { return 2.0 * x; }
"""

ZERO = "float(gl_FragCoord.x < 0.0)"


def hidden(body: str) -> str:
    text = f"{HEAD}void main() {{ {body} color = vec4(v_a, 1.0); }}"
    made = print_module(make_arguments_opaque(parse(Source("test.frag", text)), Memo()))
    validate(parse(Source("made.frag", made)), Source("made.frag", made))
    assert "const float Z = sqrt(0.25) - 0.5;" in made
    return made


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("float a = pow(0.5, v_a.x);", f"pow(0.5 - {ZERO}, v_a.x)"),
        ("vec3 a = normalize(v_a * 2.0);", f"normalize(v_a * 2.0 - {ZERO})"),
        ("float a = cos(sqrt(3.0));", f"cos(sqrt(3.0 - {ZERO}) - {ZERO})"),
        ("float a = sqrt(v_a.x > 0.0 ? 1.0 : 2.0);", f"sqrt((v_a.x > 0.0 ? 1.0 : 2.0) - {ZERO})"),
        ("float a = cos(3);", f"cos(3 - {ZERO})"),
        ("float a = 0.0 * v_a.x;", f"float a = {ZERO} * v_a.x;"),
        ("vec3 a = vec3(1, 0, v_a.x);", f"vec3(1, {ZERO}, v_a.x)"),
        ("float a = -0.0;", f"float a = -{ZERO};"),
        ("float a = 0;", f"float a = {ZERO};"),
        ("vec2 a = vec2(fract(3.0), Z);", f"vec2(fract(3.0) + {ZERO}, Z + {ZERO})"),
        ("float a = W[int(v_a.x)];", f"W[int(v_a.x)] + {ZERO}"),
        ("mat2 a = mat2(0.5);", f"mat2(0.5) + {ZERO}"),
    ],
)
def test_what_is_hidden(before: str, after: str) -> None:
    assert after in hidden(before)


@pytest.mark.parametrize(
    "kept",
    [
        "const float a = sqrt(0.5);",
        "float a[int(sqrt(4.0))];",
        "float a[2] = float[int(sqrt(4.0))](1.0, 2.0);",
        "switch (int(v_a.x)) {\n        case int(sqrt(4.0)):\n            break;",
        "float a = sin(v_a.x, 3);",
        "float a = exp(v_a.x);",
        "vec3 a = mix(v_a, vec3(0.5), 0.25) * 0.5;",
        "bool a = v_a.x > 0.0;",
        "int a = 0;",
        "ivec2 a = ivec2(0.0);",
        "float a = v_a[0];",
        "const float a = 0.0;",
        "vec3 a = v_a * K;",
    ],
)
def test_what_stays(kept: str) -> None:
    made = hidden(kept + " }" * kept.count("{"))
    assert kept in made
    assert "gl_FragCoord" not in made


def test_functions_that_are_shared_are_made_once() -> None:
    memo = Memo()
    module = parse(Source("test.frag", HEAD + "void main() { color.x = cos(v_a.x); }"))
    assert (
        make_arguments_opaque(module, memo).decls[-1]
        is make_arguments_opaque(module, memo).decls[-1]
    )

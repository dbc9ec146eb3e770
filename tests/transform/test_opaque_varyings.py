"""Proof mode: a varying that is the same at every vertex seems to depend on the vertex."""

from __future__ import annotations

import pytest

from shadercache.ast.memo import Memo
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.proof.opaque_varyings import hide_uniform_varyings
from shadercache.valid.validate import validate

HEAD = """#version 400
in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
"""

UNIFORM = [
    ("out vec4 v_tint;", "v_tint = u_tint;", ["v_tint"]),
    ("out float v_a; out mat2 v_b;", "v_a = 0.5; v_b = mat2(u_tint);", ["v_a", "v_b"]),
    (
        "out vec4 v_tint; vec4 g;",
        "g = u_tint; v_tint = g; if (g.x > 0.0) return; v_tint *= 2.0;",
        ["v_tint"],
    ),
]
VARYING = [
    ("out vec4 v_tint;", "v_tint = u_tint * a_position.x;"),
    ("out vec4 v_tint; vec3 g;", "g = a_position; v_tint = u_tint; if (g.x > 0.0) v_tint.x = 1.0;"),
    ("out float v_number;", "v_number = float(gl_VertexID);"),
    ("flat out vec4 v_tint;", "v_tint = u_tint;"),
    ("flat out int v_number;", "v_number = 3;"),
]
LAST = "gl_Position = u_matrix * vec4(a_position, 1.0);"


def hidden(outputs: str, body: str) -> tuple[str, str]:
    text = f"{HEAD}{outputs}\nvoid main() {{ {LAST} {body} }}"
    module = parse(Source("test.vert", text))
    made = print_module(hide_uniform_varyings(module, "sc_", Memo()))
    validate(parse(Source("made.vert", made)), Source("made.vert", made), "vertex")
    return print_module(module), made


@pytest.mark.parametrize(("outputs", "body", "names"), UNIFORM)
def test_what_is_uniform_is_hidden(outputs: str, body: str, names: list[str]) -> None:
    _, made = hidden(outputs, body)
    last = made[made.index("void main()") :]
    negated = "\n".join(f"        {name} = -{name};" for name in names)
    assert last == (
        f"void main() {{\n    sc_main();\n    if (gl_VertexID < 0) {{\n{negated}\n    }}\n}}\n"
    )


@pytest.mark.parametrize(("outputs", "body"), VARYING)
def test_what_varies_or_is_flat_stays(outputs: str, body: str) -> None:
    before, made = hidden(outputs, body)
    assert made == before

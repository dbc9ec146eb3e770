"""The emitted vertex shaders: twins of what decides the position, and interfaces that meet."""

from __future__ import annotations

import pytest
from manifests import plain
from shaders import analysed, find

from shadercache.compiler import Analysis, analyse
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.valid.validate import validate
from tests.configured import rewritten

PAYLOAD = "sin(v_position * 12.9) * cos(v_position)"


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analysed(f"o_color = vec4({PAYLOAD}, 1.0);", "")


def test_manifest_twins_name_the_uniforms_of_the_position(analysis: Analysis) -> None:
    manifest = plain(rewritten(analysis, find(analysis, PAYLOAD)).manifest)
    assert manifest["previous"] == {"u_modelViewProjection": "sc_previous_u_modelViewProjection"}
    assert "a_position" in manifest["relies_on"][-1]


VERTEX_CASES = {
    "functions, a changing global and a block": (
        """layout(std140) uniform Camera { mat4 view; mat4 projection; };
        uniform float u_sway;
        uniform mat4 u_unrelated;
        const float HALF = 0.5;
        float amount;
        in vec3 a_position; in vec3 a_normal;
        out vec3 v_position; out vec3 v_normal; out vec2 v_uv;
        vec3 sway(vec3 p) { amount = u_sway * HALF; p.x += amount; return p; }
        void main() {
            vec3 p = sway(a_position);
            v_position = p; v_normal = mat3(u_unrelated) * a_normal; v_uv = p.xy;
            gl_Position = projection * view * vec4(p, 1.0);
            gl_Position.z -= 0.001;
            gl_PointSize = 2.0;
        }""",
        {
            "view": "sc_previous_view",
            "projection": "sc_previous_projection",
            "u_sway": "sc_previous_u_sway",
        },
    ),
    "an early return": (
        """uniform mat4 u_m; uniform bool u_flat; in vec3 a_position;
        out vec3 v_position; out vec3 v_normal; out vec2 v_uv;
        void main() {
            v_position = a_position; v_normal = a_position; v_uv = a_position.xy;
            gl_Position = u_m * vec4(a_position, 1.0);
            if (u_flat) return;
            gl_Position.x *= 2.0;
        }""",
        {"u_m": "sc_previous_u_m", "u_flat": "sc_previous_u_flat"},
    ),
}


@pytest.mark.parametrize("name", VERTEX_CASES)
def test_vertex_twins(name: str, analysis: Analysis) -> None:
    text, twins = VERTEX_CASES[name]
    again = analyse(analysis.fragment, Source("test.vert", "#version 330\n" + text))
    emission = rewritten(again, find(again, PAYLOAD))
    assert twins.items() <= emission.manifest.previous.items()
    assert "u_unrelated" not in emission.manifest.previous
    for item in ("2-pass.hit.vert", "3-pass.payload.vert", "original.vert"):
        validate(parse(Source(item, emission.files[item])), Source(item, ""), "vertex")

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


BLOCK_STAGES = (
    """#version 330
    in Surface { vec3 position; vec3 normal; } s; in Extra { vec3 tone; };
    out vec4 o_color;
    void main() { o_color = vec4(sin(s.position * s.normal) * cos(s.position) * tone, 1.0); }""",
    """#version 330
    uniform mat4 u_m; uniform float u_sway; in vec3 a_position;
    out Surface { vec3 position; vec3 normal; } o; out Extra { vec3 tone; };
    void main() {
        o.position = a_position * u_sway; o.normal = a_position; tone = o.position;
        gl_Position = u_m * vec4(o.position, 1.0);
    }""",
)


def test_interface_blocks_meet_by_their_block_names() -> None:
    """And the previous position's slice writes to a block of its own."""
    fragment, vertex = BLOCK_STAGES
    analysis = analyse(Source("test.frag", fragment), Source("test.vert", vertex))
    node = find(analysis, "sin(s.position * s.normal) * cos(s.position)")
    files = rewritten(analysis, node).files
    original, reuse = files["original.vert"], files["3-pass.reuse.vert"]
    assert "out Surface {" in original and "tone = o.position;" in original
    assert "out Surface {" in reuse and "Extra" not in reuse
    assert "out sc_previous_Surface {" in reuse
    assert "sc_previous_o.position = a_position * sc_previous_u_sway;" in reuse


def test_a_twin_does_not_share_the_place_of_its_original(analysis: Analysis) -> None:
    vertex = """#version 430
        layout(std140, binding = 1) uniform Camera { mat4 view; };
        layout(location = 2) uniform float u_sway;
        in vec3 a_position; out vec3 v_position; out vec3 v_normal; out vec2 v_uv;
        void main() {
            v_position = a_position; v_normal = a_position; v_uv = a_position.xy;
            gl_Position = view * vec4(a_position * u_sway, 1.0);
        }"""
    again = analyse(analysis.fragment, Source("test.vert", vertex))
    text = rewritten(again, find(again, PAYLOAD)).files["3-pass.reuse.vert"]
    assert "layout(std140) uniform sc_previous_Camera {" in text
    assert "\nuniform float sc_previous_u_sway;" in text

"""The independent check of law 8 sees every way in which fragments can part."""

from __future__ import annotations

import pytest

from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.valid.read import read

from .law8 import apart_derivatives

TEXT = """#version 330 core
in vec2 v_uv;
uniform float u_any;
uniform sampler2D u_map;
out vec4 color;
float slope(float x) {{ return dFdx(x); }}
void main() {{
    float x = 0.0;
    bool b = false;
    {body}
    color = vec4(x, float(b), v_uv);
}}
"""

APART = (
    "if (v_uv.x > 0.5) x = dFdx(v_uv.y);",
    "x = v_uv.x > 0.5 ? dFdx(v_uv.y) : 0.0;",
    "x = v_uv.x > 0.5 ? 0.0 : texture(u_map, v_uv).r;",
    "x = v_uv.x > 0.5 ? slope(v_uv.y) : 0.0;",
    "b = v_uv.x > 0.5 && dFdx(v_uv.y) > 0.0;",
    "b = v_uv.x > 0.5 || slope(v_uv.y) > 0.0;",
    "x = 1.0 + (b || v_uv.x > 0.5 ? 1.0 + dFdx(v_uv.y) : 0.0);",
    "if (v_uv.x > 0.5) discard; x = dFdx(v_uv.y);",
    "for (float i = 0.0; i < v_uv.x; i += 0.5) x += dFdx(v_uv.y);",
)

TOGETHER = (
    "x = u_any > 0.5 ? dFdx(v_uv.y) : 0.0;",
    "x = dFdx(v_uv.y) > 0.0 ? 1.0 : 0.0;",
    "b = dFdx(v_uv.y) > 0.0 && v_uv.x > 0.5;",
    "b = u_any > 0.5 && slope(v_uv.y) > 0.0;",
    "x = v_uv.x > 0.5 ? textureLod(u_map, v_uv, 0.0).r : 0.0;",
)


def apart(body: str) -> list[str]:
    text = TEXT.format(body=body)
    module, _ = read(Source("a.frag", text), "fragment", ReadOptions(), needs_main=True)
    return apart_derivatives(module)


@pytest.mark.parametrize("body", APART)
def test_a_derivative_that_some_fragments_leave_out_is_seen(body: str) -> None:
    assert len(apart(body)) == 1


@pytest.mark.parametrize("body", TOGETHER)
def test_a_derivative_that_all_fragments_take_is_not(body: str) -> None:
    assert apart(body) == []

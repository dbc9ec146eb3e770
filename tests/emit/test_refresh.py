"""Refresh schedules and ages in the emitted text: what is chosen, what is refused."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from shaders import analysed, find

from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis, Emission, analyse
from shadercache.diagnostics import InputError
from shadercache.source import Source
from tests.configured import DEFAULT, configured, rewritten

BODY = """
    vec3 albedo = sin(v_position * 12.9) * sin(v_position.yzx * 78.2);
    o_color = vec4(albedo * dot(normalize(v_normal), u_tint), 1.0);
"""
NODE = "sin(v_position * 12.9) * sin(v_position.yzx * 78.2)"


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analysed(BODY)


def emitted(analysis: Analysis, settings: str) -> Emission:
    cache = with_settings(DEFAULT, [settings] if settings else [])
    return rewritten(analysis, find(analysis, NODE), cache, unprofitable=True)


def test_ages_lie_behind_the_payload(analysis: Analysis) -> None:
    emission = emitted(analysis, "age=on")
    manifest = plain(emission.manifest)
    assert manifest["cache"]["second"]["channels"] == {"extras": {"age": "x"}}
    Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(manifest)
    roles = {entry["role"]: entry for entry in manifest["uniforms"]}
    assert roles["period"]["range"] == "[1, 1024], with rgba32f [1, 65536)"


def test_numbers_beside_tucked_offsets_are_small(analysis: Analysis) -> None:
    text = "sin(v_position.x * v_normal.y) * 0.5"
    found = analysed(f"float wave = {text}; o_color = vec4(wave);")
    cache = with_settings(DEFAULT, ["filter=carried,age=on,ids=on"])
    roles = {}
    for form in ("rgba16f", "rgba32f"):
        kept = replace(cache, storage=replace(cache.storage, format=form))
        manifest = plain(rewritten(found, find(found, text), kept, unprofitable=True).manifest)
        assert manifest["cache"]["format"] == "rgba32f"
        roles[form] = {entry["role"]: entry["range"] for entry in manifest["uniforms"]}
    assert roles["rgba16f"]["object"] == "[0, 2048]"
    assert roles["rgba16f"]["period"] == "[1, 1024]"
    assert roles["rgba32f"]["object"] == "[0, 2048], with rgba32f [0, 16777216]"


def test_there_must_be_triangles_to_go_by(analysis: Analysis) -> None:
    text = "#version 330\nout vec4 o; void main() { o = sin(gl_FragCoord * 3.0) * 2.0; }"
    screen = analyse(Source("flat.frag", text), mapping="screen")
    chosen = configured(refresh="surface")
    node = next(node for node in screen.nodes if node.text == "sin(gl_FragCoord * 3.0)")
    with pytest.raises(InputError, match="none but the whole picture"):
        rewritten(screen, node, chosen, unprofitable=True)
    old = Source("old.frag", _es("in vec3 v; out vec4 o; void main() { o.x = sin(v.x); }"))
    vertex = Source(
        "old.vert", _es("in vec3 a; out vec3 v; void main() { gl_Position.xyz = v = a; }")
    )
    mobile = analyse(old, vertex)
    with pytest.raises(InputError, match="GLSL ES"):
        rewritten(mobile, find(mobile, "sin(v.x)"), chosen, unprofitable=True)
    rewritten(mobile, find(mobile, "sin(v.x)"), DEFAULT, unprofitable=True)


def _es(text: str) -> str:
    return f"#version 300 es\nprecision highp float;\n{text}"


def test_ages_need_a_channel() -> None:
    body = """
    mat2 a = mat2(v_position.xy, v_position.yz) * 2.0;
    o_color = vec4(a[0] * a[1], 0.0, 1.0);
"""
    four = analysed(body)
    node = find(four, "mat2(v_position.xy, v_position.yz) * 2.0")
    rewritten(four, node, configured(age=True), unprofitable=True)
    seven = analysed(
        "mat2 a = mat2(v_position.xy, v_position.yz) * 2.0; vec3 b = v_normal * 3.0;"
        "o_color = vec4(a[0] * a[1], b.xy + b.z);"
    )
    nodes = [
        find(seven, text) for text in ("mat2(v_position.xy, v_position.yz) * 2.0", "v_normal * 3.0")
    ]
    with pytest.raises(InputError, match="no channel left for the age"):
        rewritten(seven, nodes, configured(age=True), unprofitable=True)

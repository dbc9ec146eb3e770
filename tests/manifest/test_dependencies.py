"""What a value depends on, by kind and name, and when an engine must reset."""

from __future__ import annotations

from typing import Any

import pytest
from manifests import plain

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.settings import with_settings
from shadercache.compiler import analyse
from shadercache.source import Source
from tests.configured import DEFAULT, rewritten

FRAGMENT = """#version 430
in vec3 v_p;
in vec3 v_world;
in Passed { vec3 normal; vec2 uv; } inside;
uniform vec3 u_eye;
uniform vec3 u_light[2];
uniform sampler2D u_map;
layout(std140) uniform Sky { vec4 zenith; vec4 horizon; };
layout(std140) uniform Fog { float density; } fog;
layout(location = 0) out vec4 o;
float wave(vec3 p) { return sin(p.x * 9.0) * cos(exp(p.y) + sin(p.z * 3.0)); }
void main() {
    float a = wave(v_p);
    float b = wave(v_p * u_eye);
    float c = wave(v_world + u_light[1]);
    float d = wave(inside.normal);
    float e = wave(textureLod(u_map, inside.uv, 0.0).rgb);
    float f = wave(v_p + zenith.rgb);
    float g = wave(v_p * fog.density);
    float h = 0.0;
    if (u_eye.x > 0.0)
        h = wave(v_p.zyx);
    o = vec4(a + b + c + d, e + f, g, wave(v_p + h));
}
"""
VERTEX = """#version 430
in vec3 a_position;
in vec3 a_normal;
in vec2 a_uv;
uniform mat4 u_model;
uniform mat3 u_turn;
layout(std140) uniform Camera { mat4 view; mat4 projection; } camera;
out vec3 v_p;
out vec3 v_world;
out Passed { vec3 normal; vec2 uv; } outside;
void main() {
    v_p = a_position;
    v_world = (u_model * vec4(a_position, 1.0)).xyz;
    outside.normal = u_turn * a_normal;
    outside.uv = a_uv + float(gl_InstanceID);
    gl_Position = camera.projection * camera.view * vec4(v_world, 1.0);
}
"""


def manifest_of(text: str, mapping: MappingKind = "surface", *settings: str) -> dict[str, Any]:
    analysis = analyse(Source("t.frag", FRAGMENT), Source("t.vert", VERTEX), mapping=mapping)
    node = next(node for node in analysis.nodes if node.text == text and node.legal)
    options = with_settings(DEFAULT, settings)
    return plain(rewritten(analysis, node, options, unprofitable=True).manifest)


def told(manifest: dict[str, Any]) -> set[tuple[str, ...]]:
    return {
        (item["kind"], item["name"], *item["stages"], *item.get("members", ()))
        for item in manifest["depends_on"]
    }


POSITION = ("attribute", "a_position", "vertex")
DEPENDS = {
    "wave(v_p)": {POSITION},
    "wave(v_p * u_eye)": {POSITION, ("uniform", "u_eye", "fragment")},
    "wave(v_world + u_light[1])": {
        POSITION,
        ("uniform", "u_model", "vertex"),
        ("uniform", "u_light", "fragment"),
    },
    "wave(v_p + zenith.rgb)": {POSITION, ("uniform block", "Sky", "fragment", "zenith")},
    "wave(v_p * fog.density)": {POSITION, ("uniform block", "Fog", "fragment")},
    "wave(v_p + h)": {POSITION, ("uniform", "u_eye", "fragment")},
}
IN_BLOCK = {
    ("attribute", "a_normal", "vertex"),
    ("attribute", "a_uv", "vertex"),
    ("uniform", "u_turn", "vertex"),
    ("built-in", "gl_InstanceID", "vertex"),
}
"""A block of varyings is one thing: which member is read is not followed."""


@pytest.mark.parametrize("text", DEPENDS)
def test_what_a_value_depends_on_is_told(text: str) -> None:
    assert told(manifest_of(text)) == DEPENDS[text]


def test_through_blocks_of_varyings_with_other_instance_names() -> None:
    assert told(manifest_of("wave(inside.normal)")) == IN_BLOCK
    found = told(manifest_of("wave(textureLod(u_map, inside.uv, 0.0).rgb)"))
    assert found == IN_BLOCK | {("sampler", "u_map", "fragment")}


def test_the_screens_mapping_names_the_same_and_the_position() -> None:
    exact = manifest_of("wave(inside.normal)", "screen")["mapping"]["exact_while_unchanged"]
    assert exact == ["a_normal", "a_position", "a_uv", "camera", "u_model", "u_turn"]


def test_what_decides_the_position_alone_needs_no_reset() -> None:
    manifest = manifest_of("wave(v_p * u_eye)")
    assert "Camera" in manifest["previous"]
    assert all(item["name"] != "Camera" for item in manifest["depends_on"])
    assert manifest["reset"][-1].endswith("what is not in depends_on needs no reset.")


@pytest.mark.parametrize(
    ("mapping", "settings", "age"),
    [
        ("surface", "refresh=stratified", "at most a period old where nothing moves, and may be"),
        ("surface", "age=on", "at most a period old. Where"),
        ("surface", "refresh=none", "as old as a surface has been in view"),
        ("surface", "refresh=none,age=on", "at most a period old. Where"),
        ("screen", "refresh=random", "at most a period old. Where"),
        ("screen", "refresh=none", "as old as a surface has been in view"),
    ],
)
def test_how_old_a_value_may_be_is_told(mapping: MappingKind, settings: str, age: str) -> None:
    assert age in manifest_of("wave(v_p)", mapping, settings)["reset"][-1]

"""What is said of a full-screen triangle and of objects, of resets and of the pipeline's state."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from shaders import analysed, find

from shadercache.analysis.mapping import MappingKind
from shadercache.caching.algorithms import NAMES, PARKED
from shadercache.compiler import analyse
from shadercache.source import Source
from tests.configured import rewritten

FULL_SCREEN = Path(__file__).parent.parent / "laws" / "full_screen"


def of_triangle(mapping: MappingKind) -> dict[str, Any]:
    text = (FULL_SCREEN / "orbit.frag").read_text(encoding="utf-8")
    analysis = analyse(Source("orbit.frag", text), mapping=mapping)
    node = next(node for node in analysis.nodes if node.offered)
    return plain(rewritten(analysis, node).manifest)


def of_objects(algorithms: tuple[str, ...] = NAMES) -> dict[str, Any]:
    analysis = analysed("o_color = vec4(sin(v_position) * cos(v_normal), 1.0);")
    node = find(analysis, "sin(v_position) * cos(v_normal)")
    return plain(rewritten(analysis, node, algorithms=algorithms, unprofitable=True).manifest)


def state(manifest: dict[str, Any]) -> dict[str, str]:
    return {item["state"]: item["must"] for item in manifest["state"]}


@pytest.mark.parametrize("mapping", ["screen", "user"])
def test_a_triangle_is_told_nothing_of_geometry(mapping: MappingKind) -> None:
    manifest = of_triangle(mapping)
    Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(manifest)
    assert "depth_functions" not in manifest
    keys = ("frame", "reset", "relies_on", "debug")
    said = json.dumps([manifest[key] for key in keys]).lower()
    for word in ("perspective", "projection", "application", "geometry, in", "object", "twin"):
        assert word not in said, word
    found = state(manifest)
    assert found["face culling, clip distances and depth bias"] == "off"
    assert found["depth test and writes"] == "on"
    assert "face culling and winding" not in found


def test_objects_are_told_what_all_passes_share() -> None:
    manifest = of_objects()
    found = state(manifest)
    assert set(found.values()) == {"on", "off", "equal"}
    for word in ("culling", "winding", "scissor", "stencil", "polygon mode", "sRGB", "provoking"):
        assert any(word in name and must == "equal" for name, must in found.items()), word
    for word in ("blending", "multisampling"):
        assert any(word in name and must == "off" for name, must in found.items()), word
    assert found["colour mask"] == "on"
    assert "perspective projection" in " ".join(manifest["relies_on"])
    assert "depth_functions" in manifest


def test_the_debug_program_has_a_depth_buffer_of_its_own() -> None:
    debug = of_objects()["debug"]
    assert debug["depth_buffer"] == "own"
    assert (debug["format"], debug["clear"]) == ("r32f", 0)
    assert "in front of the passes" in debug["when"]


def test_the_short_reset_needs_two_passes_beside_others() -> None:
    def told(*algorithms: str) -> bool:
        return "as the one of two passes" in " ".join(of_objects(algorithms)["reset"])

    assert told(*NAMES)
    assert not told("2-pass")
    assert not told("1-pass", "3-pass")


def test_parked_misses_are_told_of_where_there_are_any() -> None:
    def told(*algorithms: str) -> str:
        return " ".join(of_objects(algorithms)["frame"])

    assert "once for each group" in told("2-pass", PARKED)
    assert "marks" not in told("2-pass")


def test_a_reset_finds_nothing() -> None:
    values = {item["role"]: item.get("on_reset") for item in of_objects()["uniforms"]}
    assert values["epsilon"] == -1
    assert values["period"] is None

"""The manifest: its schema, and what is said of one that cannot be used."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from manifests import SCHEMA
from msgspec.structs import replace

from shadercache.compiler import analyse
from shadercache.diagnostics import InputError, UsageError
from shadercache.manifest.model import Manifest
from shadercache.render.bundle import Bundle, bundle_of, load_bundle
from shadercache.source import Source
from tests.configured import bundled, configured
from tests.torus.mesh import EMISSION

Change = Callable[[dict[str, Any]], Any]


@pytest.fixture(scope="module")
def validator() -> Draft202012Validator:
    schema = json.loads(SCHEMA.read_text())
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


@pytest.fixture
def manifest() -> dict[str, Any]:
    found: dict[str, Any] = json.loads((EMISSION / "manifest.json").read_text())
    return found


def test_the_schema_takes_the_fixture(
    validator: Draft202012Validator, manifest: dict[str, Any]
) -> None:
    validator.validate(manifest)
    validator.validate(manifest | {"geometry": manifest["original"]})


BREAKAGES: dict[str, Change] = {
    "version": lambda m: m.update(schema_version=1),
    "unknown key": lambda m: m.update(extra=1),
    "no node": lambda m: m.pop("nodes"),
    "no previous": lambda m: m.pop("previous"),
    "twin": lambda m: m["previous"].update(u_a=3),
    "hash": lambda m: m["source"]["vertex"].update(sha256="abc"),
    "mapping": lambda m: m["mapping"].update(kind="air"),
    "unchanged": lambda m: m["mapping"].update(exact_while_unchanged=["a b"]),
    "nothing to draw": lambda m: m.pop("draw"),
    "geometry": lambda m: m["draw"].update(geometry="sphere"),
    "mode": lambda m: m.update(mode="fast"),
    "format": lambda m: m["cache"].update(format="rgba8"),
    "buffers": lambda m: m["cache"].update(buffers=1),
    "clear": lambda m: m["cache"].update(clear=[0, 0, 0]),
    "role": lambda m: m["uniforms"][0].update(role="magic"),
    "meaning": lambda m: m["uniforms"][0].pop("meaning"),
    "name": lambda m: m["uniforms"][0].update(name="a b"),
    "target": lambda m: m["original"].update(targets=["stencil"]),
    "no target": lambda m: m["original"].update(targets=[]),
    "depth test": lambda m: m["original"]["depth"].update(test="greater"),
    "reads": lambda m: m["variants"][0]["passes"][0].update(reads=["next-cache"]),
    "pass key": lambda m: m["variants"][0]["passes"][0].update(blend=True),
    "no reset pass": lambda m: m["variants"][0]["passes"][0].update(on_reset=False),
    "no passes": lambda m: m["variants"][0].update(passes=[]),
    "no variants": lambda m: m.update(variants=[]),
    "span": lambda m: m["nodes"][0]["span"].update(line=0),
    "mask": lambda m: m["debug"].update(targets=["color"]),
    "mask value": lambda m: m["debug"]["values"].update(hit=0),
    "mask key": lambda m: m["debug"].update(blend=True),
    "frame": lambda m: m.update(frame=[]),
    "refused": lambda m: m.update(refused=[{"algorithm": "1-pass"}]),
}


@pytest.mark.parametrize("name", BREAKAGES)
def test_the_schema_refuses(
    validator: Draft202012Validator, manifest: dict[str, Any], name: str
) -> None:
    BREAKAGES[name](manifest)
    assert not validator.is_valid(manifest)


def test_what_a_bundle_says(bundle: Bundle) -> None:
    assert bundle.algorithms == ("1-pass", "2-pass", "3-pass")
    assert bundle.node("id") == "payload.1-abcdef"
    assert bundle.naming.twins == {"sc_previous_u_modelViewProjection": "u_modelViewProjection"}
    assert bundle.naming.roles["sc_clock"] == "clock"
    assert bundle.naming.defaults["epsilon"] == 0.002
    assert [item.name for item in bundle.passes("3-pass")] == ["reuse", "payload", "shade"]
    assert bundle.passes("3-pass")[2].depth.test == "<="
    assert bundle.geometry.fragment.text.startswith("#version 400 core\n")
    assert isinstance(bundle.manifest, Manifest)
    given = Bundle(replace(bundle.manifest, geometry=bundle.manifest.original), bundle.files)
    assert given.geometry.fragment.name == "original.frag"


def test_bundles_that_cannot_be_used(bundle: Bundle, manifest: dict[str, Any]) -> None:
    with pytest.raises(UsageError, match="SC026"):
        bundle.passes("4-pass")
    with pytest.raises(InputError, match="SC022"):
        _ = Bundle(bundle.manifest, {}).original
    broken = copy.deepcopy(manifest)
    broken["original"]["depth"]["test"] = "greater"
    with pytest.raises(InputError, match=r"original\.depth\.test: .* 'greater' \[SC021"):
        bundle_of(broken, bundle.files, "m")
    broken = copy.deepcopy(manifest)
    del broken["cache"]
    with pytest.raises(InputError, match=r"missing required field 'cache' \[SC021"):
        bundle_of(broken, bundle.files, "m")


def test_other_versions_are_told(manifest: dict[str, Any]) -> None:
    for version in (1, 2, "3", None):
        with pytest.raises(InputError, match=r"m is not of schema_version 3 \[SC021"):
            bundle_of(manifest | {"schema_version": version}, {}, "m")


WIDTHS = """#version 330
in vec3 v_p;
out vec4 color;
float one(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + exp(sin(p.z)) + cos(p.x * 9.0); }
vec2 two(vec3 p) { return vec2(one(p), one(p.yzx)); }
void main() { color = vec4(one(v_p), two(v_p * 2.0), 1.0); }
"""
VERTEX = """#version 330
in vec3 a_position;
out vec3 v_p;
uniform mat4 u_mvp;
void main() { v_p = a_position; gl_Position = u_mvp * vec4(a_position, 1.0); }
"""


@pytest.mark.parametrize(("setting", "alike"), [({"ids": True}, False), ({}, True)])
def test_caches_are_the_same_where_everything_lies_at_the_same_place(
    setting: dict[str, bool], alike: bool
) -> None:
    """Numbers of objects lie behind payloads, so those of another width are elsewhere."""
    analysis = analyse(Source("a.frag", WIDTHS), Source("a.vert", VERTEX))
    by_text = {node.text: node for node in analysis.nodes if node.path == "main"}
    caches = [
        bundled(analysis, by_text[text], configured(**setting)).cache
        for text in ("one(v_p)", "two(v_p * 2.0)")
    ]
    assert caches[0].formats == caches[1].formats
    assert (caches[0] == caches[1]) is alike


def test_folders_that_hold_no_manifest(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="SC020"):
        load_bundle(tmp_path)
    (tmp_path / "manifest.json").write_text("{")
    with pytest.raises(InputError, match="SC020"):
        load_bundle(tmp_path)
    (tmp_path / "manifest.json").write_text('{"schema_version": 7}')
    with pytest.raises(InputError, match="SC021"):
        load_bundle(tmp_path)

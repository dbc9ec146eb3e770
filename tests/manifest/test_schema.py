"""The published schema is the model's, and rules between fields have a check of their own."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from shaders import analysed, find

from shadercache.diagnostics import InputError
from shadercache.manifest.codec import decode, encode, schema
from tests.configured import rewritten
from tests.conftest import Golden

Change = Callable[[dict[str, Any]], Any]


@pytest.fixture(scope="module")
def text() -> str:
    analysis = analysed("o_color = vec4(sin(v_position) * cos(v_normal), 1.0);")
    node = find(analysis, "sin(v_position) * cos(v_normal)")
    return encode(rewritten(analysis, node, unprofitable=True).manifest)


def test_the_published_schema_is_the_models(golden: Golden) -> None:
    golden("shadercache/manifest.schema.json", json.dumps(schema(), indent=1) + "\n")
    assert SCHEMA.exists()


def test_what_is_written_is_read_as_it_was(text: str) -> None:
    assert encode(decode(json.loads(text), "m")) == text


BETWEEN: dict[str, tuple[Change, str]] = {
    "a target twice": (
        lambda m: m["variants"][0]["passes"][0].update(targets=["color", "cache", "cache"]),
        "variants[0].passes[0].targets: cache stands there twice",
    ),
    "a uniform twice": (
        lambda m: m["original"]["uniforms"].append(m["original"]["uniforms"][0]),
        "original.uniforms: u_modelViewProjection stands there twice",
    ),
    "an unknown uniform": (
        lambda m: m["payload"]["uniforms"].append("u_nowhere"),
        "payload.uniforms: nothing else tells of u_nowhere",
    ),
    "an unknown attribute": (
        lambda m: m["payload"]["attributes"].append("u_modelViewProjection"),
        "payload.attributes: nothing else tells of u_modelViewProjection",
    ),
    "attributes on the screen": (
        lambda m: m["original"].update(draws="screen"),
        "original.attributes: a pass over the screen has none",
    ),
    "an unknown target": (
        lambda m: m["targets"].pop("cache"),
        "variants[0].passes[0].targets: nothing else tells of cache",
    ),
    "no second texture": (
        lambda m: m["variants"][2]["passes"][2].update(reads=["current-cache-2"]),
        "variants[2].passes[2].reads: current-cache-2 is in no manifest without cache.second",
    ),
    "no pass of a reset": (
        lambda m: m["variants"][0]["passes"][0].update(on_reset=False),
        "variants[0].passes: a reset draws none of them",
    ),
    "a node nowhere": (
        lambda m: m["nodes"][0].update(channels={}),
        "nodes[0].channels: it lies in none",
    ),
    "an outcome": (lambda m: m["debug"]["values"].pop("depth"), "debug.values: lacks 'depth'"),
    "two inputs of a name": (
        lambda m: m["inputs"].append(m["inputs"][0]),
        "inputs: a_position stands there twice",
    ),
    "a stage twice": (
        lambda m: m["inputs"][0]["stages"].append("vertex"),
        "inputs[0].stages: vertex stands there twice",
    ),
    "a twin of nothing": (
        lambda m: m.update(previous={}),
        "'previous' does not lead from u_modelViewProjection to it",
    ),
    "a block without offsets": (
        lambda m: m["inputs"].append(
            {
                **{"kind": "uniform block", "name": "B", "instance": None, "dims": []},
                **{"stages": ["vertex"], "packing": "std140", "matrices": "column_major"},
                **{"binding": None, "members": [{"name": "m", "type": "mat4"}]},
            }
        ),
        "a std140 block has a size, and offsets of its members",
    ),
}


def complaint(text: str, change: Change) -> str:
    """What is wrong with a manifest that was changed."""
    broken = json.loads(text)
    change(broken)
    with pytest.raises(InputError) as caught:
        decode(broken, "m")
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "SC021"
    return diagnostic.message


@pytest.mark.parametrize("name", BETWEEN)
def test_rules_between_fields_are_held(text: str, name: str) -> None:
    change, words = BETWEEN[name]
    assert words in complaint(text, change)


WRONG: dict[str, tuple[Change, str]] = {
    "deep inside": (
        lambda m: m["variants"][1]["passes"][0]["depth"].update(write="yes"),
        "variants[1].passes[0].depth.write: expected 'bool', got 'str'",
    ),
    "a key": (lambda m: m["previous"].update({"a b": "c"}), "a key of previous: expected"),
    "an unknown key": (lambda m: m.update(extra=1), "object contains unknown field 'extra'"),
    "a very long word": (lambda m: m.update(mode="x" * 9_000), "mode: invalid enum value 'xxx"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_told_with_its_path(text: str, name: str) -> None:
    change, words = WRONG[name]
    message = complaint(text, change)
    assert words in message and len(message) < 300


def test_the_schema_takes_what_is_written(text: str) -> None:
    Draft202012Validator(schema()).validate(json.loads(text))
    assert json.loads(text) == plain(decode(json.loads(text), "m"))

"""Layouts of payloads, and the programs of every type."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from conftest import Golden
from emit.test_programs import check_programs
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from payloads import DESKTOP, ES, PAYLOADS, analysed_payload
from shaders import analysed, find

from shadercache.analysis.candidates import Candidate
from shadercache.caching.configuration import Mode
from shadercache.caching.layout import Extra, Layout
from shadercache.caching.payload_text import payload_text
from shadercache.compiler import Analysis
from shadercache.lang.types import (
    BOOL,
    FLOAT,
    INT,
    UINT,
    array_of,
    matrix,
    struct_type,
    vector,
)
from tests.configured import PROOF, configured, rewritten
from tests.glslang import needs_glslang, objections

RAY = struct_type("Ray", {"origin": vector("float", 3), "id": INT})
FLAGGED = struct_type("Flagged", {"ray": RAY, "flags": vector("bool", 2), "count": UINT})

MIXED = struct_type("Mixed", {"at": vector("float", 2), "id": INT, "more": FLOAT, "on": BOOL})

ID, AGE = Extra("id", INT, "object"), Extra("age", FLOAT, "age")

LAYOUTS = [
    Layout((FLOAT,)),
    Layout((vector("float", 3),)),
    Layout((vector("float", 4),)),
    Layout((INT,)),
    Layout((vector("uint", 2),)),
    Layout((BOOL,)),
    Layout((vector("bool", 4),)),
    Layout((matrix("float", 2, 3),)),
    Layout((array_of(vector("float", 2), 2),)),
    Layout((FLAGGED,)),
    Layout((MIXED,)),
    Layout((vector("float", 2), BOOL, vector("int", 3))),
    Layout((vector("float", 2), vector("float", 4))),
    Layout((vector("float", 2),), extras=(ID, AGE)),
    Layout((INT,), extras=(ID, AGE)),
    Layout((vector("float", 3),), extras=(ID,)),
]


def test_golden_layouts(golden: Golden) -> None:
    """How payloads lie in one or two texels, are packed and unpacked, and what must not be blended
    of them."""
    parts: list[str] = []
    for layout in LAYOUTS:
        kept = ", ".join([*map(str, layout.types), *(extra.name for extra in layout.extras)])
        text = payload_text(layout, "sc_", False, ("-1.0", "-2.0", "-3.0"))
        parts.append(f"// {kept}: {', '.join(layout.formats('rgba16f'))}\n{text}")
    golden("tests/emit/goldens/layouts.glsl", "\n".join(parts))


def test_golden_layout_of_payloads_that_may_be_missing(golden: Golden) -> None:
    layout = Layout((vector("float", 2), BOOL, vector("int", 3)), precisions=("highp",) * 3)
    golden("tests/emit/goldens/missing.glsl", payload_text(layout, "sc_", True, ("0u", "1u", "2u")))


def test_only_what_is_whole_is_not_blended() -> None:
    assert not Layout((FLAGGED,)).has_integers(0)


@pytest.mark.parametrize("name", PAYLOADS)
@pytest.mark.slow
def test_every_program_is_valid_and_holds_nothing_unused(name: str) -> None:
    validator = Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8")))
    analysis, node = analysed_payload(name)
    modes: tuple[Mode, ...] = ("plain", "proof")
    for mode in modes:
        emission = rewritten(analysis, node, configured(mode=mode), unprofitable=True)
        check_programs(emission)
        manifest = plain(emission.manifest)
        validator.validate(manifest)
        for variant in manifest["variants"]:
            for item in variant["passes"]:
                layers = {name for name in item["targets"] if name.startswith("cache")}
                wanted = {"cache", "cache-2"} if Layout((node.type,)).second else {"cache"}
                assert layers in (wanted, set())


@pytest.mark.parametrize("name", ["vec4", "Mixed"])
def test_golden_programs(name: str, golden: Golden) -> None:
    emission = rewritten(*analysed_payload(name), unprofitable=True)
    for file in ("1-pass.frag", "3-pass.payload.frag", "3-pass.shade.frag", "payload-alone.frag"):
        golden(f"tests/emit/goldens/{name}/{file}", emission.files[file])
    manifest = plain(emission.manifest)
    parts = {key: manifest[key] for key in ("cache", "uniforms", "variants", "frame")}
    golden(f"tests/emit/goldens/{name}/manifest.json", json.dumps(parts, indent=2) + "\n")


def test_several_payloads_lie_one_behind_the_other() -> None:
    layout = Layout((vector("float", 2), BOOL, vector("int", 3)))
    assert layout.places == (("xy", ""), ("z", ""), ("", "xyz"))
    wide = Layout((vector("float", 2), vector("float", 4)))
    assert wide.places == (("xy", ""), ("z", "xyz"))


def beside(analysis: Analysis, node: Candidate) -> list[Candidate]:
    """Another node that goes into one cache with this one, if there is room for it."""
    light = find(analysis, "normalize(v_normal).z")
    return [light] if Layout((node.type, light.type)).used <= 7 else []


@needs_glslang
@pytest.mark.parametrize("head", [DESKTOP, ES], ids=["330", "es"])
@pytest.mark.slow
def test_glslang_accepts_every_program_without_a_warning(head: str, tmp_path: Path) -> None:
    texts: list[tuple[str, str]] = []
    modes: tuple[Mode, ...] = ("plain", "proof")
    for number, name in enumerate(PAYLOADS):
        for mode in modes:
            analysis, node = analysed_payload(name, head)
            nodes = [node, *beside(analysis, node)] if number % 2 else [node]
            emission = rewritten(analysis, nodes, configured(mode=mode), unprofitable=True)
            texts += emission.files.items()
    assert not objections(texts, tmp_path)


def test_golden_precisions(golden: Golden) -> None:
    """A payload is as precise as its expression."""
    lines: list[str] = []
    for name in ("ivec3", "vec4", "bvec3", "Mixed"):
        text = rewritten(*analysed_payload(name, ES), unprofitable=True).files["3-pass.shade.frag"]
        lines += re.findall(r"^(\S.* sc_payload;)$", text, re.MULTILINE)
    golden("tests/emit/goldens/precisions.glsl", "\n".join(lines) + "\n")


def test_a_constant_of_the_users_may_have_the_name_of_a_parameter_of_the_look_up() -> None:
    """Proof mode hides the zeros of constant matrices, by name."""
    text = "sin(v_position.x) * cos(v_position.y) * exp(v_uv.x) > 0.1"
    body = f"bool k = {text}; o_color = vec4(k) + (c * mat2(v_uv, v_uv))[0].x;"
    analysis = analysed(body, "const mat2 c = mat2(1.0);")
    files = rewritten(analysis, find(analysis, text), PROOF, unprofitable=True).files
    assert "uintBitsToFloat(c)" in files["hit-mask.frag"]

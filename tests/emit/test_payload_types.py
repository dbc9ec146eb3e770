"""Layouts of payloads, and the programs of every type."""

from __future__ import annotations

import json
import shutil
import subprocess
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
from shadercache.caching.layout import Layout
from shadercache.caching.payload_text import payload_text
from shadercache.compiler import Analysis
from shadercache.lang.types import (
    BOOL,
    FLOAT,
    INT,
    UINT,
    Type,
    array_of,
    matrix,
    struct_type,
    vector,
)
from tests.configured import configured, rewritten

RAY = struct_type("Ray", {"origin": vector("float", 3), "id": INT})
FLAGGED = struct_type("Flagged", {"ray": RAY, "flags": vector("bool", 2), "count": UINT})

LAYOUTS = [
    (FLOAT, ("rgba16f",), "sc_payload, 0.0, 0.0", "0.0, 0.0, 0.0, 0.0", "sc_texel.x"),
    (vector("float", 3), ("rgba16f",), "sc_payload", "0.0, 0.0, 0.0, 0.0", "sc_texel.xyz"),
    (
        vector("float", 4),
        ("rgba16f", "r16f"),
        "sc_payload.xyz",
        "sc_payload.w, 0.0, 0.0, 0.0",
        "vec4(sc_texel.xyz, sc_texel_2.x)",
    ),
    (INT, ("rgba32ui",), "uint(sc_payload), 0u, 0u", "0u, 0u, 0u, 0u", "int(sc_texel.x)"),
    (vector("uint", 2), ("rgba32ui",), "sc_payload, 0u", "0u, 0u, 0u, 0u", "sc_texel.xy"),
    (BOOL, ("rgba32ui",), "uint(sc_payload), 0u, 0u", "0u, 0u, 0u, 0u", "bool(sc_texel.x)"),
    (
        vector("bool", 4),
        ("rgba32ui", "r32ui"),
        "uvec3(sc_payload.xyz)",
        "uint(sc_payload.w), 0u, 0u, 0u",
        "bvec4(sc_texel.xyz, sc_texel_2.x)",
    ),
    (
        matrix("float", 2, 3),
        ("rgba16f", "rgba16f"),
        "sc_payload[0]",
        "sc_payload[1], 0.0",
        "mat2x3(sc_texel.xyz, sc_texel_2.xyz)",
    ),
    (
        array_of(vector("float", 2), 2),
        ("rgba16f", "r16f"),
        "sc_payload[0], sc_payload[1].x",
        "sc_payload[1].y, 0.0, 0.0, 0.0",
        "vec2[2](sc_texel.xy, vec2(sc_texel.z, sc_texel_2.x))",
    ),
    (
        FLAGGED,
        ("rgba32ui", "rgba32ui"),
        "floatBitsToUint(sc_payload.ray.origin)",
        "uint(sc_payload.ray.id), uvec2(sc_payload.flags), sc_payload.count",
        "Flagged(Ray(uintBitsToFloat(sc_texel.xyz), int(sc_texel_2.x)), bvec2(sc_texel_2.yz), "
        "sc_texel_2.w)",
    ),
]


def written(layout: Layout, whole: bool = False) -> str:
    return payload_text(layout, "sc_", whole, ("0u", "1u"))


def texel_type(layout: Layout) -> str:
    return "uvec4" if layout.bits else "vec4"


@pytest.mark.parametrize(
    ("kind", "formats", "first", "second", "unpacked"), LAYOUTS, ids=[str(c[0]) for c in LAYOUTS]
)
def test_layout(
    kind: Type, formats: tuple[str, ...], first: str, second: str, unpacked: str
) -> None:
    layout = Layout((kind,))
    text = written(layout)
    assert layout.formats("rgba16f") == formats
    assert f"sc_PACKED() {{ return {texel_type(layout)}({first}, 0); }}" in text
    assert f"sc_PACKED_2() {{ return {texel_type(layout)}({second}); }}" in text
    assert f"void sc_UNPACK() {{ sc_payload = {unpacked}; }}" in text


def test_the_masks_mark_what_must_not_be_blended() -> None:
    mixed = struct_type("Mixed", {"at": vector("float", 2), "id": INT, "more": FLOAT, "on": BOOL})
    text = written(Layout((mixed,)))
    assert "const uvec4 sc_discrete = uvec4(0u, 0u, 0xFFFFFFFFu, 0u);" in text
    assert "const uvec4 sc_discrete_2 = uvec4(0u, 0xFFFFFFFFu, 0u, 0u);" in text
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
    layout = Layout((vector("float", 2), BOOL, vector("int", 3)), precisions=("highp",) * 3)
    text = written(layout, whole=True)
    assert layout.places == (("xy", ""), ("z", ""), ("", "xyz"))
    assert layout.formats("rgba16f") == ("rgba32ui", "rgba32ui")
    assert "highp vec2 sc_payload_1;\nbool sc_payload_2;\nhighp ivec3 sc_payload_3;" in text
    assert (
        "sc_PACKED() { return uvec4(sc_valid_1 ? floatBitsToUint(sc_payload_1) : uvec2(0u), "
        "sc_valid_2 ? uint(sc_payload_2) : 0u, 0); }"
    ) in text
    assert (
        "sc_payload_1 = uintBitsToFloat(sc_texel.xy); sc_payload_2 = bool(sc_texel.z); "
        "sc_payload_3 = ivec3(sc_texel_2.xyz);"
    ) in text
    assert "sc_VALID() { return sc_valid_1 && sc_valid_2 && sc_valid_3; }" in text
    assert "return uvec4(uvec3(sc_payload_3), 0u);" in written(Layout(layout.types))
    wide = Layout((vector("float", 2), vector("float", 4)))
    assert wide.places == (("xy", ""), ("z", "xyz"))
    assert "sc_PACKED() { return vec4(sc_payload_1, sc_payload_2.x, 0); }" in written(wide)


def beside(analysis: Analysis, node: Candidate) -> list[Candidate]:
    """Another node that goes into one cache with this one, if there is room for it."""
    light = find(analysis, "normalize(v_normal).z")
    return [light] if Layout((node.type, light.type)).used <= 7 else []


@pytest.mark.skipif(shutil.which("glslangValidator") is None, reason="needs glslang-tools")
@pytest.mark.parametrize("head", [DESKTOP, ES], ids=["330", "es"])
@pytest.mark.slow
def test_glslang_accepts_every_program_without_a_warning(head: str, tmp_path: Path) -> None:
    files: list[str] = []
    modes: tuple[Mode, ...] = ("plain", "proof")
    for number, name in enumerate(PAYLOADS):
        for mode in modes:
            analysis, node = analysed_payload(name, head)
            nodes = [node, *beside(analysis, node)] if number % 2 else [node]
            emission = rewritten(analysis, nodes, configured(mode=mode), unprofitable=True)
            for file, text in emission.files.items():
                path = tmp_path / f"{number}-{mode}-{file}"
                path.write_text(text)
                files.append(str(path))
    done = subprocess.run(["glslangValidator", *files], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert "WARNING" not in done.stdout


def test_a_payload_is_as_precise_as_its_expression() -> None:
    for name, declared in (
        ("ivec3", "mediump ivec3 sc_payload;"),
        ("vec4", "mediump vec4 sc_payload;"),
        ("bvec3", "bvec3 sc_payload;"),
        ("Mixed", "Mixed sc_payload;"),
    ):
        text = rewritten(*analysed_payload(name, ES), unprofitable=True).files["3-pass.shade.frag"]
        assert f"\n{declared}" in text


def test_a_struct_stands_before_the_variable() -> None:
    """And what the struct needs stands before it, as the user has it."""
    analysis = analysed(
        "Many m = make(v_position); o_color = vec4(m.values[0], m.values[1], 0.0, 1.0);",
        "const int COUNT = 2; struct Many { float values[COUNT]; };"
        "Many make(vec3 p) { Many m; m.values[0] = sin(p.x); m.values[1] = sin(p.y); return m; }",
    )
    emission = rewritten(analysis, find(analysis, "make(v_position)"), unprofitable=True)
    check_programs(emission)
    text = emission.files["3-pass.shade.frag"]
    places = [text.index(words) for words in ("COUNT = 2", "struct Many", "Many sc_payload;")]
    assert places == sorted(places)


def test_names_of_structs_and_fields_do_not_collide_with_ours() -> None:
    """Not with the runtime's local variables, nor with its words in capitals."""
    analysis = analysed(
        "outcome m = make(v_position); o_color = vec4(m.t.DEPTH, m.sc_TEXEL, 0.0, 1.0)"
        "+ texture(u_map, v_uv);",
        "struct texel { float DEPTH; }; struct outcome { texel t; float sc_TEXEL; int STORE; };"
        "outcome make(vec3 p) { return outcome(texel(sin(p.x)), sin(p.y), 1); }",
    )
    emission = rewritten(analysis, find(analysis, "make(v_position)"), unprofitable=True)
    check_programs(emission)
    text = emission.files["2-pass.hit.frag"]
    assert "outcome(texel(uintBitsToFloat(sc1_texel.x))" in text
    assert text.index("discard;") > text.index("sc1_shade();"), "the variant with most locals"

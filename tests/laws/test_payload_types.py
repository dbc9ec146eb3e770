"""Laws 2 to 4 for a payload of every type: the bits that are stored are the bits that come back."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from harness.test_independent import agree
from laws.ground_truth import VERTEX, body_mesh, body_scene
from laws.test_mutations import Replace, broken

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse, rewrite
from shadercache.harness.bundle import Bundle, load_bundle
from shadercache.harness.context import Gpu
from shadercache.harness.runner import RunOptions, VariantRunner
from shadercache.harness.stage import Stage
from shadercache.harness.verify import Verifier
from shadercache.options import Options
from shadercache.source import Source

pytestmark = pytest.mark.xdist_group("payload-types")

ALL = ("1-pass", "2-pass", "3-pass")
HIT = "2-pass.hit.frag"

PAYLOADS = {
    # As floats these are a signalling NaN, infinity and two denormal numbers.
    "bits": (
        "uvec4(0x7F800001u, 0x7F800000u, 1u, 2u) << uint(wave.x > 0.0)",
        "vec3(it.x == 0xFF000002u, it.z == 2u, it.w == 4u)",
    ),
    "float": ("wave.x", "vec3(it)"),
    "vec2": ("wave.xy", "it.xyx"),
    "vec3": ("wave.xyz", "it"),
    "vec4": ("wave * wave.yzwx", "it.xyz * it.w"),
    "int": ("int(9.0 * wave.x)", "vec3(it) / 9.0"),
    "uint": ("floatBitsToUint(wave.x) >> 20", "vec3(it & 1023u) / 1024.0"),
    "ivec2": ("ivec2(5.0 * wave.xy)", "vec3(it, it.x - it.y) / 5.0"),
    "ivec3": ("ivec3(5.0 * wave.xyz)", "vec3(it) / 5.0"),
    "ivec4": ("ivec4(3.0 * wave)", "vec3(it.xyz + it.w) / 5.0"),
    "uvec2": ("uvec2(3.0 + 3.0 * wave.xy)", "vec3(it.xyx) / 6.0"),
    "uvec3": ("uvec3(3.0 + 3.0 * wave.xyz)", "vec3(it) / 6.0"),
    "uvec4": ("uvec4(3.0 + 3.0 * wave)", "vec3(it.xyz * it.w) / 36.0"),
    "bool": ("wave.x * wave.y > 0.0", "(it ? vec3(1.0, 0.5, 0.2) : vec3(0.1))"),
    "bvec2": ("greaterThan(wave.xy, wave.yz)", "vec3(it, it.x != it.y)"),
    "bvec3": ("greaterThan(wave.xyz, wave.yzx)", "vec3(it)"),
    "bvec4": ("greaterThan(wave, vec4(0.1))", "vec3(it.xyz) * (it.w ? 1.0 : 0.5)"),
    "mat2": ("outerProduct(wave.xy, wave.zw)", "vec3(it * wave.xy, it[1][0])"),
    "mat2x3": ("outerProduct(wave.xyz, wave.xy)", "it * wave.xy"),
    "mat3x2": ("outerProduct(wave.xy, wave.xyz)", "wave.xy * it"),
    "Pair": ("Pair(wave.xy, wave.z)", "vec3(it.a, it.b)"),
    "Whole": ("Whole(wave.xyz, wave)", "it.a + it.b.xyz * it.b.w"),
    "Mixed": (
        "Mixed(Pair(wave.xy, wave.z), wave.x > 0.3, ivec2(2.0 * wave.yz), uint(3.0 + wave.x))",
        "vec3(it.pair.a, it.pair.b) * (it.sign ? 1.0 : 0.4) + vec3(it.cell, it.number) / 20.0",
    ),
    "float[5]": (
        "float[5](wave.x, wave.y, wave.z, wave.w, wave.x * wave.y)",
        "vec3(it[0] + it[3], it[1] + it[4], it[2])",
    ),
}

FRAGMENT = """#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
struct Pair { vec2 a; float b; };
struct Whole { vec3 a; vec4 b; };
struct Mixed { Pair pair; bool sign; ivec2 cell; uint number; };
void main() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    TYPE it = VALUE;
    o_color = vec4(0.5 + 0.5 * (USE) * normalize(v_normal).z, 1.0);
}
"""


def analysed(name: str) -> tuple[Analysis, Candidate]:
    """The shader whose payload is of a type, and its node."""
    value, use = PAYLOADS[name]
    kind = "uvec4" if name == "bits" else name
    text = FRAGMENT.replace("TYPE", kind).replace("VALUE", value).replace("USE", use)
    analysis = analyse(Source("typed.frag", text), Source("typed.vert", VERTEX))
    node = next(node for node in analysis.nodes if node.text == value)
    assert str(node.type) == kind
    return analysis, node


@pytest.fixture(scope="module", params=list(PAYLOADS))
def case(gpu: Gpu, request: pytest.FixtureRequest) -> Iterator[tuple[Verifier, Candidate]]:
    """The trash can's shape, turning fast, under a shader with such a payload."""
    analysis, node = analysed(request.param)
    scene, mesh = body_scene("trashcan", 3.0), body_mesh("trashcan")
    with closing(Verifier(gpu, scene, analysis, mesh=mesh)) as made:
        yield made, node


def proof_of(verifier: Verifier, node: Candidate) -> Bundle:
    emission = rewrite(verifier.analysis, node, Options("proof", "rgba32f"), unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def test_laws_2_to_4(case: tuple[Verifier, Candidate]) -> None:
    verifier, node = case
    verdict = verifier.check(node)
    assert verdict.broken == [], verdict.failure
    assert set(verdict.always) == set(ALL)
    assert max(item.maximum for item in verdict.plain.values()) < 1e-2


def test_payloads_are_reused_in_motion(case: tuple[Verifier, Candidate]) -> None:
    """Else the laws would hold because everything is computed anew."""
    verifier, node = case
    bundle = proof_of(verifier, node)
    with VariantRunner(verifier.stage, bundle, "2-pass", RunOptions(period=64)) as runner:
        for frame in range(3):
            runner.draw(frame)
        mask = runner.hit_mask(3)
    share = (mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum()
    assert share > 0.5, f"{share:.3f} of the pixels are hits"


def test_a_store_that_loses_the_payload_is_noticed(case: tuple[Verifier, Candidate]) -> None:
    verifier, node = case
    bundle = proof_of(verifier, node)
    store, zero = "sc_store = sc_texel();", "u" if "usampler" in bundle.files[HIT] else ""
    lost = {store: f"{store} sc_store.xyz = {zero}vec3(0);"}
    if "sc_store_2" in bundle.files[HIT]:
        lost["sc_store_2 = sc_texel_2();"] = f"sc_store_2 = {zero}vec4(0);"
    for old, new in lost.items():
        mutation = Replace(old, new, "2-pass.miss")
        assert "law 3 (2-pass)" in broken(verifier, mutation.bundle(bundle)), old


@pytest.mark.parametrize("name", ["vec4", "bits", "Mixed"])
def test_an_engine_needs_only_the_manifest(gpu: Gpu, tmp_path: Path, name: str) -> None:
    analysis, node = analysed(name)
    emission = rewrite(analysis, node, unprofitable=True)
    for file, text in emission.files.items():
        (tmp_path / file).write_text(text)
    (tmp_path / "manifest.json").write_text(json.dumps(emission.manifest))
    with Stage(
        gpu, body_scene("trashcan", 3.0), (96, 96), "rgba32f", body_mesh("trashcan")
    ) as stage:
        for algorithm in ALL:
            assert agree(stage, load_bundle(tmp_path), tmp_path, algorithm, None)

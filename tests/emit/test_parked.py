"""Parked misses: that each program holds only what it needs, and where they are refused."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from emit.test_programs import BODY, NODES, NOISE, check_programs, module_of
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from shaders import INTERFACE, analysed, find

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.outputs import MOST_TARGETS
from shadercache.caching.algorithms import algorithm
from shadercache.caching.configuration import Mode
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.source import Source
from tests.configured import configured, rewritten
from tests.glslang import needs_glslang, objections

MODES: tuple[Mode, ...] = ("plain", "proof")
BOTH = ("2-pass", "parked")


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analysed(BODY, NOISE)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("text", NODES.values(), ids=NODES)
def test_every_program_is_valid_and_holds_nothing_unused(
    text: str, mode: Mode, analysis: Analysis
) -> None:
    options = configured(mode=mode)
    emission = rewritten(analysis, find(analysis, text), options, ("parked",), unprofitable=True)
    check_programs(emission)
    # Of the screen pass's neighbours some are other objects' misses (law 8).
    table = EffectTable(module_of(emission, "parked.fix-up.frag"))
    assert not table.summary("main").does & (Does.DERIVATIVE | Does.IMPLICIT_LOD)
    manifest = plain(emission.manifest)
    Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(manifest)


@needs_glslang
def test_glslang_accepts_every_program_without_a_warning(
    analysis: Analysis, tmp_path_factory: pytest.TempPathFactory
) -> None:
    for mode in MODES:
        for text in NODES.values():
            node, options = find(analysis, text), configured(mode=mode)
            files = rewritten(analysis, node, options, ("parked",), unprofitable=True).files
            assert not objections(files.items(), tmp_path_factory.mktemp("programs"))


def test_the_manifest_says_how_it_is_drawn(analysis: Analysis) -> None:
    node = find(analysis, NODES["two-octaves"])
    manifest = plain(rewritten(analysis, node, algorithms=("parked",)).manifest)
    find_, mark, fix_up = manifest["variants"][0]["passes"]
    parked = [name for name in manifest["targets"] if name.startswith("parked")]
    assert [manifest["targets"][name]["format"] for name in parked] == [
        *["rgba32ui"] * 3,
        "rg32ui",
    ]
    assert find_["targets"] == ["color", "cache", *parked]
    assert [mark["targets"], mark["reads"], mark["draws"]] == [[], ["current-cache"], "screen"]
    assert mark["depth"] == {"test": "always", "write": True, "buffer": "marks"}
    assert [fix_up["targets"], fix_up["reads"]] == [["color", "cache"], parked]
    assert fix_up["depth"] == {"test": "equal", "write": False, "buffer": "marks"}
    assert fix_up["draws"] == "groups" and not fix_up["attributes"]
    # No pass reads what it writes.
    for entry in (find_, mark, fix_up):
        written = {name.replace("cache", "current-cache") for name in entry["targets"]}
        assert written.isdisjoint(entry["reads"])
    roles = {item["role"]: item for item in manifest["uniforms"]}
    assert roles["group"]["type"] == "int" and roles["parked-1"]["type"] == "usampler2D"


def test_only_by_name(analysis: Analysis) -> None:
    node = find(analysis, NODES["two-octaves"])
    manifest = plain(rewritten(analysis, node).manifest)
    assert "parked" not in [item["algorithm"] for item in manifest["variants"]]
    assert not any(name.startswith("parked") for name in manifest["targets"])
    assert not algorithm("parked").usual


NODE = "sin(v_position * v_position.yzx)"


def refusal(body: str, declarations: str = "", **options: str) -> str:
    found = analysed(f"vec3 waves = {NODE}; {body}", declarations)
    return reason_of(found, **options)


def reason_of(found: Analysis, **options: str) -> str:
    manifest = plain(
        rewritten(found, find(found, NODE), configured(**options), BOTH, unprofitable=True).manifest
    )
    assert [item["algorithm"] for item in manifest["variants"]] == ["2-pass"]
    [refused] = manifest["refused"]
    assert refused["algorithm"] == "parked"
    return str(refused["reason"])


def fetches(count: int, swizzle: str = "") -> str:
    """The product of a payload and the sum of as many texture fetches."""
    texts = (f"texture(u_map, v_uv * {k}.0){swizzle}" for k in range(2, count + 2))
    return f"o_color = vec4(waves, 1.0) * ({' + '.join(texts)});"


END = "o_color = vec4(waves, 1.0);"
DERIVATIVE = "at a place from which that cannot be moved ahead"


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ("if (v_uv.x > 0.5) waves *= texture(u_map, v_uv).rgb; " + END, DERIVATIVE),
        ("if (v_uv.x > 0.5) waves *= dFdx(v_normal); " + END, DERIVATIVE),
        ("if (v_uv.x > 0.5) waves *= textureLod(u_sky, v_normal, 0.0).rgb; " + END, DERIVATIVE),
        (fetches(7), "numbers, and 6 targets beside colour and cache hold 24"),
        (fetches(28, ".x"), "levels of detail of 28 texture fetches"),
    ],
    ids=["fetch", "derivative", "cube map", "numbers", "fetches"],
)
def test_refused_with_a_reason(body: str, told: str) -> None:
    assert told in refusal(body, "uniform samplerCube u_sky;")


def test_a_level_for_a_fetch_takes_less_room() -> None:
    found = analysed(f"vec3 waves = {NODE}; {fetches(7)}")
    options = configured(fetches="level")
    emission = rewritten(found, find(found, NODE), options, ("parked",), unprofitable=True)
    check_programs(emission)
    assert "#version 400" in emission.files["parked.find.frag"]
    parked = [name for name in emission.manifest.targets if name.startswith("parked")]
    assert 0 < len(parked) <= MOST_TARGETS - 2


def test_inputs_at_another_place_are_refused() -> None:
    version = INTERFACE.replace("330", "400")
    body = f"vec3 waves = {NODE}; o_color = vec4(waves * interpolateAtCentroid(v_normal), 1.0);"
    fragment = Source("test.frag", f"{version}\nvoid main() {{ {body} }}\n")
    found = analyse(fragment, Source("test.vert", VERTEX_400))
    assert "inputs at another place (interpolateAtCentroid)" in reason_of(found)


VERTEX_400 = """#version 400
in vec3 a_position;
uniform mat4 u_modelViewProjection;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
void main() {
    v_position = v_normal = a_position;
    v_uv = a_position.xy;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
"""


@pytest.mark.parametrize(
    "value", ["v_normal * 2.0", "gl_FragCoord.xyz", "vec3(gl_PrimitiveID)", "gl_PointCoord.xyx"]
)
def test_a_global_that_is_initialised_with_an_input_is_refused(value: str) -> None:
    told = refusal("o_color = vec4(waves * start, 1.0);", f"vec3 start = {value};")
    assert told == "the global start is initialised ahead of main"


def test_a_fraction_of_the_rate_is_refused() -> None:
    found = analysed(f"vec3 waves = {NODE}; o_color = vec4(waves, 1.0);")
    options = replace(configured(), payload_rate="half")
    with pytest.raises(InputError) as caught:
        rewritten(found, find(found, NODE), options, ("parked",), unprofitable=True)
    assert caught.value.diagnostics[0].code == "SC407"


def test_no_distance_is_taken_for_an_open_texel(analysis: Analysis) -> None:
    # Where a filter marks linear depths by their sign, half floats round w = 49,150 to -49,152.
    options = configured(depth="linear", filter="bilateral")
    node = find(analysis, NODES["two-octaves"])
    emission = rewritten(analysis, node, options, ("parked",), unprofitable=True)
    for name in ("parked.find.frag", "parked.mark.frag"):
        assert "sc_missed_depth = -0.0001220703125;" in emission.files[name]

"""The emitted programs: golden texts, and that each pass holds only what it needs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import Golden
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain
from shaders import analysed, find

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.caching.configuration import Mode
from shadercache.compiler import Analysis, Emission, analyse
from shadercache.diagnostics import InputError
from shadercache.front.parse import parse
from shadercache.paths import data_path
from shadercache.source import Source
from shadercache.transform.reachable import declared_names, names_in
from shadercache.valid.validate import validate
from tests.configured import configured, rewritten
from tests.glslang import needs_glslang, objections

NOISE = """
float noise(vec3 p) { return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7); }
vec3 stone(vec3 p) {
    float octaves = noise(p) + 0.5 * noise(p * 2.0) + 0.25 * noise(p * 4.0);
    vec4 grain = texture(u_map, p.xy);
    return mix(vec3(0.2), vec3(0.9), octaves) * grain.rgb;
}
"""
BODY = """
    vec3 normal = normalize(v_normal);
    vec3 albedo = stone(v_position);
    float light = max(dot(normal, u_tint), 0.0);
    o_color = vec4(albedo * light + texture(u_map, v_uv).rgb, 1.0);
"""
NODES = {
    "two-octaves": "noise(p) + 0.5 * noise(p * 2.0)",
    "inside-noise": "sin(p.x * 12.9) * sin(p.y * 78.2)",
    "grain": "grain.rgb",
    "albedo": "albedo",
    "light": "albedo * light",
}


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analysed(BODY, NOISE)


@pytest.mark.parametrize("name", ["two-octaves", "grain"])
def test_golden_programs(name: str, analysis: Analysis, golden: Golden) -> None:
    emission = rewritten(analysis, find(analysis, NODES[name]))
    for file, text in emission.files.items():
        golden(f"tests/emit/goldens/{name}/{file}", text)


def test_golden_proof_mode(analysis: Analysis, golden: Golden) -> None:
    emission = rewritten(analysis, find(analysis, NODES["two-octaves"]), configured(mode="proof"))
    for file in ("2-pass.miss.frag", "3-pass.payload.frag", "2-pass.hit.vert"):
        golden(f"tests/emit/goldens/proof/{file}", emission.files[file])


SET = ("noise(p) + 0.5 * noise(p * 2.0)", "grain.rgb", "albedo * light")
"""A value in a function, what stands behind it there, and one that needs both."""


def test_golden_programs_of_a_set(analysis: Analysis, golden: Golden) -> None:
    emission = rewritten(analysis, [find(analysis, text) for text in SET[:2]])
    for file in ("1-pass.frag", "2-pass.miss.frag", "3-pass.payload.frag", "3-pass.shade.frag"):
        golden(f"tests/emit/goldens/set/{file}", emission.files[file])
    manifest = plain(emission.manifest)
    parts = {key: manifest[key] for key in ("nodes", "cache")}
    golden("tests/emit/goldens/set/manifest.json", json.dumps(parts, indent=2) + "\n")
    check_programs(emission)


def test_what_only_feeds_others_of_a_set_is_refused(analysis: Analysis) -> None:
    with pytest.raises(InputError, match=r"'grain.rgb' .* is not needed") as caught:
        rewritten(analysis, [find(analysis, text) for text in SET])
    assert [item.code for item in caught.value.diagnostics] == ["SC417", "SC417"]


@pytest.mark.parametrize("mode", ["plain", "proof"])
def test_every_manifest_follows_the_schema(mode: Mode, analysis: Analysis) -> None:
    validator = Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8")))
    for text in NODES.values():
        node = find(analysis, text)
        validator.validate(
            plain(rewritten(analysis, node, configured(mode=mode), unprofitable=True).manifest)
        )


def emissions(analysis: Analysis) -> dict[tuple[str, Mode], Emission]:
    modes: tuple[Mode, ...] = ("plain", "proof")
    return {
        (name, mode): rewritten(
            analysis, find(analysis, text), configured(mode=mode), unprofitable=True
        )
        for name, text in NODES.items()
        for mode in modes
    }


def test_every_program_is_valid_and_holds_nothing_unused(analysis: Analysis) -> None:
    for emission in emissions(analysis).values():
        check_programs(emission)


def check_programs(emission: Emission) -> None:
    """Parse and type every program of an emission; nothing declared in it goes unused."""
    manifest = plain(emission.manifest)
    passes = [p for v in manifest["variants"] for p in v["passes"]]
    exact = manifest["mode"] == "proof"  # else the original is as the user wrote it
    passes += [manifest[name] for name in ("payload", "debug", *["original"] * exact)]
    for item in passes:
        fragment = module_of(emission, item["fragment"])
        vertex = module_of(emission, item["vertex"])
        validate(fragment, Source(item["fragment"], ""), "fragment")
        validate(vertex, Source(item["vertex"], ""), "vertex")
        assert_nothing_unused(fragment)
        assert_nothing_unused(vertex)
        assert varyings(vertex, "out") == varyings(fragment, "in"), item["name"]
        assert uniforms(vertex) | uniforms(fragment) == set(item["uniforms"])
        assert varyings(vertex, "in") == set(item["attributes"])


def module_of(emission: Emission, name: str) -> n.Module:
    return parse(Source(name, emission.files[name]))


def varyings(module: n.Module, word: str) -> set[str]:
    return {
        name
        for decl in module.decls
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has(word)
        for name in declared_names(decl)
    }


def uniforms(module: n.Module) -> set[str]:
    return varyings(module, "uniform")


def assert_nothing_unused(module: n.Module) -> None:
    """Every declared name is named by another declaration (outputs must be assigned)."""
    for decl in module.decls:
        others = set().union(*(names_in(other) for other in module.decls if other is not decl))
        for name in declared_names(decl):
            assert name in others or name == "main", f"{name} is not used"
    assigned = {
        item.target.name if isinstance(item.target, n.Name) else ""
        for item in walk(module)
        if isinstance(item, n.Assign)
    }
    assert varyings(module, "out") <= assigned


def test_no_derivative_behind_a_discard_or_in_the_branch(analysis: Analysis) -> None:
    """Law 8: implicit fetches stand before the discard, and outside of ``if`` and ``else``."""
    for emission in emissions(analysis).values():
        for name in (item for item in emission.files if item.endswith(".frag")):
            module = module_of(emission, name)
            table = EffectTable(module)
            body = table.functions["main"].body.body
            discarded = False
            for stmt in body:
                does = table.of(stmt).does
                implicit = bool(does & (Does.IMPLICIT_LOD | Does.DERIVATIVE))
                assert not (implicit and discarded), name
                if isinstance(stmt, n.If):
                    branches = [stmt.then, *([stmt.other] if stmt.other else [])]
                    inside = [table.of(branch).does for branch in branches]
                    assert not any(item & (Does.IMPLICIT_LOD | Does.DERIVATIVE) for item in inside)
                discarded = discarded or bool(does & Does.DISCARD)


def test_the_look_up_takes_derivatives_ahead_of_its_exits(analysis: Analysis) -> None:
    for emission in emissions(analysis).values():
        module = module_of(emission, "hit-mask.frag")
        table = EffectTable(module)
        takes = [
            bool(table.of(stmt).does & Does.DERIVATIVE)
            for stmt in table.functions["sc_look_up"].body.body
        ]
        exits = [
            any(isinstance(item, n.Return) for item in walk(stmt))
            for stmt in table.functions["sc_look_up"].body.body
        ]
        assert any(takes)
        assert not any(takes[exits.index(True) :])


def test_a_fetch_that_cannot_be_moved_is_refused_for_one_pass_only() -> None:
    analysis = analysed(
        "vec3 a = v_position; if (v_uv.x > 0.0) a *= texture(u_map, v_uv).rgb;"
        "o_color = vec4(sin(a) * cos(a), 1.0);"
    )
    node = find(analysis, "sin(a) * cos(a)")
    manifest = plain(rewritten(analysis, node).manifest)
    assert [item["algorithm"] for item in manifest["variants"]] == ["2-pass", "3-pass"]
    assert manifest["refused"][0]["algorithm"] == "1-pass"
    with pytest.raises(InputError) as error:
        rewritten(analysis, node, algorithms=("1-pass",))
    assert error.value.diagnostics[0].code == "SC407"


@needs_glslang
def test_glslang_accepts_every_program_without_a_warning(
    analysis: Analysis, tmp_path: Path
) -> None:
    programs = emissions(analysis).values()
    texts = [item for emission in programs for item in emission.files.items()]
    assert not objections(texts, tmp_path)


@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
@pytest.mark.slow
def test_corpus_programs_hold_nothing_unused(scene: str) -> None:
    texts = {
        kind: Source(f"{scene}.{kind}", data_path("corpus", scene, f"{scene}.{kind}").read_text())
        for kind in ("frag", "vert")
    }
    analysis = analyse(texts["frag"], texts["vert"])
    offered = [node for node in analysis.nodes if node.offered]
    for node in offered[:: max(1, len(offered) // 12)]:
        check_programs(rewritten(analysis, node))


def test_a_global_without_a_type_name_forbids_one_pass() -> None:
    analysis = analysed(
        "box.x = v_uv.x; o_color = vec4(sin(v_position * v_position.yzx), box.x);",
        "struct { float x; } box;",
    )
    manifest = plain(
        rewritten(analysis, find(analysis, "sin(v_position * v_position.yzx)")).manifest
    )
    assert [item["algorithm"] for item in manifest["variants"]] == ["2-pass", "3-pass"]
    assert "without a name" in manifest["refused"][0]["reason"]


def test_names_that_become_keywords_in_proof_mode() -> None:
    analysis = analysed(
        "float patch = v_uv.x; o_color = vec4(sample(v_position, patch), 1.0);",
        "vec3 sample(vec3 p, float dmat2) { return sin(p * dmat2) * cos(p); }",
    )
    emission = rewritten(
        analysis, find(analysis, "sin(p * dmat2) * cos(p)"), configured(mode="proof")
    )
    check_programs(emission)
    kept = analysed("o_color = vec4(sin(v_position) * sample, 1.0);", "uniform float sample;")
    node = find(kept, "sin(v_position)")
    check_programs(rewritten(kept, node, unprofitable=True))
    with pytest.raises(InputError) as error:
        rewritten(kept, node, configured(mode="proof"), unprofitable=True)
    assert error.value.diagnostics[0].code == "SC408"

"""Laws 1 to 4 for values that not every fragment needs, and in shaders that discard."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from manifests import plain

from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle
from shadercache.scene.description import Scene, load_scene
from shadercache.verify.laws import judge
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.configured import PROOF, rewritten
from tests.glslang import needs_glslang, objections

FOLDER = Path(__file__).with_name("conditions")
SHADERS = (
    *("branch", "switch", "returns", "discards", "discards_in_arguments"),
    *("alpha", "textures", "choices"),
)
EXPENSIVE = "noise("


def load(name: str) -> tuple[Scene, Analysis]:
    scene = load_scene(FOLDER)
    return analyse_scene(altered(scene, fragment=FOLDER / f"{name}.frag"))


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", SHADERS)
def test_laws_1_to_4(name: str, gpu: Gpu) -> None:
    scene, analysis = load(name)
    nodes = [node for node in analysis.nodes if node.legal and EXPENSIVE in node.text]
    assert nodes
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        found = verifier.round_trip()
        verdicts = [verifier.check(node, plain=False) for node in nodes]
    assert found is not None
    assert found.exact
    broken = {item.text: item.failure or item.broken for item in verdicts if item.broken}
    assert not broken


def refused(name: str, text: str) -> dict[str, str]:
    analysis = load(name)[1]
    node = next(item for item in analysis.nodes if item.text == text and item.legal)
    found = plain(rewritten(analysis, node, unprofitable=True).manifest)["refused"]
    return {entry["algorithm"]: entry["reason"] for entry in found}


def test_what_decides_a_discard_is_refused() -> None:
    nodes = {node.text: node for node in reversed(load("alpha")[1].nodes)}
    for text in ("noise(floor(p * 6.0))", "noise(floor(p * 3.0)) * 0.5"):
        refusal = nodes[text].refusal
        assert refusal is not None
        assert refusal.code.code == "SC316"
    assert nodes["noise(floor(n * 5.0))"].offered


def test_a_fetch_under_a_condition_takes_one_pass_away() -> None:
    assert set(refused("textures", "texture(picture, uv * 3.0).rgb")) == {"1-pass"}
    assert not refused("textures", "noise(floor(p * 8.0)) * n")


@needs_glslang
@pytest.mark.parametrize("name", SHADERS)
def test_the_reference_compiler_takes_every_program(name: str, tmp_path: Path) -> None:
    analysis = load(name)[1]
    for node in analysis.nodes:
        if not node.offered:
            continue
        files = rewritten(analysis, node, Configuration()).files
        assert not objections(files.items(), tmp_path), node.text


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize(
    ("old", "new", "where", "law"),
    (
        ("if (!sc_reuse) {", "if (false) {", "1-pass.frag", "law 2 (1-pass)"),
        ("if (!sc_reuse) {", "if (false) {", "2-pass.hit.frag", "law 2 (2-pass)"),
        ("if (!sc_valid) {", "if (false) {", ".frag", "law 4"),
        ("sc_shade();", "", "3-pass.reuse.frag", "law 4 (3-pass)"),
    ),
)
def test_broken_programs_break_a_law(old: str, new: str, where: str, law: str, gpu: Gpu) -> None:
    scene, analysis = load("discards" if "reuse" in where else "branch")
    text = "noise(floor(p * 5.0))" if "reuse" in where else "noise(floor(p * 6.0))"
    node = next(item for item in analysis.nodes if item.text == text)
    emission = rewritten(analysis, node, PROOF)
    assert any(old in text for name, text in emission.files.items() if where in name)
    files = {
        name: text.replace(old, new) if where in name else text
        for name, text in emission.files.items()
    }
    verdict = Verdict(node.id, node.path, node.text, node.offered)
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        judge(verifier.references, Bundle(emission.manifest, files), verdict)
    assert any(found.startswith(law) for found in verdict.broken), verdict.broken

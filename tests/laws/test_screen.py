"""Laws 2 to 4 for values of the screen, which ``--approximate`` offers: exact at rest."""

from __future__ import annotations

import re
import shutil
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from laws.slices import amount, day_slice, seed

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.value_numbering import one_of_each
from shadercache.caching.algorithms import NAMES, USUAL
from shadercache.compiler import Analysis, emit_original
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle
from shadercache.scene.description import Scene, load_scene
from shadercache.source import Source
from shadercache.transform.unique_names import make_names_unique
from shadercache.valid.read import read
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.cases.scenery import ring
from tests.configured import PROOF, configured, rewritten
from tests.generated.law8 import apart_derivatives
from tests.shaders import find

from .test_mutations import broken

pytestmark = pytest.mark.xdist_group("screen")

FOLDER = Path(__file__).with_name("screen")
SHADERS = sorted(path.stem for path in FOLDER.glob("*.glsl") if path.stem != "head")
SIZE = (48, 48)
NODES = amount(3, 12)
"""Of each shader; the slices of successive seeds cover all of them."""

LIT = "wave(normal) * wave(normal.yzx * 5.0)"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The scene with its mesh, its texture and its shaders made."""
    made = tmp_path_factory.mktemp("screen") / "screen"
    shutil.copytree(FOLDER, made)
    np.savez(made / "ring.npz", **ring())
    pixels = np.random.default_rng(4).random((16, 16, 4), np.float32)
    np.savez(made / "map.npz", pixels=pixels)
    head = (FOLDER / "head.glsl").read_text("utf-8")
    for name in SHADERS:
        text = (FOLDER / f"{name}.glsl").read_text("utf-8")
        (made / f"{name}.frag").write_text(head + text, encoding="utf-8")
    return made


def opened(folder: Path, name: str, approximate: bool = True) -> tuple[Scene, Analysis]:
    scene = altered(load_scene(folder), fragment=folder / f"{name}.frag")
    return analyse_scene(scene, ReadOptions(approximate=approximate))


def of_screen(analysis: Analysis) -> list[Candidate]:
    """The values of the screen that are offered, one node of each."""
    offered = [node for node in analysis.nodes if node.approximate and node.offered]
    return list(one_of_each(offered, analysis.groups))


@pytest.mark.parametrize("name", SHADERS)
def test_none_is_offered_unasked(folder: Path, name: str) -> None:
    refused = {node.id: node for node in opened(folder, name, approximate=False)[1].nodes}
    asked = of_screen(opened(folder, name)[1])
    assert asked
    for node in asked:
        refusal = refused[node.id].refusal
        assert refusal is not None and refusal.approximable, node.text


@pytest.mark.parametrize("name", SHADERS)
def test_laws_2_to_4(gpu: Gpu, folder: Path, name: str) -> None:
    scene, analysis = opened(folder, name)
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        verifier.algorithms = NAMES
        chosen = day_slice(of_screen(analysis), seed(), NODES)
        verdicts = [verifier.check(node, plain=False) for node in chosen]
        assert verifier.references.covered[0].mean() > 0.2
    for verdict in verdicts:
        assert not verdict.broken, (verdict.text, verdict.reasons)
        assert {"2-pass", "3-pass"} <= verdict.algorithms, verdict.refused
        assert verdict.moving is not None and verdict.moving.keys() == verdict.algorithms


def lighting(gpu: Gpu, folder: Path) -> Verdict:
    """The verdict on what a normal map with a frame from derivatives is lit with."""
    scene, analysis = opened(folder, "map")
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        verifier.algorithms = NAMES
        return verifier.check(find(analysis, LIT), plain=False)


def test_a_frame_from_derivatives_by_every_algorithm(gpu: Gpu, folder: Path) -> None:
    verdict = lighting(gpu, folder)
    assert verdict.algorithms == set(NAMES) and not verdict.broken
    # What is off in motion is told, and is the same by each, since the algorithms agree.
    (error,) = set((verdict.moving or {}).values())
    assert error > 0.0


def test_a_surface_value_has_no_such_error(gpu: Gpu, folder: Path) -> None:
    scene, analysis = opened(folder, "elsewhere")
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        verdict = verifier.check(find(analysis, "wave(v_normal)"), plain=False)
    assert not verdict.approximate and not verdict.broken


def test_one_pass_takes_derivatives_ahead_of_its_branch(folder: Path) -> None:
    _, analysis = opened(folder, "map")
    emission = rewritten(analysis, find(analysis, LIT), configured(), ("1-pass",))
    text = emission.files["1-pass.frag"]
    functions = dict(re.findall(r"^void (\w+)\(\) \{\n(.*?)^\}", text, re.M | re.S))
    assert not re.search(r"dFd[xy]\(v_", functions["sc_compute"] + functions["sc_shade"])
    assert functions["main"].index("sc_fetch_ahead()") < functions["main"].index("sc_look_up(")
    ahead = "".join(body for name, body in functions.items() if "_ahead" in name)
    assert {"dFdx(v_position)", "dFdy(v_uv)"} <= set(re.findall(r"dFd[xy]\(\w+\)", ahead))


@pytest.mark.parametrize("name", SHADERS)
def test_law_8(folder: Path, name: str) -> None:
    """All fragments of a quad take the variants' derivatives, as they take the original's."""
    analysis = opened(folder, name)[1]
    files = emit_original(analysis).files | {}
    for node in day_slice(of_screen(analysis), seed(), NODES):
        emission = rewritten(analysis, node, configured(), NAMES)
        files |= {f"{node.id} {file}": text for file, text in emission.files.items()}
    for file, text in files.items():
        if file.endswith(".frag"):
            module, facts = read(Source(file, text), "fragment", needs_main=True)
            assert apart_derivatives(make_names_unique(module, facts)) == [], file


@pytest.mark.parametrize("text", ["wave(dFdx(v_position) * 50.0)", "slope(v_position)"])
def test_one_pass_is_refused_a_derivative_under_a_condition(folder: Path, text: str) -> None:
    _, analysis = opened(folder, "flow")
    emission = rewritten(analysis, find(analysis, text), configured(), USUAL)
    refused = {entry.algorithm: entry.reason for entry in emission.manifest.refused}
    assert refused.keys() == {"1-pass"}
    assert "neighbouring fragments would not compute it together" in refused["1-pass"]


@pytest.mark.parametrize(
    ("wrong", "law"), [("dFdy(v_position)", "law 2"), ("sc_payload * 1.01", "law 3")]
)
def test_the_laws_notice(gpu: Gpu, folder: Path, wrong: str, law: str) -> None:
    scene, analysis = opened(folder, "map")
    emission = rewritten(analysis, find(analysis, LIT), configured(PROOF))
    name, old = {
        "law 2": ("2-pass.miss.frag", "dFdx(v_position)"),
        "law 3": ("2-pass.hit.frag", "sc_payload"),
    }[law]
    text = emission.files[name]
    assert old in text
    if law == "law 2":
        changed = text.replace(old, wrong)
    else:
        changed = re.sub(r"(o_color = vec4\()sc_payload\b", rf"\1{wrong}", text)
    assert changed != text
    bundle = Bundle(emission.manifest, emission.files | {name: changed})
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        assert f"{law} (2-pass)" in broken(verifier, bundle)

"""Laws 1 to 4 for shaders of other versions than 3.30, which are raised where it takes that."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from laws.slices import amount, day_slice, seed

from shadercache.compiler import Analysis, emit_original
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.scene.description import Scene, load_scene
from shadercache.verify.verifier import Verifier
from tests.conditioning import all_too_far
from tests.configured import configured, rewritten
from tests.conftest import Golden
from tests.glslang import needs_glslang, objections

FOLDER = Path(__file__).with_name("versions")
VERSIONS = ("es100", "es310", "gl110", "gl150", "fixed")


def load(name: str) -> tuple[Scene, Analysis]:
    return analyse_scene(load_scene(FOLDER / name))


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", VERSIONS)
def test_laws_1_to_4(name: str, gpu: Gpu) -> None:
    scene, analysis = load(name)
    nodes = [node for node in analysis.nodes if node.legal]
    assert len(nodes) >= 4
    with closing(Verifier(gpu, (scene, analysis), (64, 64))) as verifier:
        found = verifier.round_trip()
        verdicts = [verifier.check(node) for node in nodes]
        # In 16 bits a payload would be 2^-11 off, in 32 what is rearranged moves it by some 2^-23.
        far = all_too_far(verifier, [[node] for node in nodes], verdicts)
    # The core profile has no fixed-function pipeline to compare with.
    assert found is None if name == "fixed" else found is not None and found.exact
    broken = {item.text: item.failure or item.broken for item in verdicts if item.broken}
    assert not broken
    assert not far, "a payload of another precision than its expression"


@pytest.mark.parametrize("name", VERSIONS)
def test_golden_raised(name: str, golden: Golden) -> None:
    analysis = load(name)[1]
    for file, text in emit_original(analysis).files.items():
        golden(f"tests/laws/versions/{name}/{file}", text)
    notes = "".join(f"{note.render()}\n" for note in analysis.notes)
    golden(
        f"tests/laws/versions/{name}/notes.txt", notes.replace(f"{FOLDER}/", "").replace("\\", "/")
    )


@needs_glslang
@pytest.mark.parametrize("mode", ("plain", "proof"))
@pytest.mark.parametrize("name", VERSIONS)
def test_the_reference_compiler_takes_every_program(name: str, mode: str, tmp_path: Path) -> None:
    analysis = load(name)[1]
    legal = [node for node in analysis.nodes if node.legal]
    for node in day_slice(legal, seed(), amount(4, 1000)):
        options = configured(mode="proof" if mode == "proof" else "plain")
        files = rewritten(analysis, node, options, unprofitable=True).files
        assert not objections(files.items(), tmp_path), node.text

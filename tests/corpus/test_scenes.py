"""Both scenes: files, shaders, the telling nodes, and how much of the frame they cover."""

from __future__ import annotations

import re
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from PIL import Image

from shadercache.compiler import Analysis, analyse
from shadercache.gpu.context import Gpu
from shadercache.manifest.codec import encode
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.mesh import load_mesh
from shadercache.source import Source
from tests.configured import rewritten

CORPUS = Path(__file__).resolve().parent.parent.parent / "corpus"
NAMES = ("dragon", "trashcan")


@pytest.fixture(scope="module", params=NAMES)
def scene(request: pytest.FixtureRequest) -> Scene:
    return load_scene(CORPUS / request.param / "scene.toml")


@pytest.fixture(scope="module")
def analysis(scene: Scene) -> Analysis:
    sources = [Source(p.name, p.read_text()) for p in (scene.common.fragment, scene.common.vertex)]
    return analyse(*sources)


@pytest.fixture
def bundle(analysis: Analysis, tmp_path: Path) -> Bundle:
    emission = rewritten(analysis, next(node for node in analysis.nodes if node.offered))
    for file, text in emission.files.items():
        (tmp_path / file).write_text(text)
    (tmp_path / "manifest.json").write_text(encode(emission.manifest))
    return load_bundle(tmp_path)


def texts(analysis: Analysis, function: str) -> list[str]:
    """What the offered nodes of a function look like, white space as in the printer's output."""
    return [n.text for n in analysis.nodes if n.offered and n.path.split(" > ")[-1] == function]


def test_every_file_of_the_scene_is_there(scene: Scene) -> None:
    for path in (scene.common.fragment, scene.common.vertex, scene.common.mesh):
        assert path.is_file()
    for spec in scene.common.inputs.textures.values():
        assert spec.path.is_file()
    mesh = load_mesh(scene.common.mesh)
    assert set(scene.common.inputs.attributes.values()) <= set(mesh.arrays)


def test_every_uniform_of_the_shaders_has_a_value_and_none_is_idle(scene: Scene) -> None:
    given = scene.common.inputs
    text = scene.common.fragment.read_text() + scene.common.vertex.read_text()
    declared = set(re.findall(r"^uniform \w+ (\w+);", text, re.MULTILINE))
    assert declared == {*given.constants, *given.semantics, *given.textures}


def test_the_motion(scene: Scene) -> None:
    assert scene.common.motion.frames == 64
    assert scene.common.motion.degrees_per_frame == 1.0


def test_enough_nodes(analysis: Analysis) -> None:
    offered = sum(node.offered for node in analysis.nodes)
    assert offered >= (150 if analysis.fragment.name == "dragon.frag" else 60)


def test_telling_nodes_are_offered(analysis: Analysis) -> None:
    if analysis.fragment.name == "dragon.frag":
        assert "fbm(p * 2.3 + ragged)" in texts(analysis, "marble")
        assert "noise(p) + 0.5 * noise(p * 2.02)" in texts(analysis, "fbm")
        assert "marble(v_position)" in texts(analysis, "main")
    else:
        sums = [
            t for t in texts(analysis, "main") if t.startswith("sample_environment(-2.0, -2.0)")
        ]
        assert {t.count("sample_environment") for t in sums} == set(range(1, 26))


def test_coverage(gpu: Gpu, scene: Scene, bundle: Bundle) -> None:
    # What is seen at 256 x 256 is what is seen at 1024 x 1024, to a tenth of a per cent.
    with RenderScene(gpu, scene, (256, 256)) as world:
        runner = CoverageRunner(world, bundle)
        for frame in (0, 16, 32, 48, 63):
            covered = runner.coverage(frame)
            assert 0.40 <= covered.mean() <= 0.65
            rim = [covered[0], covered[-1], covered[:, 0], covered[:, -1]]
            assert not np.concatenate(rim).any()  # nothing is cut off
        runner.release()


def test_the_tables_of_the_noise(dragon_generator: ModuleType) -> None:
    permutation, gradients = dragon_generator.lattice()
    with np.load(CORPUS / "dragon" / "permutation.npz") as stored:
        assert np.array_equal(stored["pixels"], permutation)
    with np.load(CORPUS / "dragon" / "gradients.npz") as stored:
        assert np.allclose(stored["pixels"], gradients, atol=2e-3)
    assert sorted(set((permutation.astype(float) * 64.0 - 0.5).ravel())) == list(range(64))
    assert np.abs(gradients.astype(float).mean(axis=(0, 1))).max() < 0.01  # none is favoured


def test_the_detail_texture(dragon_generator: ModuleType) -> None:
    texels = np.asarray(Image.open(CORPUS / "dragon" / "detail.png"), np.int64)
    made = dragon_generator.detail().astype(np.int64)
    assert np.abs(made - texels).max() <= 1

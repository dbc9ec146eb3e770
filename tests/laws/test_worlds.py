"""Laws 6 to 9 where instances, bones and morphs move, and with several outputs and integers.

Laws 1 to 5 hold there by ``tests/scene``, ``tests/corpus`` and ``test_outputs.py``.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from render.test_independent_runner import agree, write

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import NAMES
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, configured, originals, rewritten, variant
from tests.glslang import needs_glslang, objections

FOLDER = Path(__file__).with_name("worlds")
CAN = Path(__file__).resolve().parent.parent.parent / "corpus" / "trashcan" / "can.npz"
FRAMES, SIZE = 12, (96, 96)
SCENE = """
name = "world"
fragment = "shader.frag"
vertex = "shader.vert"
mesh = "can.npz"
[attributes]
position = "position"
normal = "normal"
[motion]
degrees_per_frame = 2.0
[camera]
eye = [0.0, 0.62, 3.6]
target = [0.0, -0.04, 0.0]
fov_degrees = 42.0
near = 1.0
far = 10.0
[uniforms]
mvp = "model-view-projection"
zero = 0.0
{uniforms}
{instances}
"""
WORLDS = {
    "instances": ("instances.vert", "one.frag"),
    "skin": ("skin.vert", "one.frag"),
    "morph": ("morph.vert", "one.frag"),
    "g-buffer": ("../outputs/shader.vert", "gbuffer.frag"),
    "integers": ("../outputs/shader.vert", "integers.frag"),
}
UNIFORMS = {
    "skin": 'bones = { table = "moves.npz", array = "bones" }',
    "morph": "weights = { start = [0.0, 0.4], per_frame = [0.06, -0.05] }",
}

Opened = tuple[Scene, Analysis, Candidate]

pytestmark = pytest.mark.xdist_group("gl")


def turned(angle: NDArray[np.float64], shift: NDArray[np.float64]) -> NDArray[np.float64]:
    """Matrices column by column that turn about z and then shift along x."""
    turn = np.zeros((*angle.shape, 4, 4))
    turn[..., 0, 0] = turn[..., 1, 1] = np.cos(angle)
    turn[..., 0, 1], turn[..., 1, 0] = np.sin(angle), -np.sin(angle)
    turn[..., 2, 2] = turn[..., 3, 3] = 1.0
    turn[..., 3, 0] = shift
    return turn.reshape(*angle.shape, 16)


@pytest.fixture(scope="module")
def opened(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Opened:
    """A world, and its value that is not finite in places."""
    folder, name = tmp_path_factory.mktemp("world"), request.param
    vertex, fragment = WORLDS[name]
    (folder / "can.npz").write_bytes(CAN.read_bytes())
    head = "#version 330\n" + (FOLDER / "pitted.glsl").read_text()
    (folder / "shader.frag").write_text(head + (FOLDER / fragment).read_text())
    (folder / "shader.vert").write_text((FOLDER / vertex).read_text())
    step = np.arange(FRAMES)[:, None]
    bones = turned(step * [0.0, 0.03], np.zeros((FRAMES, 2)))
    turns = turned(0.04 * step * [1.0, -1.0, 0.5], np.tile([-0.9, 0.0, 0.9], (FRAMES, 1)))
    np.savez(folder / "moves.npz", bones=bones.reshape(FRAMES, -1), turns=turns)
    instances = '[instances]\ni_turn = { table = "moves.npz", array = "turns" }'
    text = SCENE.format(
        uniforms=UNIFORMS.get(name, ""),
        instances=instances if name == "instances" else "",
    )
    (folder / "scene.toml").write_text(text)
    scene, analysis = analyse_scene(load_scene(folder / "scene.toml"))
    [node] = [node for node in analysis.nodes if node.text == "pitted(p)" and node.offered]
    return scene, analysis, node


each = pytest.mark.parametrize("opened", WORLDS, indirect=True)


def bundle_of(opened: Opened, **chosen: object) -> Bundle:
    _, analysis, node = opened
    emission = rewritten(analysis, node, configured(**chosen), NAMES)
    return Bundle(emission.manifest, emission.files)


def spread(gpu: Gpu, opened: Opened, algorithm: str, bundle: Bundle) -> Iterator[int]:
    """Frame by frame, in how many pixels the variant is not finite and the original is."""
    with (
        RenderScene(gpu, opened[0], SIZE, "rgba32f") as world,
        OriginalRunner(world, *originals(opened[0], bundle)) as original,
        variant(world, bundle, algorithm) as runner,
    ):
        for frame in range(FRAMES):
            true = original.image(frame)
            assert np.isnan(true).any(axis=-1).sum() > 50, "nothing that could spread"
            shown = runner.image(frame)
            yield int(np.count_nonzero(np.isfinite(true) & ~np.isfinite(shown)))


@each
@pytest.mark.parametrize("algorithm", NAMES)
def test_law_6_what_is_not_finite_stays_where_it_is(
    gpu: Gpu, opened: Opened, algorithm: str
) -> None:
    bundle = bundle_of(opened, refresh="none")
    assert not any(spread(gpu, opened, algorithm, bundle))


@pytest.mark.parametrize("opened", ["skin"], indirect=True)
def test_law_6_is_about_something(gpu: Gpu, opened: Opened) -> None:
    """Without the guard a filter spreads it from frame to frame."""
    bundle = bundle_of(opened, refresh="none", guard="off")
    assert sum(spread(gpu, opened, "2-pass", bundle)) > 50


@each
def test_law_7_no_payload_is_older_than_a_period(gpu: Gpu, opened: Opened) -> None:
    scene, analysis, node = opened
    chosen = configured(PROOF, age=True)
    with closing(Verifier(gpu, (scene, analysis), (64, 64), configuration=chosen)) as verifier:
        verdict = verifier.check(node, plain=False)
    assert not verdict.broken, verdict.reasons
    assert {"1-pass", "2-pass", "3-pass"} <= verdict.algorithms


@needs_glslang
@each
def test_law_8_the_reference_compiler_takes_every_program(opened: Opened, tmp_path: Path) -> None:
    texts = [
        file
        for mode in ("plain", "proof")
        for file in bundle_of(opened, mode=mode, age=True).files.items()
    ]
    assert len(texts) > 20
    assert not objections(texts, tmp_path)


@each
def test_law_9_every_value_has_a_verdict(opened: Opened) -> None:
    _, analysis, _ = opened
    for node in analysis.nodes:
        assert node.offered or (node.refusal is not None and str(node.refusal)), node.text


@pytest.mark.parametrize("opened", ["skin", "morph", "g-buffer", "integers"], indirect=True)
def test_an_engine_draws_the_same_from_the_manifest(
    gpu: Gpu, opened: Opened, tmp_path: Path
) -> None:
    scene, analysis, node = opened
    write(rewritten(analysis, node, algorithms=NAMES), tmp_path)
    bundle = load_bundle(tmp_path)
    with RenderScene(gpu, Linker(scene, analysis).scene, SIZE, "rgba32f") as world:
        for algorithm in bundle.algorithms:
            assert agree(world, bundle, tmp_path, algorithm, None), algorithm

"""The heroine and the colonnade: files, bones, and the laws with all objects in one frame."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import camera_at
from shadercache.scene.description import Scene
from shadercache.scene.mesh import load_mesh
from shadercache.verify.verifier import Verifier
from tests.configured import originals, rewritten, variant

from .conftest import imported

pytestmark = pytest.mark.xdist_group("gl")

CORPUS = Path(__file__).resolve().parent.parent.parent / "corpus"
NAMES = ("heroine", "colonnade")


@pytest.fixture(scope="module", params=NAMES)
def opened(request: pytest.FixtureRequest) -> tuple[Scene, Analysis]:
    return open_scene(CORPUS / request.param / "scene.toml")


@pytest.fixture(scope="module")
def colonnade_generator() -> ModuleType:
    return imported("colonnade")


def test_the_files_are_small() -> None:
    for name in NAMES:
        assert sum(path.stat().st_size for path in (CORPUS / name).glob("*.npz")) < 1 << 20


def test_every_vertex_of_the_heroine_is_moved_by_her_bones() -> None:
    with np.load(CORPUS / "heroine" / "walk.npz") as stored:
        frames, count, numbers = stored["bones"].shape
        matrices = stored["bones"].reshape(frames, count, 4, 4).transpose(0, 1, 3, 2)
    assert (frames, numbers) == (60, 16) and count >= 20
    turns = matrices[..., :3, :3].astype(np.float64)
    assert np.allclose(turns @ turns.swapaxes(-1, -2), np.eye(3), atol=1e-5)
    for name in ("heroine", "heroine-small"):
        arrays = load_mesh(CORPUS / "heroine" / f"{name}.npz").arrays
        assert arrays["bones"].min() >= 0 and arrays["bones"].max() < count
        assert np.allclose(arrays["weights"].sum(axis=1), 1.0, atol=1e-4)
        used = arrays["bones"][arrays["weights"] > 0.25].astype(int)
        assert len(np.unique(used)) >= 20
        assert _stands_on_the_ground(arrays, matrices)


def _stands_on_the_ground(arrays: dict[str, np.ndarray], matrices: np.ndarray) -> bool:
    """Her lowest point stays within a finger's breadth of the ground over the whole walk."""
    points = np.concatenate([arrays["position"], np.ones((len(arrays["position"]), 1))], axis=1)
    lows = []
    for frame in matrices:
        skin = np.einsum("nk,nkij->nij", arrays["weights"], frame[arrays["bones"].astype(int)])
        lows.append(float(np.einsum("nij,nj->ni", skin, points)[:, 1].min()))
    return bool(max(map(abs, lows)) < 0.035)


def test_the_columns(colonnade_generator: ModuleType, opened: tuple[Scene, Analysis]) -> None:
    scene = opened[0]
    if scene.name != "colonnade":
        assert [item.caching.on for item in scene.objects] == [True, True, False]
        return
    columns = [item.motion.position for item in scene.objects if "column" in item.name]
    assert len(columns) >= 60
    assert columns == colonnade_generator.places()
    with np.load(CORPUS / "colonnade" / "column.npz") as stored:
        made = colonnade_generator.column()["position"].astype(np.float32)
        assert np.allclose(stored["position"], made, atol=1e-6)


def test_the_camera_meets_no_column() -> None:
    scene, _ = open_scene(CORPUS / "colonnade" / "scene.toml")
    columns = [item.motion.position for item in scene.objects if "column" in item.name]
    for frame in range(scene.common.motion.frames):
        eye = camera_at(scene.view, frame).eye
        away = min(np.hypot(eye[0] - x, eye[2] - z) for x, _, z in columns)
        assert away > 0.46 + 1.5 * scene.view.camera.near, (frame, away)


def test_the_laws_hold(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    scene, analysis = opened
    (name,) = scene.nodes.values()
    with closing(Verifier(gpu, (scene, analysis), size=(64, 64))) as verifier:
        verdict = verifier.check(analysis.node(name), plain=False)
    assert not verdict.broken, verdict
    assert len(verdict.algorithms) == 3


def test_most_is_reused_in_motion(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    """Edges weigh much in so small a picture; docs/lab/scenes.md has the curves of large ones."""
    scene, analysis = opened
    (name,) = scene.nodes.values()
    emission = rewritten(analysis, analysis.node(name))
    bundle = Bundle(emission.manifest, emission.files)
    rates = []
    with RenderScene(gpu, scene.small, (256, 256)) as world:
        with variant(world, bundle, "2-pass", period=32) as runner:
            for frame in range(30, 36):
                mask = runner.hit_mask(frame)
                rates.append((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum())
                runner.draw(frame)
        with CoverageRunner(world, *originals(world.scene, bundle)) as cover:
            assert cover.coverage(30).all(), "sky and ground fill the picture"
    assert rates[0] == 0.0 and min(rates[1:]) > 0.7, rates

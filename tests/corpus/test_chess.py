"""The game of chess: its discs, its meshes, and what of the darkness stands still."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.mesh import load_mesh
from tests.configured import originals, rewritten, variant

from .conftest import imported

FOLDER = Path(__file__).resolve().parent.parent.parent / "corpus" / "chess"
REACH = 16.0
SETTINGS = pytest.mark.parametrize(("suffix", "count"), [("", 480), ("-fine", 996)])
MESHES = (
    "board",
    *(f"{name}{size}" for name in ("white", "black", "king") for size in ("", "-small")),
)


@pytest.fixture(scope="module")
def generator() -> ModuleType:
    return imported("chess")


@pytest.fixture(scope="module")
def opened() -> tuple[Scene, Analysis]:
    return open_scene(FOLDER / "scene.toml")


def rows(name: str) -> np.ndarray:
    """(rows, 8): middle, area, normal, and the row after the parts."""
    with np.load(FOLDER / f"{name}.npz") as stored:
        return stored["pixels"].astype(np.float64).reshape(-1, 8)


def is_leaf(discs: np.ndarray) -> np.ndarray:
    return discs[:, 7] == np.arange(len(discs)) + 1


def occlusion(discs: np.ndarray, point: np.ndarray, normal: np.ndarray, reach: float) -> float:
    """What the shader's function computes."""
    covered, row = 0.0, 0
    while row < len(discs):
        *middle, area, x, y, z, after = discs[row]
        way = np.array(middle) - point
        away = float(way @ way) + 1e-4
        if after > row + 1 and away < reach * area:
            row += 1
            continue
        way /= np.sqrt(away)
        facing = np.array([x, y, z])
        shown = max(float(-facing @ way), 0.0) + 0.25 * (1.0 - float(facing @ facing))
        covered += shown * max(float(normal @ way), 0.0) * area / (np.pi * away + area)
        row = int(after)
    return covered


@SETTINGS
def test_the_king_has_two_in_a_hundred_discs_at_most(suffix: str, count: int) -> None:
    still, king = (int(is_leaf(rows(f"{name}{suffix}")).sum()) for name in ("discs", "king-discs"))
    assert still + king == count
    assert 0 < king <= 0.02 * count


@SETTINGS
def test_a_disc_is_as_large_as_its_parts(suffix: str, count: int) -> None:
    for name in ("discs", "king-discs"):
        discs = rows(f"{name}{suffix}")
        leaf = is_leaf(discs)
        for row, after in enumerate(discs[:, 7].astype(int)):
            below = discs[row:after][leaf[row:after]]
            assert row < after <= len(discs)
            assert np.isclose(discs[row, 3], below[:, 3].sum(), rtol=1e-5)
            share = below[:, 3:4] / below[:, 3].sum()
            assert np.allclose(discs[row, :3], (share * below[:, :3]).sum(0), atol=1e-5)
            assert np.linalg.norm(discs[row, 4:7]) < 1.0 + 1e-6


@SETTINGS
def test_the_discs_are_as_large_as_the_surfaces(
    suffix: str, count: int, generator: ModuleType
) -> None:
    def area(mesh: dict[str, np.ndarray]) -> float:
        a, b, c = (mesh["position"][mesh["index"][:, corner]] for corner in range(3))
        return 0.5 * float(np.linalg.norm(np.cross(b - a, c - a), axis=-1).sum())

    areas = {kind: area(generator.piece(kind, 24)) for kind in generator.DISCS}
    still, king = (rows(f"{name}{suffix}") for name in ("discs", "king-discs"))
    standing = [kind for kind, _, _, _ in generator.standing()]
    assert len(standing) == 31
    assert king[0, 3] == pytest.approx(areas["king"], rel=1e-5)
    wanted = (2.0 * generator.EDGE) ** 2 + sum(areas[kind] for kind in standing)
    assert still[is_leaf(still), 3].sum() == pytest.approx(wanted, rel=1e-5)


def test_parents_darken_like_their_parts(opened: tuple[Scene, Analysis]) -> None:
    """The hierarchy's own error is below that of a cache, and it saves more than half."""
    assert f"REACH = {REACH};" in opened[0].common.fragment.read_text()
    discs = rows("discs")
    random = np.random.Generator(np.random.PCG64(5))
    points = random.uniform(-4.0, 4.0, (60, 3)) * (1.0, 0.0, 1.0)
    up = np.array([0.0, 1.0, 0.0])
    dark = {
        reach: np.exp([-occlusion(discs, point, up, reach) for point in points])
        for reach in (REACH, np.inf)
    }
    error = np.sqrt(np.mean((dark[REACH] - dark[np.inf]) ** 2))
    assert 0.0 < error < 0.01
    assert dark[np.inf].min() < 0.7 and dark[np.inf].max() > 0.8


@pytest.mark.parametrize("name", MESHES)
def test_faces_look_outward(name: str) -> None:
    mesh = load_mesh(FOLDER / f"{name}.npz")
    position, normal = (mesh.arrays[key].astype(np.float64) for key in ("position", "normal"))
    a, b, c = (position[mesh.index[:, corner]] for corner in range(3))
    cross = np.cross(b - a, c - a)
    agree = (normal[mesh.index].sum(axis=1) * cross).sum(axis=1) > 0.0
    # Where a profile bends sharply a normal may look another way than a thin face.
    size = np.linalg.norm(cross, axis=-1)
    assert size[agree].sum() > 0.995 * size.sum()
    # The volume inside: negative if all is inside out.
    assert (a * cross).sum() > 0.0


def test_the_committed_meshes_are_the_generators(generator: ModuleType) -> None:
    made = {
        "board": generator.board(),
        "white": generator.pieces(True, 20),
        "king-small": generator.piece("king", 8),
    }
    for name, mesh in made.items():
        kept = load_mesh(FOLDER / f"{name}.npz")
        assert np.array_equal(mesh["index"], kept.index)
        assert np.allclose(mesh["position"], kept.arrays["position"], atol=1e-3)
        assert np.allclose(mesh["normal"], kept.arrays["normal"], atol=0.02)


def test_the_files_are_small() -> None:
    assets = [path for path in FOLDER.iterdir() if path.suffix in (".npz", ".png")]
    assert sum(path.stat().st_size for path in assets) < 300_000


@pytest.mark.parametrize("name", ["fine", "orbit"])
def test_the_other_scenes_are_the_same_game(name: str) -> None:
    ours, theirs = ((FOLDER / f"{file}.toml").read_text().splitlines() for file in ("scene", name))
    changed = [line for line in theirs if line not in ours]
    keys = {line.partition(" ")[0] for line in changed}
    more = {"fine": {"file"}, "orbit": {"[camera.path]", "degrees_per_frame"}}[name]
    assert keys == {"name", "title"} | more
    assert len(theirs) - len(ours) == (3 if name == "orbit" else 0)
    load_scene(FOLDER / f"{name}.toml")


def test_the_king_alone_moves_with_his_discs(opened: tuple[Scene, Analysis]) -> None:
    scene, analysis = opened
    places = {part.name: [part.motion.place(frame) for frame in (0, 40)] for part in scene.parts}
    moving = [name for name, (first, later) in places.items() if first != later]
    assert moving == ["king"]
    discs = scene.common.inputs.animated["u_king"]
    assert np.allclose([discs.at(frame) for frame in (0, 40)], places["king"])
    still, whole = (analysis.node(scene.nodes[name]) for name in ("static share", "whole"))
    assert still.offered and whole.offered
    assert "u_king" in whole.inputs and "u_king" not in still.inputs


def test_what_stands_still_is_as_good_as_new(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    """Of the static share only the king's own may be old; of the whole also his shadow."""
    scene, analysis = opened
    images = {}
    with RenderScene(gpu, scene.small, (96, 96)) as world:
        for name in ("static share", "whole"):
            emission = rewritten(analysis, analysis.node(scene.nodes[name]))
            bundle = Bundle(emission.manifest, emission.files)
            with variant(world, bundle, "2-pass", period=32) as runner:
                images[name] = [runner.image(frame) for frame in range(12)][-1][..., :3]
        with OriginalRunner(world, *originals(world.scene, bundle)) as runner:
            original = runner.image(11)[..., :3]
    off = {name: np.abs(image - original).max(-1) for name, image in images.items()}
    # Half floats keep eleven bits.
    seen = {name: int((error > 2e-3).sum()) for name, error in off.items()}
    assert 0 < seen["static share"] < 0.02 * original.shape[0] ** 2
    assert seen["whole"] > 2 * seen["static share"]

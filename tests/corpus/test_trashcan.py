"""The trash can's mesh, its normal map and its environment."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from PIL import Image

from shadercache.scene.mesh import Mesh

FOLDER = Path(__file__).resolve().parent.parent.parent / "corpus" / "trashcan"


def test_about_a_thousand_faces(can: Mesh) -> None:
    assert len(can.index) == pytest.approx(1000, rel=0.1)


def test_frames_are_orthonormal_and_look_outward(can: Mesh) -> None:
    position, normal, tangent = (
        can.arrays[k].astype(np.float64) for k in ("position", "normal", "tangent")
    )
    a, b, c = (position[can.index[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    assert ((normal[can.index].sum(axis=1) * across).sum(axis=1) > 0.0).all()
    for axis in (normal, tangent):
        assert np.allclose(np.linalg.norm(axis, axis=1), 1.0, atol=1e-5)
    assert np.abs((normal * tangent).sum(axis=1)).max() < 1e-5
    lathed = np.arange(len(position)) < 13 * 27  # the wall is the first sheet
    out = position * (1.0, 0.0, 1.0)
    assert ((normal * out).sum(axis=1)[lathed] > 0.0).all()


def test_the_wall_is_ribbed_and_dented(can: Mesh) -> None:
    x, y, z = can.arrays["position"].T
    radius = np.hypot(x, z)
    rib = radius[np.abs(y - 0.10) < 0.005]
    beside = radius[np.abs(y - 0.06) < 0.005]
    assert rib.max() > beside.max() + 0.02
    assert np.ptp(rib) > 0.05


def test_every_texel_of_the_normal_map_is_a_unit_vector_that_looks_up() -> None:
    texels = np.asarray(Image.open(FOLDER / "normals.png").convert("RGB"), np.float64)
    assert max(texels.shape) <= 512
    normal = texels / 255.0 * 2.0 - 1.0
    assert np.allclose(np.linalg.norm(normal, axis=-1), 1.0, atol=0.015)
    assert normal[..., 2].min() > 0.3
    assert np.std(normal[..., 0]) > 0.05


def test_the_environment_has_a_high_range_and_no_holes() -> None:
    with np.load(FOLDER / "environment.npz") as stored:
        faces = stored["faces"].astype(np.float64)
    assert faces.shape[0] == 6
    assert 64 <= faces.shape[1] == faces.shape[2] <= 128
    light = faces[..., :3]
    assert np.isfinite(faces).all()
    assert light.min() > 0.0
    assert light.max() > 3.0  # the sun, as rough metal sees it


def test_faces_of_the_environment_meet(trashcan_generator: ModuleType) -> None:
    way = trashcan_generator.directions(64)
    assert np.allclose(np.linalg.norm(way, axis=-1), 1.0)
    centres = way[:, 31:33, 31:33].mean(axis=(1, 2)).round(3)
    wanted = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
    assert np.allclose(centres, np.array(wanted, float), atol=1e-2)
    # In OpenGL's order +x lies between +z and -z.
    assert np.allclose(way[0, :, -1], way[5, :, 0], atol=0.04)
    assert np.allclose(way[0, :, 0], way[4, :, -1], atol=0.04)


def test_the_committed_assets_are_the_generators(trashcan_generator: ModuleType, can: Mesh) -> None:
    made = trashcan_generator.can()
    assert np.array_equal(made["index"], can.index)
    for key in ("position", "normal", "tangent", "uv"):
        assert np.allclose(made[key], can.arrays[key], atol=1e-5), key
    texels = np.asarray(Image.open(FOLDER / "normals.png"), np.int64)
    assert np.abs(trashcan_generator.normal_map().astype(np.int64) - texels).max() <= 1
    with np.load(FOLDER / "environment.npz") as stored:
        kept = stored["faces"].astype(np.float64)
    assert np.allclose(trashcan_generator.environment().astype(np.float64), kept, rtol=0.01)


def test_size_of_the_files() -> None:
    assets = [p for p in FOLDER.iterdir() if p.suffix in (".npz", ".png")]
    assert sum(p.stat().st_size for p in assets) < 400_000

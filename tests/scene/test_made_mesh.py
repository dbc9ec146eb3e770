"""The knot: closed, its outside in front, with frames that fit its texture coordinates."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.scene.mesh import load_mesh
from shadercache.scene.models.load import load_model
from shadercache.scene.models.made_mesh import knot
from shadercache.scene.models.write_gltf import GltfWriter

AROUND, ACROSS = 200, 50


@pytest.fixture(scope="module")
def made() -> tuple[dict[str, np.ndarray], np.ndarray]:
    arrays, index = knot(AROUND, ACROSS)
    return dict(arrays), index


def test_it_has_no_gap_and_no_folds(made: tuple[dict[str, np.ndarray], np.ndarray]) -> None:
    arrays, index = made
    position, normal = arrays["position"], arrays["normal"]
    assert len(index) == 20_000 and set(index.ravel()) == set(range(len(position)))
    grid = position.reshape(AROUND + 1, ACROSS + 1, 3)
    assert grid[0] == pytest.approx(grid[-1]) and grid[:, 0] == pytest.approx(grid[:, -1])
    corners = position[index]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    for corner in range(3):
        assert ((faces * normal[index[:, corner]]).sum(1) > 0.0).all()
    # What a closed surface encloses has a volume, positive where its outside is in front.
    assert (corners[:, 0] * faces).sum() > 0.0


def test_frames_fit_texture_coordinates(made: tuple[dict[str, np.ndarray], np.ndarray]) -> None:
    arrays, _ = made
    normal, tangent = arrays["normal"], arrays["tangent"]
    assert (normal * tangent[:, :3]).sum(1) == pytest.approx(0.0, abs=1e-9)
    across = np.cross(normal, tangent[:, :3]) * tangent[:, 3:]
    grid = arrays["position"].reshape(AROUND + 1, ACROSS + 1, 3)
    step = np.diff(grid, axis=1)
    # The second coordinate grows where the bitangent points to.
    along = (step * across.reshape(AROUND + 1, ACROSS + 1, 3)[:, :-1]).sum(-1)
    assert (along > 0.0).all() and (np.diff(arrays["uv"].reshape(201, 51, 2)[0, :, 1]) > 0).all()


def test_a_model_and_a_mesh_keep_its_arrays(tmp_path: Path) -> None:
    arrays, index = knot(12, 6)
    writer = GltfWriter()
    writer.hung(writer.mesh(arrays, index), "knot")
    [part] = load_model(writer.glb(tmp_path / "k.glb")).parts
    np.savez(tmp_path / "k.npz", index=index.astype(np.uint32), **dict(arrays))
    mesh = load_mesh(tmp_path / "k.npz")
    for name, values in arrays.items():
        assert part.arrays[name] == pytest.approx(values, abs=1e-6), name
        assert mesh.arrays[name] == pytest.approx(values, abs=1e-6), name
    assert part.name == "knot" and part.computed == {"bitangent"}
    assert (part.index == index).all() and (mesh.index == index).all()

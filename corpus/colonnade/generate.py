"""Makes the colonnade: a fluted column, the steps it stands on, the beams it bears, the land.

Run as ``python corpus/colonnade/generate.py`` (needs no more than numpy). Nobody has to: what it
makes is committed. Metres; y is up.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

HERE = Path(__file__).parent
Mesh = dict[str, npt.NDArray[Any]]
Floats = npt.NDArray[np.float64]
Faces = npt.NDArray[np.int64]

FLUTES, PER_FLUTE = 20, 3
SHAFT = 5.0
"""Height of a shaft without its capital."""
ROWS, COLUMNS, STEP = 17, 8, 2.2
"""Columns along the sides and across the fronts, and how far apart they stand."""


def column(per_flute: int = PER_FLUTE, rings: int = 5) -> Mesh:
    """A Doric column: a tapering shaft with hollow flutes, a cushion and a slab on top."""
    around = FLUTES * per_flute
    angle = np.arange(around) * (2.0 * np.pi / around)
    hollow = np.sin(np.pi * (np.arange(around) % per_flute) / per_flute) ** 2
    heights = np.linspace(0.0, SHAFT, rings)
    swell = 0.46 - 0.10 * (heights / SHAFT) ** 1.6
    rows = [
        _ring(angle, r * (1.0 - 0.075 * hollow), y) for r, y in zip(swell, heights, strict=True)
    ]
    cushion = [(0.36, SHAFT), (0.40, SHAFT + 0.06), (0.50, SHAFT + 0.20), (0.52, SHAFT + 0.26)]
    rows += [_ring(angle, np.full(around, r), y) for r, y in cushion]
    shaft = _joined(np.asarray(rows[:rings]))
    neck = _joined(np.asarray(rows[rings:]))
    slab = box((-0.56, SHAFT + 0.26, -0.56), (0.56, SHAFT + 0.46, 0.56))
    return merged([smooth(*shaft), smooth(*neck), slab])


def _ring(angle: Floats, radius: Floats, height: float) -> Floats:
    return np.stack(
        [radius * np.sin(angle), np.full(len(angle), height), radius * np.cos(angle)], -1
    )


def _joined(rows: Floats) -> tuple[Floats, Faces]:
    """Vertices and outward faces between rings (rings, around, 3), from below to above."""
    rings, around, _ = rows.shape
    i, j = np.meshgrid(np.arange(rings - 1), np.arange(around), indexing="ij")
    here, right = i * around + j, i * around + (j + 1) % around
    quads = [here, right, right + around, here, right + around, here + around]
    return rows.reshape(-1, 3), np.stack(quads, axis=-1).reshape(-1, 3)


def smooth(position: Floats, faces: Faces) -> Mesh:
    """A mesh whose normals are the faces' around each vertex."""
    a, b, c = (position[faces[:, corner]] for corner in range(3))
    cross = np.cross(b - a, c - a)
    normal = np.zeros_like(position)
    for corner in range(3):
        np.add.at(normal, faces[:, corner], cross)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return {"position": position, "normal": normal, "index": faces}


def box(low: tuple[float, float, float], high: tuple[float, float, float], cells: int = 1) -> Mesh:
    """A box; its sides are cut into squares of cells, so that depth is even on large ones."""
    corners = np.array([low, high], np.float64)
    parts = []
    for axis in range(3):
        for side in (0, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            s, t = np.meshgrid(
                np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1), indexing="ij"
            )
            position = np.empty(((cells + 1) ** 2, 3))
            position[:, axis] = corners[side, axis]
            position[:, u] = corners[0, u] + s.ravel() * (corners[1, u] - corners[0, u])
            position[:, v] = corners[0, v] + t.ravel() * (corners[1, v] - corners[0, v])
            i, j = np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij")
            here = i * (cells + 1) + j
            quads = [here, here + cells + 1, here + cells + 2, here, here + cells + 2, here + 1]
            index = np.stack(quads, axis=-1).reshape(-1, 3)
            normal = np.zeros_like(position)
            normal[:, axis] = 1.0 if side else -1.0
            parts.append(
                {"position": position, "normal": normal, "index": index if side else index[:, ::-1]}
            )
    return merged(parts)


def merged(parts: list[Mesh]) -> Mesh:
    """Several meshes as one."""
    starts = np.cumsum([0, *(len(part["position"]) for part in parts)])[:-1]
    return {
        "position": np.concatenate([part["position"] for part in parts]),
        "normal": np.concatenate([part["normal"] for part in parts]),
        "index": np.concatenate(
            [part["index"] + at for part, at in zip(parts, starts, strict=True)]
        ),
    }


def extent() -> tuple[float, float]:
    """Half of the outer colonnade's width (x) and length (z), between the columns' middles."""
    return 0.5 * STEP * (COLUMNS - 1), 0.5 * STEP * (ROWS - 1)


def places() -> list[tuple[float, float, float]]:
    """Where the columns stand: a ring around, and two rows inside."""
    x, z = extent()
    across, along = np.linspace(-x, x, COLUMNS), np.linspace(-z, z, ROWS)
    ring = [(side * x, 0.0, at) for at in along for side in (-1.0, 1.0)]
    ring += [(at, 0.0, side * z) for at in across[1:-1] for side in (-1.0, 1.0)]
    inner = [(side * 0.35 * x, 0.0, at) for at in along[3:-3] for side in (-1.0, 1.0)]
    return [(round(float(px), 3), 0.0, round(float(pz), 3)) for px, _, pz in (*ring, *inner)]


def steps() -> Mesh:
    """Three steps all around."""
    x, z = extent()
    parts = [
        box((-x - out, low, -z - out), (x + out, low + 0.30, z + out), cells=12)
        for out, low in ((0.9, -0.30), (1.3, -0.60), (1.7, -0.90))
    ]
    return merged(parts)


def beams() -> Mesh:
    """What lies on the columns: beams around and over the inner rows, and some of the roof."""
    x, z = extent()
    low, high = SHAFT + 0.46, SHAFT + 1.3
    wide, ends = 0.45, (-1.0, 1.0)
    parts = [
        box((end * x - wide, low, -z - wide), (end * x + wide, high, z + wide), cells=10)
        for end in ends
    ]
    parts += [
        box((end * 0.35 * x - 0.4, low, 4.0 - z), (end * 0.35 * x + 0.4, high, z - 4.0), cells=10)
        for end in ends
    ]
    parts += [
        box((wide - x, low, end * z - wide), (x - wide, high, end * z + wide), cells=6)
        for end in ends
    ]
    parts += [
        box((wide - x, high - 0.35, at - 0.14), (x - wide, high - 0.05, at + 0.14), cells=4)
        for at in np.linspace(3.3 - z, z - 3.3, 9)
    ]
    return merged(parts)


def land(cells: int = 40, radius: float = 60.0) -> Mesh:
    """Ground that falls away in low hills."""
    side = (
        radius * np.linspace(-1.0, 1.0, cells + 1) ** 3 * 0.5
        + np.linspace(-0.5, 0.5, cells + 1) * radius
    )
    x, z = np.meshgrid(side, side, indexing="ij")
    away = np.maximum(np.hypot(x / 16.0, z / 25.0) - 1.0, 0.0)
    hills = (
        -1.0
        - 1.2 * away
        + 2.6 * np.minimum(away, 1.0) * (np.sin(0.11 * x) * np.cos(0.09 * z + 1.0))
    )
    position = np.stack([x, hills, z], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij")
    here = i * (cells + 1) + j
    quads = [here, here + 1, here + cells + 2, here, here + cells + 2, here + cells + 1]
    return smooth(position, np.stack(quads, axis=-1).reshape(-1, 3))


def sky(around: int = 32, radius: float = 80.0) -> Mesh:
    """A dome, seen from inside."""
    turn = np.arange(around) * (2.0 * np.pi / around)
    up = np.radians([-20.0, 0.0, 15.0, 35.0, 60.0, 89.0])
    rows = [_ring(turn, np.full(around, radius * np.cos(a)), radius * np.sin(a)) for a in up]
    position, faces = _joined(np.asarray(rows))
    return smooth(position, faces[:, ::-1])


def save(path: Path, mesh: Mesh) -> None:
    """Writes a mesh with its normals in 8 bits."""
    np.savez_compressed(
        path,
        position=mesh["position"].astype(np.float32),
        normal_i8=np.round(mesh["normal"] * 127.0).astype(np.int8),
        index_delta=np.diff(mesh["index"].ravel(), prepend=0).astype(np.int32),
    )


def main() -> None:
    """Writes every asset into the folder given by ``--output`` (default: beside this file)."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("--output", type=Path, default=HERE)
    out: Path = arguments.parse_args().output
    save(out / "column.npz", column())
    save(out / "column-small.npz", column(per_flute=1, rings=2))
    for make in (steps, beams, land, sky):
        save(out / f"{make.__name__}.npz", make())
    print("places = [")
    for place in places():
        print(f"    {list(place)},")
    print("]")


if __name__ == "__main__":
    main()

"""The shape of the trash can: a dented, ribbed wall, a domed lid and two kinds of handles.

+y is up, the can stands around the y axis and is about 1.7 units tall. Everything is a sheet: a
grid of points whose rows run along one curve and whose columns run along another.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Mesh = dict[str, npt.NDArray[Any]]

AROUND = 26
"""Segments around the can."""
TILES = 4.0
"""Repetitions of the normal map around the can."""

WALL = np.array(
    [
        (0.505, -0.850),
        (0.540, -0.835),
        (0.540, -0.780),
        (0.515, -0.760),
        (0.525, -0.380),
        (0.553, -0.340),
        (0.528, -0.300),
        (0.540, 0.060),
        (0.568, 0.100),
        (0.543, 0.140),
        (0.553, 0.520),
        (0.595, 0.545),
        (0.595, 0.590),
    ]
)
"""Outline (radius, height) of the wall from the bottom up, with a foot, two ribs and a rim."""
LID = np.array(
    [(0.650, 0.550), (0.650, 0.610), (0.600, 0.640), (0.500, 0.700), (0.270, 0.770), (0.0, 0.795)]
)
"""Outline (radius, height) of the lid from its lip to its top."""
DENTS = (
    (0.9, -0.10, 0.42, 0.26, 0.085),
    (2.3, 0.33, 0.30, 0.20, 0.060),
    (3.4, -0.55, 0.45, 0.22, 0.070),
    (4.6, 0.22, 0.36, 0.30, 0.075),
    (5.5, -0.33, 0.30, 0.18, 0.055),
    (1.7, 0.58, 0.35, 0.14, 0.045),
)
"""Dents: angle, height, extent along both (radians, units), depth."""


def can() -> Mesh:
    """All parts as one mesh: position, normal, tangent (n, 3), uv (n, 2) f4; index (m, 3) i4."""
    sheets = [_lathe(WALL, dented=True), _lathe(LID, dented=False), _disc(), _grip()]
    sheets += [_ear(side) for side in (1.0, -1.0)]
    start, faces = 0, []
    for points, _ in sheets:
        faces.append(_faces(points.shape[0], points.shape[1]) + start)
        start += points.shape[0] * points.shape[1]
    frames = [_frames(points) for points, _ in sheets]
    index = np.concatenate(faces)
    position = np.concatenate([points.reshape(-1, 3) for points, _ in sheets])
    corners = position[index]
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    return {
        "position": position.astype(np.float32),
        "normal": np.concatenate([n for n, _ in frames]).astype(np.float32),
        "tangent": np.concatenate([t for _, t in frames]).astype(np.float32),
        "uv": np.concatenate([uv.reshape(-1, 2) for _, uv in sheets]).astype(np.float32),
        "index": index[area > 1e-9].astype(np.int32),
    }


def _lathe(outline: Floats, dented: bool) -> tuple[Floats, Floats]:
    """An outline turned about the y axis: points (rows, columns, 3) and uv (rows, columns, 2)."""
    angle = np.linspace(0.0, 2.0 * np.pi, AROUND + 1)
    radius, height = (np.repeat(outline[:, i, None], AROUND + 1, axis=1) for i in (0, 1))
    if dented:
        for at, level, width, tall, depth in DENTS:
            turn = np.angle(np.exp(1j * (angle - at)))[None]
            bump = np.exp(-((turn / width) ** 2) - ((height - level) / tall) ** 2)
            radius = radius - depth * bump
    points = np.stack([radius * np.sin(angle), height, radius * np.cos(angle)], axis=-1)
    length = np.linalg.norm(np.diff(outline, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(length)]) * TILES / (2.0 * np.pi * 0.55)
    across = np.linspace(0.0, TILES, AROUND + 1)
    return points, np.stack(np.meshgrid(across, along), axis=-1)


def _disc() -> tuple[Floats, Floats]:
    """The bottom, facing down."""
    return _lathe(np.array([(0.0, -0.835), (0.505, -0.850)]), dented=False)


def _tube(path: Floats, radius: float, sides: int) -> tuple[Floats, Floats]:
    """A tube along a plane path (n, 3): its cross-section turns from the path's normal."""
    ahead = np.gradient(path, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    plane = np.cross(path[0] - path[len(path) // 2], path[-1] - path[len(path) // 2])
    plane /= np.linalg.norm(plane)
    out = np.cross(plane, ahead)
    angle = np.linspace(0.0, 2.0 * np.pi, sides + 1)[None, :, None]
    ring = np.cos(angle) * out[:, None] + np.sin(angle) * plane[None, None]
    u, v = np.meshgrid(np.linspace(0.0, 0.25, sides + 1), np.linspace(0.0, 1.0, len(path)))
    return path[:, None] + radius * ring, np.stack([u, v], axis=-1)


def _grip() -> tuple[Floats, Floats]:
    """The handle on the lid: a flat arch."""
    t = np.linspace(-1.0, 1.0, 7)
    path = np.stack([0.19 * t, 0.765 + 0.11 * (1.0 - t**4), 0.0 * t], axis=-1)
    return _tube(path, 0.026, 5)


def _ear(side: float) -> tuple[Floats, Floats]:
    """A handle on the wall: an arch that stands out to the side."""
    t = np.linspace(-1.0, 1.0, 6)
    path = np.stack(
        [side * (0.54 + 0.13 * (1.0 - t**4)), 0.36 - 0.06 * (1.0 - t**4), 0.17 * t], axis=-1
    )
    return _tube(path, 0.024, 4)


def _faces(rows: int, columns: int) -> npt.NDArray[np.int64]:
    """Two triangles for every cell of a grid, seen counter-clockwise from outside."""
    a = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)[None]).ravel()
    b, c, d = a + 1, a + columns + 1, a + columns
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def _frames(points: Floats) -> tuple[Floats, Floats]:
    """Normals and tangents (n, 3) of a sheet which closes on itself along its rows."""
    closed = np.concatenate([points[:, -2:-1], points, points[:, 1:2]], axis=1)
    across = closed[:, 2:] - closed[:, :-2]
    along = np.gradient(points, axis=0)
    middle = points.mean(axis=1, keepdims=True)
    tip = np.linalg.norm(across, axis=-1, keepdims=True) < 1e-9
    normal = np.cross(across, along)
    size = np.linalg.norm(normal, axis=-1, keepdims=True)
    pole = np.array([0.0, np.sign(middle.mean(axis=(0, 1))[1]), 0.0])
    normal = np.where(size < 1e-9, pole, normal / np.maximum(size, 1e-9))
    tangent = np.where(tip, np.array([1.0, 0.0, 0.0]), across)
    tangent = tangent - normal * (normal * tangent).sum(axis=-1, keepdims=True)
    tangent /= np.maximum(np.linalg.norm(tangent, axis=-1, keepdims=True), 1e-9)
    return normal.reshape(-1, 3), tangent.reshape(-1, 3)

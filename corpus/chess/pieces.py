"""The shapes of board and pieces: turned on a lathe, swept along a curve, or sawn as boxes.

A square of the board is 1 wide, its top lies at y = 0, and pieces stand on it at the origin,
looking along -z, the way White plays.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Mesh = dict[str, npt.NDArray[Any]]
Floats = npt.NDArray[np.float64]
Profile = list[tuple[float, float]]

FOOT: Profile = [(0.33, 0.0), (0.34, 0.06), (0.30, 0.11), (0.27, 0.13), (0.25, 0.18)]
"""Radius and height of the ring that every piece stands on."""

STEMS: dict[str, Profile] = {
    "pawn": [
        *((0.17, 0.26), (0.115, 0.42), (0.10, 0.54), (0.18, 0.58), (0.17, 0.61), (0.10, 0.63)),
        *((0.165, 0.70), (0.18, 0.78), (0.15, 0.87), (0.08, 0.93), (0.0, 0.95)),
    ],
    "rook": [
        *((0.20, 0.30), (0.175, 0.55), (0.175, 0.66), (0.24, 0.72), (0.25, 0.76), (0.25, 0.90)),
        *((0.17, 0.90), (0.16, 0.80), (0.0, 0.80)),
    ],
    "bishop": [
        *((0.17, 0.30), (0.115, 0.55), (0.10, 0.78), (0.19, 0.83), (0.18, 0.86), (0.10, 0.89)),
        *((0.16, 0.97), (0.175, 1.05), (0.13, 1.17), (0.05, 1.26), (0.06, 1.30), (0.04, 1.34)),
        (0.0, 1.35),
    ],
    "queen": [
        *((0.19, 0.32), (0.125, 0.62), (0.11, 0.96), (0.21, 1.02), (0.20, 1.05), (0.12, 1.08)),
        *((0.14, 1.20), (0.21, 1.42), (0.16, 1.42), (0.11, 1.46), (0.06, 1.49), (0.07, 1.54)),
        *((0.04, 1.58), (0.0, 1.585)),
    ],
    "king": [
        *((0.20, 0.34), (0.135, 0.66), (0.12, 1.04), (0.22, 1.10), (0.21, 1.14), (0.13, 1.17)),
        *((0.15, 1.28), (0.21, 1.46), (0.19, 1.50), (0.10, 1.55), (0.05, 1.58), (0.0, 1.585)),
    ],
    "knight": [(0.21, 0.23), (0.20, 0.27), (0.12, 0.28), (0.0, 0.28)],
}
"""What stands on the foot."""

NECK = [
    # z, y of the middle; z, y of the way to the mane; half length along it, half width
    *((0.02, 0.26, 1.0, 0.00, 0.190, 0.150), (0.05, 0.42, 1.0, 0.10, 0.185, 0.120)),
    *((0.06, 0.58, 1.0, 0.25, 0.175, 0.105), (0.035, 0.74, 0.9, 0.55, 0.170, 0.100)),
    *((-0.03, 0.86, 0.5, 0.90, 0.160, 0.095), (-0.12, 0.87, -0.05, 1.0, 0.130, 0.090)),
    *((-0.21, 0.81, -0.3, 1.0, 0.105, 0.078), (-0.29, 0.74, -0.35, 1.0, 0.090, 0.070)),
    *((-0.335, 0.70, -0.4, 1.0, 0.070, 0.056), (-0.350, 0.69, -0.4, 1.0, 0.010, 0.010)),
]
"""Sections of a horse from its chest to its muzzle."""


def piece(kind: str, around: int) -> Mesh:
    """A piece by its name; ``around``: sides of what was turned."""
    profile = FOOT + STEMS[kind]
    ripple = 8 if kind == "queen" and around >= 16 else 0
    parts = [lathe(profile if around >= 16 else profile[::2] + profile[-1:], around, ripple)]
    if kind == "rook":
        parts += [_crenel(turn) for turn in np.arange(6) * np.pi / 3.0]
    if kind == "knight":
        ear = [box((side - 0.02, 0.93, -0.05), (side + 0.02, 1.06, 0.01)) for side in (-0.05, 0.05)]
        mane = box((-0.025, 0.40, 0.18), (0.025, 0.86, 0.24))
        parts += [_swept(max(around // 2, 6)), turned(mane, 0, -0.16), *ear]
    if kind == "king":
        parts += [
            box((-0.035, 1.56, -0.035), (0.035, 1.86, 0.035)),
            box((-0.11, 1.70, -0.034), (0.11, 1.77, 0.034)),
        ]
    return merged(parts)


def lathe(profile: Profile, around: int, ripple: int = 0) -> Mesh:
    """A profile turned about the y axis; a rim with ``ripple`` points where there are any."""
    radius, height = np.array(profile).T
    angle = np.linspace(0.0, 2.0 * np.pi, around + 1)
    # A coronet: its points rise where the profile is widest above the collar.
    rim = np.where((height > 1.3) & (radius > 0.2), 0.05, 0.0)[:, None]
    y = height[:, None] + rim * np.cos(ripple * angle) * (ripple > 0)
    rings = np.stack([radius[:, None] * np.sin(angle), y, radius[:, None] * np.cos(angle)], -1)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(radius), np.diff(height)))])
    u, v = np.broadcast_arrays(angle / np.pi, along[:, None])
    return _sheet(rings, np.stack([u, v], -1))


def _swept(around: int) -> Mesh:
    """The knight's neck and head: ellipses strung along a curve."""
    z, y, along_z, along_y, length, width = np.array(NECK).T[..., None]
    angle = np.linspace(0.0, 2.0 * np.pi, around + 1)
    scale = length / np.hypot(along_z, along_y)
    x = width * np.sin(angle)
    out = scale * np.cos(angle)
    rings = np.stack([x, y + along_y * out, z + along_z * out], -1)
    u, v = np.broadcast_arrays(angle / np.pi, np.linspace(0.0, 1.0, len(NECK))[:, None])
    return _sheet(rings, np.stack([u, v], -1))


def _sheet(rows: Floats, uv: Floats) -> Mesh:
    """Points (rows, around, 3) as a surface whose first and last column coincide."""
    height, around, _ = rows.shape
    i, j = np.meshgrid(np.arange(height - 1), np.arange(around - 1), indexing="ij")
    here = i * around + j
    corners = [here, here + 1, here + around + 1, here, here + around + 1, here + around]
    index = np.stack(corners, -1).reshape(-1, 3)
    position = rows.reshape(-1, 3)
    a, b, c = (position[index[:, corner]] for corner in range(3))
    cross = np.cross(b - a, c - a)
    index, cross = index[cross.any(-1)], cross[cross.any(-1)]
    normal = np.zeros_like(position)
    for corner in range(3):
        np.add.at(normal, index[:, corner], cross)
    normal = normal.reshape(rows.shape)
    normal[:, 0] = normal[:, -1] = normal[:, 0] + normal[:, -1]
    normal = normal.reshape(-1, 3)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-12)
    normal[~normal.any(-1)] = (0.0, 1.0, 0.0)
    return {"position": position, "normal": normal, "uv": uv.reshape(-1, 2), "index": index}


def box(low: tuple[float, float, float], high: tuple[float, float, float], cells: int = 1) -> Mesh:
    """A box whose sides are cut into squares of cells."""
    corners = np.array([low, high])
    parts = []
    for axis in range(3):
        for side in (0, 1):
            s, t = np.meshgrid(*[np.linspace(0.0, 1.0, cells + 1)] * 2, indexing="ij")
            position = np.empty(((cells + 1) ** 2, 3))
            position[:, axis] = corners[side, axis]
            for way, share in (((axis + 1) % 3, s), ((axis + 2) % 3, t)):
                position[:, way] = corners[0, way] + share.ravel() * np.ptp(corners[:, way])
            i, j = np.meshgrid(*[np.arange(cells)] * 2, indexing="ij")
            here = i * (cells + 1) + j
            quads = [here, here + cells + 1, here + cells + 2, here, here + cells + 2, here + 1]
            index = np.stack(quads, -1).reshape(-1, 3)
            normal = np.zeros_like(position)
            normal[:, axis] = 2.0 * side - 1.0
            uv = position[:, [(axis + 1) % 3, (axis + 2) % 3]]
            index = index if side else index[:, ::-1]
            parts.append({"position": position, "normal": normal, "uv": uv, "index": index})
    return merged(parts)


def _crenel(turn: float) -> Mesh:
    return turned(box((-0.065, 0.88, 0.175), (0.065, 1.0, 0.245)), 1, turn)


def turned(mesh: Mesh, axis: int, turn: float) -> Mesh:
    """A mesh turned about a coordinate axis, in radians."""
    matrix = np.eye(3)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    matrix[[first, second], [first, second]] = np.cos(turn)
    matrix[second, first], matrix[first, second] = np.sin(turn), -np.sin(turn)
    return {**mesh, "position": mesh["position"] @ matrix.T, "normal": mesh["normal"] @ matrix.T}


def moved(mesh: Mesh, x: float, z: float) -> Mesh:
    """A mesh somewhere else on the board."""
    return {**mesh, "position": mesh["position"] + (x, 0.0, z)}


def merged(parts: list[Mesh]) -> Mesh:
    """Several meshes as one."""
    starts = np.cumsum([0, *(len(part["position"]) for part in parts)])[:-1]
    index = [part["index"] + start for part, start in zip(parts, starts, strict=True)]
    arrays = {
        name: np.concatenate([part[name] for part in parts])
        for name in ("position", "normal", "uv")
    }
    return {**arrays, "index": np.concatenate(index)}

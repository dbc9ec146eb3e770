"""Normals and tangents of triangle meshes that come without them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]
Index = NDArray[np.uint32]


def complete(arrays: dict[str, Floats], index: Index) -> set[str]:
    """Add the directions that shaders may want and that are not there; returns their names."""
    added: set[str] = set()
    if "normal" not in arrays:
        arrays["normal"] = normals_of(arrays["position"], index)
        added.add("normal")
    if "tangent" not in arrays and "uv" in arrays:
        arrays["tangent"] = tangents_of(arrays["position"], arrays["normal"], arrays["uv"], index)
        added.add("tangent")
    if "tangent" in arrays:
        arrays["bitangent"] = bitangents_of(arrays["normal"], arrays["tangent"])
        added.add("bitangent")
    return added


def normals_of(position: Floats, index: Index) -> Floats:
    """Unit normals of vertices: those of their triangles, by area. Vertices are not split."""
    corners = position.astype(np.float64)[index]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return _unit(_gathered(across, index, len(position)), (0.0, 0.0, 1.0)).astype(np.float32)


def tangents_of(position: Floats, normal: Floats, uv: Floats, index: Index) -> Floats:
    """Tangents (n, 4) along u, at right angles to the normal; the last number is the sign of v."""
    corners, places = position.astype(np.float64)[index], uv.astype(np.float64)[index]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    a, b = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]
    area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    scale = np.divide(1.0, area, out=np.zeros_like(area), where=area != 0.0)[:, None]
    along_u = _gathered((first * b[:, 1:2] - second * a[:, 1:2]) * scale, index, len(position))
    along_v = _gathered((second * a[:, 0:1] - first * b[:, 0:1]) * scale, index, len(position))
    up = normal.astype(np.float64)
    flat = _unit(along_u - up * (up * along_u).sum(1, keepdims=True), (1.0, 0.0, 0.0))
    sign = np.where((np.cross(up, flat) * along_v).sum(1) < 0.0, -1.0, 1.0)
    return np.concatenate([flat, sign[:, None]], 1).astype(np.float32)


def bitangents_of(normal: Floats, tangent: Floats) -> Floats:
    """The third direction, along v."""
    across = np.cross(normal, tangent[:, :3]) * tangent[:, 3:4]
    return np.ascontiguousarray(across, np.float32)


def _gathered(values: NDArray[np.float64], index: Index, count: int) -> NDArray[np.float64]:
    """The sum over the triangles of each vertex."""
    flat, every = index.ravel(), np.repeat(values, 3, axis=0)
    sums = [np.bincount(flat, every[:, axis], count) for axis in range(3)]
    return np.stack(sums, 1)


def _unit(values: NDArray[np.float64], instead: tuple[float, ...]) -> NDArray[np.float64]:
    length = np.linalg.norm(values, axis=1, keepdims=True)
    found: NDArray[np.float64] = np.where(
        length > 0.0, values / np.maximum(length, 1e-300), instead
    )
    return found

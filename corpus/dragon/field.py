"""Implicit solids on a regular grid: tapered capsules, ellipsoids and thick triangles.

Every part knows the box it fills, so a part is evaluated only where it can change the surface.
Distances are exact for capsules of equal radii and for triangles, close enough for the rest:
only the neighbourhood of the zero level is ever used.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float32]
Point = Sequence[float] | npt.NDArray[np.floating]
Axes = tuple[Array, Array, Array]

FAR = np.float32(0.5)
"""Value of the field where no part reaches."""


@dataclass(frozen=True)
class Part:
    """A solid: signed distance (negative inside) at broadcastable x, y, z, and its box."""

    distance: Callable[[Array, Array, Array], Array]
    low: Array
    high: Array


def _vector(point: Point) -> Array:
    return np.asarray(point, dtype=np.float32)


def capsule(a: Point, b: Point, radius_a: float, radius_b: float) -> Part:
    """A segment from ``a`` to ``b`` whose radius runs linearly from one end to the other."""
    start, end = _vector(a), _vector(b)
    axis = end - start
    inverse = np.float32(1.0 / max(float(axis @ axis), 1e-12))

    def distance(x: Array, y: Array, z: Array) -> Array:
        px, py, pz = x - start[0], y - start[1], z - start[2]
        t = np.clip((px * axis[0] + py * axis[1] + pz * axis[2]) * inverse, 0.0, 1.0)
        dx, dy, dz = px - t * axis[0], py - t * axis[1], pz - t * axis[2]
        radius = np.float32(radius_a) + t * np.float32(radius_b - radius_a)
        return np.asarray(np.sqrt(dx * dx + dy * dy + dz * dz) - radius, np.float32)

    low = np.minimum(start - radius_a, end - radius_b)
    high = np.maximum(start + radius_a, end + radius_b)
    return Part(distance, _vector(low), _vector(high))


def ellipsoid(centre: Point, radii: Point) -> Part:
    """An ellipsoid with axes along x, y, z (distance scaled to be right near the surface)."""
    middle, extent = _vector(centre), _vector(radii)

    def distance(x: Array, y: Array, z: Array) -> Array:
        qx, qy, qz = ((v - c) / r for v, c, r in zip((x, y, z), middle, extent, strict=True))
        near = np.sqrt(qx * qx + qy * qy + qz * qz)
        slope = np.sqrt((qx / extent[0]) ** 2 + (qy / extent[1]) ** 2 + (qz / extent[2]) ** 2)
        return np.asarray(near * (near - 1.0) / np.maximum(slope, 1e-6), np.float32)

    return Part(distance, middle - extent, middle + extent)


def triangle(a: Point, b: Point, c: Point, thickness: float) -> Part:
    """All points within ``thickness`` of a triangle: a plate with round edges.

    A triangle without area is taken for its longest edge.
    """
    corners = [_vector(p) for p in (a, b, c)]
    edges = [corners[(i + 1) % 3] - corners[i] for i in range(3)]
    normal = np.cross(edges[0], edges[1])
    walls = [np.cross(edge, normal) for edge in edges]
    area = float(normal @ normal)  # squared, times four
    if area < 1e-12:
        return max(
            (capsule(p, q, thickness, thickness) for p, q in combinations(corners, 2)), key=_size
        )

    def distance(x: Array, y: Array, z: Array) -> Array:
        to_edge, outside = [], []
        for corner, edge, wall in zip(corners, edges, walls, strict=True):
            p = (x - corner[0], y - corner[1], z - corner[2])
            t = np.clip(_dot(p, edge) / max(float(edge @ edge), 1e-12), 0.0, 1.0)
            dx, dy, dz = (v - t * e for v, e in zip(p, edge, strict=True))
            to_edge.append(dx * dx + dy * dy + dz * dz)
            outside.append(_dot(p, wall) > 0.0)
        plane = _dot((x - corners[0][0], y - corners[0][1], z - corners[0][2]), normal)
        squared = np.where(
            np.logical_or.reduce(outside),
            np.minimum.reduce(to_edge),
            plane * plane / np.float32(area),
        )
        return np.asarray(np.sqrt(squared) - np.float32(thickness), np.float32)

    low = np.minimum.reduce(corners) - thickness
    high = np.maximum.reduce(corners) + thickness
    return Part(distance, _vector(low), _vector(high))


def _size(part: Part) -> float:
    return float(np.linalg.norm(part.high - part.low))


def _dot(point: tuple[Array, Array, Array], axis: Array) -> Array:
    return np.asarray(point[0] * axis[0] + point[1] * axis[1] + point[2] * axis[2])


class Field:
    """Signed distances on a grid of ``step`` over the box ``low`` .. ``high`` (object space)."""

    def __init__(self, low: Point, high: Point, step: float) -> None:
        self.low = np.asarray(low, dtype=np.float64)
        self.step = step
        shape = np.ceil((np.asarray(high, np.float64) - self.low) / step).astype(int) + 1
        self.values: Array = np.full(shape, FAR, dtype=np.float32)

    def union(self, parts: Sequence[Part], blend: float) -> None:
        """Joins parts: sharply with one another, smoothly within ``blend`` with what is there."""
        margin = blend + 2.0 * self.step
        whole = self._box(
            np.minimum.reduce([p.low for p in parts]) - margin,
            np.maximum.reduce([p.high for p in parts]) + margin,
        )
        mine = np.full(self.values[whole].shape, FAR, dtype=np.float32)
        for part in parts:
            box = self._box(part.low - margin, part.high + margin)
            inner = tuple(
                slice(s.start - w.start, s.stop - w.start) for s, w in zip(box, whole, strict=True)
            )
            mine[inner] = np.minimum(mine[inner], part.distance(*self._axes(box)))
        self.values[whole] = smooth_minimum(self.values[whole], mine, blend)

    def _box(self, low: Array, high: Array) -> tuple[slice, ...]:
        first = np.floor((low - self.low) / self.step).astype(int)
        last = np.ceil((high - self.low) / self.step).astype(int) + 1
        return tuple(
            slice(max(int(a), 0), min(int(b), n))
            for a, b, n in zip(first, last, self.values.shape, strict=True)
        )

    def _axes(self, box: tuple[slice, ...]) -> Axes:
        x, y, z = (
            np.asarray(self.low[i] + self.step * np.arange(s.start, s.stop), np.float32)
            for i, s in enumerate(box)
        )
        return x[:, None, None], y[None, :, None], z[None, None, :]


def smooth_minimum(a: Array, b: Array, blend: float) -> Array:
    """The smaller of two distances, rounded off where they differ by less than ``blend``."""
    if blend <= 0.0:
        return np.minimum(a, b)
    overlap = np.maximum(blend - np.abs(a - b), 0.0) / np.float32(blend)
    return np.asarray(np.minimum(a, b) - overlap**3 * np.float32(blend / 6.0), np.float32)

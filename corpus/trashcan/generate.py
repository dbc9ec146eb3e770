"""Makes the trash can: its mesh, the normal map of its metal and the room it reflects.

Run as ``python corpus/trashcan/generate.py`` (needs the ``assets`` extra). Nobody has to: what it
makes is committed.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import numpy.typing as npt
from can import can
from PIL import Image
from scipy.ndimage import gaussian_filter

HERE = Path(__file__).parent
Floats = npt.NDArray[np.float64]

FOOT = -0.30
"""Sine of the angle at which the houses stand on the paving: they are near."""
SUN = (0.42, 0.62, 0.66)
"""Towards the sun; not quite of unit length, which does not matter."""


def height_map(size: int, seed: int = 5) -> Floats:
    """Tiling heights (size, size) of battered metal: ribs, knocks, spangle and scratches."""
    random = np.random.Generator(np.random.PCG64(seed))
    x = np.arange(size) / size
    ribs = 0.011 * np.cos(2.0 * np.pi * 5.0 * x)[None, :] * np.ones((size, 1))
    knocks = gaussian_filter(random.normal(size=(size, size)), size / 20.0, mode="wrap")
    grain = gaussian_filter(random.normal(size=(size, size)), size / 110.0, mode="wrap")
    scratches = np.zeros((size, size))
    for _ in range(70):
        length, angle = random.uniform(0.05, 0.35), random.uniform(-0.5, 0.5) + np.pi / 2
        start, depth = random.uniform(size=2), random.uniform(0.3, 1.0)
        t = np.linspace(0.0, length, int(length * size * 2))
        column = ((start[0] + t * np.cos(angle)) * size).astype(int) % size
        row = ((start[1] + t * np.sin(angle)) * size).astype(int) % size
        scratches[row, column] = np.maximum(scratches[row, column], depth)
    scratches = gaussian_filter(scratches, 1.1, mode="wrap")
    return np.asarray(
        ribs
        + 0.0045 * knocks / knocks.std()
        + 0.0003 * grain / grain.std()
        - 0.0016 * scratches / scratches.max()
    )


def normal_map(size: int = 256) -> npt.NDArray[np.uint8]:
    """Tangent-space normals (size, size, 3) of the height map, 0.5 + 0.5 n in 8 bits."""
    height = height_map(size)
    slope_x, slope_y = (
        (np.roll(height, -1, axis) - np.roll(height, 1, axis)) * size / 2.0 for axis in (1, 0)
    )
    normal = np.stack([-slope_x, -slope_y, np.ones_like(height)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.round((normal * 0.5 + 0.5) * 255.0).astype(np.uint8)


def directions(size: int) -> Floats:
    """Unit vectors (6, size, size, 3) through the texels of a cube map, in OpenGL's face order."""
    at = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    s, t = np.meshgrid(at, at)
    one = np.ones_like(s)
    faces = [(one, -t, -s), (-one, -t, s), (s, one, t), (s, -one, -t), (s, -t, one), (-s, -t, -one)]
    result = np.stack([np.stack(face, axis=-1) for face in faces])
    return np.asarray(result / np.linalg.norm(result, axis=-1, keepdims=True))


def environment(size: int = 64, rough: float = 0.13, rays: int = 128) -> npt.NDArray[np.float16]:
    """Radiance (6, size, size, 4) of the yard as rough metal sees it.

    Every texel is the mean over ``rays`` directions that scatter around its own by ``rough``
    (standard deviation, radians).
    """
    random = np.random.Generator(np.random.PCG64(3))
    way = directions(size)
    total = np.zeros_like(way)
    for offset in random.normal(scale=rough, size=(rays, 3)):
        bent = way + offset
        total += yard(bent / np.linalg.norm(bent, axis=-1, keepdims=True))
    one = np.ones((*way.shape[:-1], 1))
    return np.concatenate([total / rays, one], axis=-1).astype(np.float16)


def yard(way: Floats) -> Floats:
    """Radiance (..., 3) from unit directions: sky, sun, houses with lit windows, paving.

    Values run from 0.06 in windows without light to about 18 in the sun.
    """
    x, y, z = way[..., 0], way[..., 1], way[..., 2]
    level = np.clip(y, 0.0, 1.0)[..., None]
    sky = np.array([0.75, 0.85, 1.00]) * (1 - level) + np.array([0.16, 0.30, 0.62]) * level
    glow = np.clip(way @ (np.array(SUN) / np.linalg.norm(SUN)), 0.0, 1.0)[..., None]
    sky = sky + np.array([1.0, 0.92, 0.75]) * (16.0 * glow**400 + 1.2 * glow**24)
    around = np.arctan2(x, z)
    color = np.where((y < _skyline(around))[..., None], _houses(around, y), sky)
    ground = _step(FOOT - y, 0.04)[..., None]
    return np.asarray(color * (1 - ground) + _paving(way) * ground)


def _step(value: Floats, width: float) -> Floats:
    """0 below zero, 1 above, with an edge of ``width``."""
    t = np.clip(value / width + 0.5, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


def _skyline(around: Floats) -> Floats:
    """Sine of the angle of the roofs in every direction; a gap in the houses lets in the sky."""
    house = np.floor((around + np.pi) * 9.0 / (2.0 * np.pi))
    return np.asarray(np.where(house % 4 == 2, -0.22, 0.22 + 0.25 * np.abs(np.sin(2.1 * house))))


def _houses(around: Floats, y: Floats) -> Floats:
    """Plastered walls with two rows of tall windows, most of them lit."""
    house = np.floor((around + np.pi) * 9.0 / (2.0 * np.pi))
    tone = 0.20 + 0.11 * np.sin(house * 1.7)
    wall = tone[..., None] * np.array([1.0, 0.74, 0.58])
    column, row = around * 27.0 / (2.0 * np.pi), (y - FOOT) * 3.2
    inside = _step(0.28 - np.abs(column - np.floor(column) - 0.5), 0.16)
    inside = inside * _step(0.34 - np.abs(row - np.floor(row) - 0.5), 0.16)
    lit = np.sin(np.floor(column) * 12.9 + np.floor(row) * 78.2) > -0.3
    window = np.where(lit[..., None], np.array([2.4, 1.75, 1.0]), np.array([0.06, 0.08, 0.11]))
    return np.asarray(wall + (window - wall) * inside[..., None])


def _paving(way: Floats) -> Floats:
    """Flagstones, seen from above their middle."""
    depth = -np.minimum(way[..., 1], -0.05)
    u, v = way[..., 0] / depth, way[..., 2] / depth
    gap = np.minimum(np.abs(u - np.round(u)), np.abs(v - np.round(v)))
    stone = 0.34 + 0.12 * np.sin(np.round(u - 0.5) * 3.7 + np.round(v - 0.5) * 5.1)
    stone = 0.08 + (stone - 0.08) * _step(gap - 0.06, 0.08)
    return np.asarray(stone[..., None] * np.array([1.0, 0.95, 0.86]))


def main() -> None:
    """Writes every asset into the folder given by ``--output`` (default: beside this file)."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("--output", type=Path, default=HERE)
    out: Path = arguments.parse_args().output
    mesh = can()
    np.savez_compressed(
        out / "can.npz",
        position=mesh["position"],
        normal=mesh["normal"],
        tangent=mesh["tangent"],
        uv=mesh["uv"],
        index=mesh["index"],
    )
    np.savez_compressed(out / "environment.npz", faces=environment())
    Image.fromarray(normal_map()).save(out / "normals.png", optimize=True)


if __name__ == "__main__":
    main()

"""Makes the heroine: her mesh at two resolutions, what bones move it, her walk, and the ground.

Run as ``python corpus/heroine/generate.py`` (needs the ``assets`` extra). Nobody has to: what it
makes is committed.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import fast_simplification
import numpy as np
import numpy.typing as npt
from body import HIGH, LAYERS, LOW, layers
from scipy.ndimage import label
from skeleton import BONES, NUMBER, walk
from skimage.measure import marching_cubes

HERE = Path(__file__).parent
Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]
FACES, FACES_SMALL = 16_000, 3_000
STEP, STEP_SMALL = 0.0055, 0.011
SEAM = 0.02
"""Metres on both sides of a seam in which the mesh says how far away it is."""


def surface(step: float) -> tuple[Floats, Indices]:
    """The outermost surface from marching cubes: vertices (n, 3) and outward faces (m, 3)."""
    axes = [
        np.arange(low, high, step, dtype=np.float32) for low, high in zip(LOW, HIGH, strict=True)
    ]
    values = np.empty([len(axis) for axis in axes], np.float32)
    for number, x in enumerate(axes[0]):
        y, z = np.meshgrid(axes[1], axes[2], indexing="ij")
        points = np.stack([np.full(y.size, x, np.float32), y.ravel(), z.ravel()], axis=1)
        values[number] = layers(points).min(axis=1).reshape(y.shape)
    regions, _ = label(values < 0.0)
    largest = 1 + int(np.argmax(np.bincount(regions.ravel())[1:]))
    values = np.where((regions != 0) & (regions != largest), np.float32(1e-3), values)
    vertices, faces, _, _ = marching_cubes(values, 0.0, gradient_direction="descent")
    return vertices.astype(np.float64) * step + np.asarray(LOW), faces.astype(np.int64)


def simplified(vertices: Floats, faces: Indices, count: int) -> tuple[Floats, Indices]:
    """The mesh with about ``count`` faces."""
    share = max(1.0 - count / len(faces), 0.0)
    points, triangles = fast_simplification.simplify(vertices, faces, share, agg=4)
    return np.asarray(points, np.float64), np.asarray(triangles, np.int64)


def normals(vertices: Floats, faces: Indices) -> Floats:
    """Unit normals (n, 3): the faces' normals weighted by their areas."""
    corners = vertices[faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    result = np.zeros_like(vertices)
    for corner in range(3):
        np.add.at(result, faces[:, corner], cross)
    return np.asarray(result / np.maximum(np.linalg.norm(result, axis=1, keepdims=True), 1e-12))


def seams(vertices: Floats) -> Floats:
    """How far each vertex is inside of each layer of ``LAYERS``, 0 to 1: half is at its seam."""
    distance = layers(vertices.astype(np.float32)).astype(np.float64)
    others = np.stack([np.delete(distance, 1 + n, 1).min(axis=1) for n in range(len(LAYERS))], 1)
    return np.clip(0.5 + (others - distance[:, 1:]) / (2.0 * SEAM), 0.0, 1.0)


def weights(vertices: Floats, hairy: npt.NDArray[np.bool_]) -> tuple[Indices, Floats]:
    """The four bones that move each vertex most (n, 4), and by how much (n, 4), together 1."""
    found = np.stack([_closeness(vertices, number) for number in range(len(BONES))], axis=1)
    loose = np.isin(np.arange(len(BONES)), [NUMBER[name] for name in ("head", "hair", "braid")])
    found = np.where(hairy[:, None], found * loose, found)
    found[:, [NUMBER["hair"], NUMBER["braid"]]] *= hairy[:, None]
    bones = np.argsort(-found, axis=1)[:, :4]
    share = np.take_along_axis(found, bones, axis=1)
    return bones, share / share.sum(axis=1, keepdims=True)


def _closeness(vertices: Floats, number: int) -> Floats:
    """Falls with the fourth power of the distance to a bone; limbs do not reach across."""
    bone = BONES[number]
    start, axis = np.asarray(bone.joint), np.subtract(bone.end, bone.joint)
    t = np.clip((vertices - start) @ axis / (axis @ axis), 0.0, 1.0)
    distance = np.linalg.norm(vertices - start - t[:, None] * axis, axis=1)
    found = 1.0 / np.maximum(distance, 0.012) ** 4
    if "." in bone.name:
        side = 1.0 if bone.name.endswith("left") else -1.0
        found = found * np.clip(0.5 + side * vertices[:, 0] / 0.10, 0.0, 1.0)
    return np.asarray(found)


def figure(step: float, count: int) -> dict[str, npt.NDArray[Any]]:
    """The arrays of her mesh in the short form that corpus/README.md describes."""
    vertices, faces = simplified(*surface(step), count)
    inside = seams(vertices)
    bones, share = weights(vertices, inside[:, LAYERS.index("hair")] > 0.5)
    bounds = np.stack([vertices.min(axis=0), vertices.max(axis=0)]).astype(np.float32)
    low, high = bounds.astype(np.float64)
    return {
        "position_u16": np.round((vertices - low) / (high - low) * 65535.0).astype(np.uint16),
        "bounds": bounds,
        "normal_i16": np.round(normals(vertices, faces) * 32767.0).astype(np.int16),
        "seams_u16": np.round(inside * 65535.0).astype(np.uint16),
        "bones": bones.astype(np.uint8),
        "weights_u16": np.round(share * 65535.0).astype(np.uint16),
        "index_delta": np.diff(faces.ravel(), prepend=0).astype(np.int32),
    }


def ground(cells: int = 24, radius: float = 9.0) -> dict[str, npt.NDArray[Any]]:
    """A square of ground, in cells so that its depth is even."""
    x, z = np.meshgrid(
        np.linspace(-radius, radius, cells + 1), np.linspace(-radius, radius, cells + 1)
    )
    position = np.stack([x, np.zeros_like(x), z], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij")
    here = i * (cells + 1) + j
    quads = np.stack(
        [here, here + cells + 1, here + cells + 2, here, here + cells + 2, here + 1], -1
    )
    return {
        "position": position.astype(np.float32),
        "normal": np.tile(np.float32([0, 1, 0]), (len(position), 1)),
        "index": quads.reshape(-1, 3).astype(np.int32),
    }


def backdrop(
    around: int = 48, radius: float = 11.0, height: float = 9.0
) -> dict[str, npt.NDArray[Any]]:
    """A wall around the court, seen from inside, and the end of the sky above it."""
    turn = np.arange(around) * (2.0 * np.pi / around)
    ring = np.stack([radius * np.sin(turn), np.zeros(around), radius * np.cos(turn)], axis=-1)
    wall = [(1.0, -0.5), (1.0, 0.5 * height), (0.8, height)]
    rows = [share * ring + np.array([0.0, up, 0.0]) for share, up in wall]
    position = np.concatenate([*rows, [[0.0, 1.2 * height, 0.0]]])
    here = np.arange(around)
    after = (here + 1) % around
    quads = [
        np.stack([low + here, high + here, high + after, low + here, high + after, low + after], -1)
        for low, high in ((0, around), (around, 2 * around))
    ]
    lid = np.stack([2 * around + here, np.full(around, 3 * around), 2 * around + after], -1)
    index = np.concatenate([*(quad.reshape(-1, 3) for quad in quads), lid])
    return {"position": position.astype(np.float32), "index": index.astype(np.int32)}


def main() -> None:
    """Writes every asset into the folder given by ``--output`` (default: beside this file)."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("--output", type=Path, default=HERE)
    out: Path = arguments.parse_args().output
    np.savez_compressed(out / "heroine.npz", **figure(STEP, FACES))
    np.savez_compressed(out / "heroine-small.npz", **figure(STEP_SMALL, FACES_SMALL))
    np.savez_compressed(out / "ground.npz", **ground())
    np.savez_compressed(out / "sky.npz", **backdrop())
    np.savez_compressed(out / "walk.npz", bones=walk())


if __name__ == "__main__":
    main()

"""Makes the dragon: its mesh at two resolutions and the textures of its marble.

Run as ``python corpus/dragon/generate.py`` (needs the ``assets`` extra). Nobody has to: what it
makes is committed. The same versions of the libraries make the same arrays every time.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import fast_simplification
import numpy as np
import numpy.typing as npt
from anatomy import HIGH, LOW, head, legs, ridges, scutes, trunk
from collapse import collapsed
from field import Field
from PIL import Image
from scipy.ndimage import label
from skimage.measure import marching_cubes
from wings import wings

HERE = Path(__file__).parent
Mesh = dict[str, npt.NDArray[Any]]
FACES, FACES_SMALL = 75_000, 4_000
STEP, STEP_SMALL = 0.0070, 0.0200
FATTER = 0.010
"""By how much the small dragon is fatter, so that its skin survives the coarse grid."""
LATTICE = 64
"""Period of the gradient noise, in cells."""

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]


def body(step: float, fatter: float = 0.0) -> tuple[Floats, Indices]:
    """The dragon's surface from marching cubes: vertices (n, 3) and outward faces (m, 3)."""
    field = Field(LOW, HIGH, step)
    for part in (trunk, scutes, legs, head, ridges, wings):
        part(field)
    values = _largest_solid(field.values - np.float32(fatter))
    vertices, faces, _, _ = marching_cubes(values, 0.0, gradient_direction="descent")
    return vertices.astype(np.float64) * step + field.low, faces.astype(np.int64)


def _largest_solid(values: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Drops crumbs off the body and bubbles inside it."""
    for sign in (1.0, -1.0):
        regions, _ = label(sign * values < 0.0)
        largest = 1 + int(np.argmax(np.bincount(regions.ravel())[1:]))
        values = np.where((regions != 0) & (regions != largest), np.float32(sign * 1e-3), values)
    return values


def simplified(vertices: Floats, faces: Indices, count: int) -> tuple[Floats, Indices]:
    """The closed mesh with about ``count`` faces.

    The quick simplifier may pinch the mesh along an edge; so it goes as far as it can without, and
    the careful one does the rest. Raises RuntimeError if even that does not reach ``count``.
    """
    for more in (1.0, 1.02, 1.1, 1.5, 2.5, 4.0, 6.0):
        share = max(1.0 - more * count / len(faces), 0.0)
        for haste in (3, 5, 7):
            points, triangles = fast_simplification.simplify(vertices, faces, share, agg=haste)
            if closed(triangles) and len(triangles) <= 1.01 * more * count:
                result = collapsed(np.asarray(points, np.float64), triangles, count)
                if len(result[1]) > 1.005 * count:
                    break
                return result
    raise RuntimeError(f"no closed mesh of {count} faces found")


def closed(faces: Indices) -> bool:
    """Whether every edge is shared by exactly two faces, which run through it in opposite ways."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    forward = np.unique(edges, axis=0)
    backward = np.unique(edges[:, ::-1], axis=0)
    return len(forward) == len(edges) and bool(np.array_equal(forward, backward))


def normals(vertices: Floats, faces: Indices) -> Floats:
    """Unit normals (n, 3): the faces' normals weighted by their angles at the vertex."""
    corners = vertices[faces]
    result = np.zeros_like(vertices)
    for i in range(3):
        to_next, to_last = (corners[:, (i + k) % 3] - corners[:, i] for k in (1, 2))
        cross = np.cross(to_next, to_last)
        twice_area = np.linalg.norm(cross, axis=1)
        angle = np.arctan2(twice_area, (to_next * to_last).sum(axis=1))
        weight = angle / np.maximum(twice_area, 1e-30)
        np.add.at(result, faces[:, i], cross * weight[:, None])
    return np.asarray(result / np.linalg.norm(result, axis=1, keepdims=True))


def ordered(vertices: Floats, faces: Indices) -> tuple[Floats, Indices]:
    """Faces along a Morton curve and vertices by first use, so that neighbours stay together."""
    centres = vertices[faces].mean(axis=1)
    low, high = centres.min(axis=0), centres.max(axis=0)
    cells = ((centres - low) / (high - low).max() * 1023.0).astype(np.int64)
    code = sum(_spread(cells[:, axis]) << axis for axis in range(3))
    faces = faces[np.argsort(code, kind="stable")]
    used, first = np.unique(faces, return_index=True)
    by_use = used[np.argsort(first, kind="stable")]
    new_name = np.empty(len(vertices), np.int64)
    new_name[by_use] = np.arange(len(by_use))
    return vertices[by_use], new_name[faces]


def _spread(bits: Indices) -> Indices:
    """Ten bits, each followed by two zeros."""
    result = np.zeros_like(bits)
    for i in range(10):
        result |= ((bits >> i) & 1) << (3 * i)
    return result


def quantised(vertices: Floats, faces: Indices) -> Mesh:
    """The arrays of a mesh file in the short form that corpus/README.md describes."""
    bounds = np.stack([vertices.min(axis=0), vertices.max(axis=0)]).astype(np.float32)
    low, high = bounds.astype(np.float64)
    return {
        "position_u16": np.round((vertices - low) / (high - low) * 65535.0).astype(np.uint16),
        "bounds": bounds,
        "normal_i16": np.round(normals(vertices, faces) * 32767.0).astype(np.int16),
        "index_delta": np.diff(faces.ravel(), prepend=0).astype(np.int32),
    }


def dragon(step: float, count: int, fatter: float = 0.0) -> Mesh:
    """The dragon on a grid of ``step``, with about ``count`` faces."""
    return quantised(*ordered(*simplified(*body(step, fatter), count)))


def save(path: Path, mesh: Mesh) -> None:
    """Writes a mesh in the short form."""
    np.savez_compressed(
        path,
        position_u16=mesh["position_u16"],
        bounds=mesh["bounds"],
        normal_i16=mesh["normal_i16"],
        index_delta=mesh["index_delta"],
    )


def lattice(seed: int = 7) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float16]]:
    """Permutation (64, 64, 1) and gradients (1, 64, 3) of the noise, as texels.

    The permutation holds the hash of (x, y), as the place of a texel of the gradients; adding z
    to it (in texels) completes the hash. After Perlin, "Improving noise" (2002).
    """
    random = np.random.Generator(np.random.PCG64(seed))
    order = random.permutation(LATTICE)
    x, y = np.meshgrid(np.arange(LATTICE), np.arange(LATTICE))
    permutation = (order[(order[x] + y) % LATTICE] + 0.5) / LATTICE
    # Points of a Fibonacci sphere, in random order, long enough that the noise fills -1 .. 1.
    height = 1.0 - (2.0 * np.arange(LATTICE) + 1.0) / LATTICE
    turn = np.arange(LATTICE) * np.pi * (3.0 - np.sqrt(5.0))
    ring = np.sqrt(1.0 - height**2)
    sphere = np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=-1)
    gradients = 1.45 * sphere[random.permutation(LATTICE)]
    return permutation.astype(np.float32)[..., None], gradients.astype(np.float16)[None]


def detail(size: int = 128, seed: int = 11) -> npt.NDArray[np.uint8]:
    """A tiling texture (size, size, 4): raggedness in three channels, polish in the fourth."""
    random = np.random.Generator(np.random.PCG64(seed))
    frequency = np.fft.fftfreq(size) * size
    radius = np.hypot(*np.meshgrid(frequency, frequency))
    channels = []
    for low, high in ((4.0, 16.0), (4.0, 16.0), (4.0, 16.0), (2.0, 20.0)):
        mask = np.exp(-((radius / high) ** 2)) - np.exp(-((radius / low) ** 2))
        waves = np.fft.ifft2(np.fft.fft2(random.normal(size=(size, size))) * mask).real
        channels.append(0.5 + 0.16 * waves / waves.std())
    texels = np.clip(np.stack(channels, axis=-1), 0.0, 1.0)
    return np.asarray(np.round(texels * 255.0).astype(np.uint8))


def main() -> None:
    """Writes every asset into the folder given by ``--output`` (default: beside this file)."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("--output", type=Path, default=HERE)
    out: Path = arguments.parse_args().output
    save(out / "dragon.npz", dragon(STEP, FACES))
    save(out / "dragon-small.npz", dragon(STEP_SMALL, FACES_SMALL, FATTER))
    permutation, gradients = lattice()
    np.savez_compressed(out / "permutation.npz", pixels=permutation)
    np.savez_compressed(out / "gradients.npz", pixels=gradients)
    Image.fromarray(detail()).save(out / "detail.png", optimize=True)


if __name__ == "__main__":
    main()

"""Surfaces as a hierarchy of discs, which a shader walks to find what darkens a point.

A disc stands for a patch of surface: where its middle is, how large it is, and where it looks
(Bunnell 2005). Discs that lie together have a parent, as large as all of them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.cluster.vq import kmeans2

Floats = npt.NDArray[np.float64]
SAMPLES = 150
"""Points of the surface for each disc."""


def discs_of(mesh: dict[str, npt.NDArray[Any]], count: int, seed: int) -> Floats:
    """Patches of a mesh (count, 7): middle, mean normal (shorter than 1 if it bends), area."""
    a, b, c = (mesh["position"][mesh["index"][:, corner]] for corner in range(3))
    cross = np.cross(b - a, c - a)
    areas = 0.5 * np.linalg.norm(cross, axis=-1)
    random = np.random.Generator(np.random.PCG64(seed))
    face = random.choice(len(areas), count * SAMPLES, p=areas / areas.sum())
    s, t = np.sqrt(random.random(len(face)))[:, None], random.random(len(face))[:, None]
    points = (1.0 - s) * a[face] + s * (1.0 - t) * b[face] + s * t * c[face]
    normals = cross[face] / np.linalg.norm(cross[face], axis=-1, keepdims=True)
    # Points belong together that are near each other and look the same way.
    features = np.concatenate([points, 0.2 * normals], -1)
    _, label = kmeans2(features, count, minit="++", rng=random)
    sizes = np.bincount(label, minlength=count)
    assert sizes.all(), "a patch without points"
    share = areas.sum() / len(face)
    rows = [
        np.concatenate([points[label == n].mean(0), normals[label == n].mean(0), [share * size]])
        for n, size in enumerate(sizes)
    ]
    return np.array(rows)


def united(discs: Floats) -> Floats:
    """One disc (7,) for several (n, 7), as large as all of them."""
    weights = discs[:, 6:] / discs[:, 6].sum()
    return np.append((weights * discs[:, :6]).sum(0), discs[:, 6].sum())


def hierarchy(discs: Floats) -> list[tuple[Floats, int]]:
    """The tree over discs (n, 7), parents before children, each with its subtree's length.

    Every parent has two children: its discs on either side of the middle, along the longer way.
    """
    if len(discs) == 1:
        return [(discs[0], 1)]
    way = int(np.argmax(np.ptp(discs[:, :3], axis=0)))
    order = np.argsort(discs[:, way], kind="stable")
    halves = [hierarchy(discs[part]) for part in np.array_split(order, 2)]
    below = [*halves[0], *halves[1]]
    return [(united(discs), len(below) + 1), *below]


def forest(groups: list[Floats]) -> list[tuple[Floats, int]]:
    """The same over things that are discs themselves, which no parent tears apart."""
    if len(groups) == 1:
        return hierarchy(groups[0])
    middles = np.array([united(group)[:3] for group in groups])
    way = int(np.argmax(np.ptp(middles, axis=0)))
    order = np.argsort(middles[:, way], kind="stable")
    below = [row for part in np.array_split(order, 2) for row in forest([groups[n] for n in part])]
    return [(united(np.concatenate(groups)), len(below) + 1), *below]


def texels(tree: list[tuple[Floats, int]]) -> npt.NDArray[np.float32]:
    """The tree as a texture (rows, 2, 4): middle and area; normal and the row after the subtree."""
    rows = [
        [[*disc[:3], disc[6]], [*disc[3:6], row + length]]
        for row, (disc, length) in enumerate(tree)
    ]
    return np.array(rows, np.float32)

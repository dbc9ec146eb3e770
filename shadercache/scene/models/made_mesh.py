"""Meshes that are made, with all arrays that a vertex shader commonly asks for: a knot."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

_TUBE, _BUMPS = 0.25, 0.1
_STEP = 1e-4


def grid_steps(around: int, across: int) -> tuple[Numbers, Numbers]:
    """Two coordinates from 0 to 1 for each vertex of a grid of so many squares."""
    steps = (np.linspace(0.0, 1.0, count + 1) for count in (around, across))
    long, short = np.meshgrid(*steps, indexing="ij")
    return long.ravel(), short.ravel()


def grid_triangles(around: int, across: int) -> NDArray[np.int64]:
    """The triangles of such a grid (n, 3), counterclockwise where the second coordinate turns to
    the left of the first."""
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    here = (i * (across + 1) + j).ravel()
    over = here + across + 1
    quads = np.stack([here, over, over + 1, here, over + 1, here + 1], 1)
    return quads.reshape(-1, 3)


def with_all_arrays(
    position: Numbers, normal: Numbers, along: Numbers, uv: Numbers
) -> dict[str, Numbers]:
    """The arrays of a model: besides these a second set of texture coordinates, colours, and the
    joints and weights of two bones. ``along``: the direction in which the first coordinate grows.
    """
    one = np.ones((len(uv), 1))
    upper = np.clip(0.5 + 0.5 * position[:, :1], 0.0, 1.0)
    return {
        "position": position,
        "normal": normal,
        "tangent": np.concatenate([along, one], 1),
        "uv": uv,
        "uv1": 0.25 * uv,
        "color": 0.5 + 0.5 * np.concatenate([normal, one], 1),
        "weights": np.concatenate([upper, 1.0 - upper, 0.0 * one, 0.0 * one], 1),
        "joints": np.tile([0.0, 1.0, 0.0, 0.0], (len(uv), 1)),
    }


def knot(around: int, across: int) -> tuple[Mapping[str, Numbers], NDArray[np.int64]]:
    """Arrays and triangles of a knotted tube with bumps, about the origin, from -1.3 to 1.3.

    Its strands pass before one another: whichever way it turns, parts of it come into view and
    parts vanish.
    """
    long, short = grid_steps(around, across)
    position = _place(long, short)
    along = _place(long + _STEP, short) - _place(long - _STEP, short)
    across_it = _place(long, short + _STEP) - _place(long, short - _STEP)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    normal = np.cross(along, across_it)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    # The tube is about seven times as long as it is round.
    uv = np.stack([7.0 * long, short], 1)
    return with_all_arrays(position, normal, along, uv), grid_triangles(around, across)


def _place(long: Numbers, short: Numbers) -> Numbers:
    """The points of the tube."""
    middle = _middle(long)
    along = _middle(long + _STEP) - _middle(long - _STEP)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    # A direction that is never along the tube.
    outward = middle - along * (middle * along).sum(1)[:, None]
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    # Turned so that the outside is where triangles are counterclockwise.
    roll = -2.0 * np.pi * short[:, None]
    away = np.cos(roll) * outward + np.sin(roll) * np.cross(along, outward)
    bumps = np.sin(2.0 * np.pi * 24.0 * long) * np.cos(2.0 * np.pi * 3.0 * short)
    result: Numbers = middle + _TUBE * (1.0 + _BUMPS * bumps)[:, None] * away
    return result


def _middle(long: Numbers) -> Numbers:
    """The line in the middle of the tube: a trefoil."""
    turn = 2.0 * np.pi * long
    reach = (2.0 + np.cos(3.0 * turn)) / 2.9
    return np.stack(
        [reach * np.cos(2.0 * turn), reach * np.sin(2.0 * turn), np.sin(3.0 * turn) / 2.9], 1
    )

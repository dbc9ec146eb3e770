"""Models with all that a vertex shader commonly asks for: a ring, and a flat sheet.

Positions, normals, tangents, two sets of texture coordinates, colours, joints and weights of two
bones. They reach from -0.9 to 0.9.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from shadercache.scene.models.made_mesh import grid_steps, grid_triangles, with_all_arrays
from shadercache.scene.models.write_gltf import GltfWriter

AROUND, ACROSS = 48, 24


def write_ring(path: Path) -> None:
    """Write the ring as a GLB file."""
    long, short = grid_steps(AROUND, ACROSS)
    turn, roll = -2.0 * np.pi * long, 2.0 * np.pi * short
    outward = np.stack([np.cos(turn), 0.0 * turn, np.sin(turn)], 1)
    normal = np.cos(roll)[:, None] * outward + np.sin(roll)[:, None] * [0.0, 1.0, 0.0]
    along = np.stack([np.sin(turn), 0.0 * turn, -np.cos(turn)], 1)
    uv = np.stack([4.0 * long, 2.0 * short], 1)
    _write(path, 0.6 * outward + 0.3 * normal, (normal, along), uv)


def write_sheet(path: Path) -> None:
    """Write a square in x and y as a GLB file, for what is drawn flat."""
    uv = np.stack(grid_steps(AROUND, ACROSS), 1)
    flat = np.zeros((len(uv), 1))
    normal, along = np.tile([0.0, 0.0, 1.0], (len(uv), 1)), np.tile([1.0, 0.0, 0.0], (len(uv), 1))
    _write(path, np.concatenate([1.8 * uv - 0.9, flat], 1), (normal, along), uv)


def _write(
    path: Path, position: np.ndarray, frame: tuple[np.ndarray, np.ndarray], uv: np.ndarray
) -> None:
    made = GltfWriter()
    arrays = with_all_arrays(position, *frame, uv)
    made.hung(made.mesh(arrays, grid_triangles(AROUND, ACROSS)), "ring")
    made.glb(path)

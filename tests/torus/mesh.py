"""The torus scene that many tests draw: its folder, and what stands in its files of arrays."""

from __future__ import annotations

from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parent
EMISSION = FOLDER / "emission"
"""A variant written by hand, which a manifest describes."""


def torus(rings: int = 48, sides: int = 24) -> dict[str, np.ndarray]:
    """Arrays of a torus about the z axis: radii 0.8 and 0.3."""
    u, v = np.meshgrid(
        np.linspace(0.0, 2.0 * np.pi, rings, endpoint=False),
        np.linspace(0.0, 2.0 * np.pi, sides, endpoint=False),
        indexing="ij",
    )
    normal = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], -1)
    centre = np.stack([np.cos(u), np.sin(u), np.zeros_like(u)], -1) * 0.8
    i, j = np.meshgrid(np.arange(rings), np.arange(sides), indexing="ij")
    here, right = i * sides + j, (i + 1) % rings * sides + j
    up, across = i * sides + (j + 1) % sides, (i + 1) % rings * sides + (j + 1) % sides
    quads = np.stack([here, right, across, here, across, up], -1)
    return {
        "position": (centre + 0.3 * normal).reshape(-1, 3).astype(np.float32),
        "normal": normal.reshape(-1, 3).astype(np.float32),
        "index": quads.reshape(-1, 3).astype(np.uint32),
    }


def bones(frames: int = 12) -> np.ndarray:
    """Two bones: one at rest, one that swings about z; (frames, 2, 16), column by column."""
    matrices = np.tile(np.eye(4), (frames, 2, 1, 1))
    for frame in range(frames):
        angle = 0.4 * np.sin(2.0 * np.pi * frame / frames)
        turn = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        matrices[frame, 1, :2, :2] = turn
    return matrices.transpose(0, 1, 3, 2).reshape(frames, 2, 16).astype(np.float32)


def write_arrays(folder: Path) -> None:
    """The mesh and the bones that the scene files name."""
    np.savez(folder / "torus.npz", **torus())
    np.savez(folder / "objects" / "bones.npz", bones=bones())

"""The scene that all cases are drawn in: a ring, two textures, a cube map and an array."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np

from shadercache.linking.scene_shaders import with_new_names
from shadercache.scene.description import Scene, load_scene
from tests.altered import altered

from .cases import FOLDER, analysed, vertex


def ring(around: int = 24, across: int = 12) -> dict[str, np.ndarray]:
    """Arrays of a torus about the z axis: radii 0.8 and 0.3."""
    u, v = np.meshgrid(
        np.linspace(0.0, 2.0 * np.pi, around + 1),
        np.linspace(0.0, 2.0 * np.pi, across + 1),
        indexing="ij",
    )
    normal = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], -1)
    centre = np.stack([np.cos(u), np.sin(u), np.zeros_like(u)], -1) * 0.8
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    here, right = i * (across + 1) + j, (i + 1) * (across + 1) + j
    quads = np.stack([here, right, right + 1, here, right + 1, here + 1], -1)
    return {
        "position": (centre + 0.3 * normal).reshape(-1, 3).astype(np.float32),
        "normal": normal.reshape(-1, 3).astype(np.float32),
        "uv": np.stack([u, v], -1).reshape(-1, 2).astype(np.float32) / np.float32(2.0 * np.pi),
        "index": quads.reshape(-1, 3).astype(np.uint32),
    }


def make_scene(folder: Path) -> Path:
    """A copy of the cases in a new folder, with the mesh and the textures made."""
    shutil.copytree(FOLDER, folder)
    random = np.random.default_rng(4)
    np.savez(folder / "ring.npz", **ring())
    np.savez(folder / "map.npz", pixels=random.random((16, 16, 4), np.float32))
    np.savez(folder / "sky.npz", faces=random.random((6, 8, 8, 4), np.float32))
    np.savez(folder / "layers.npz", layers=random.random((3, 8, 8, 4), np.float32))
    return folder


def scene_of(name: str, folder: Path) -> Scene:
    """The scene with the shaders of a case, in a folder that :func:`make_scene` made."""
    paths = (folder / f"{name}.frag", folder / vertex(name).name)
    scene = altered(load_scene(folder), fragment=paths[0], vertex=paths[1])
    return with_new_names(scene, analysed(name).renamed)

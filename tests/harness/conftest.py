"""One context, one torus scene and one hand-written emission for all tests of the harness."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle, load_bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene

FIXTURES = Path(__file__).parent / "fixtures"


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
    found = np.tile(np.eye(4), (frames, 2, 1, 1))
    for frame in range(frames):
        angle = 0.4 * np.sin(2.0 * np.pi * frame / frames)
        turn = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        found[frame, 1, :2, :2] = turn
    return found.transpose(0, 1, 3, 2).reshape(frames, 2, 16).astype(np.float32)


@pytest.fixture(scope="session")
def scene_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the fixtures with the mesh made."""
    folder = tmp_path_factory.mktemp("torus")
    shutil.copytree(FIXTURES, folder, dirs_exist_ok=True)
    np.savez(folder / "torus.npz", **torus())
    np.savez(folder / "objects" / "bones.npz", bones=bones())
    return folder


@pytest.fixture(scope="session")
def scene(scene_folder: Path) -> Scene:
    return load_scene(scene_folder)


@pytest.fixture(scope="session")
def bundle() -> Bundle:
    return load_bundle(FIXTURES / "emission")


@pytest.fixture(scope="session")
def world(gpu: Gpu, scene: Scene) -> Iterator[RenderScene]:
    """The torus at 96 x 64 with float colours, as proofs want it."""
    with RenderScene(gpu, scene, (96, 64), "rgba32f") as made:
        yield made

"""The small scene on which generated shaders are drawn: a turning ring, and textures."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from shadercache.scene.description import Scene, SceneObject, View
from shadercache.scene.mesh import Mesh
from shadercache.scene.motion import Camera, Motion
from shadercache.scene.object_inputs import Inputs, TextureSpec

from .writer import UNIFORMS

SIZE = (48, 48)


@cache
def ring(around: int = 20, across: int = 10) -> Mesh:
    """A torus: it hides parts of itself, and every part of it turns."""
    u, v = np.meshgrid(
        np.linspace(0.0, 2.0 * np.pi, around + 1),
        np.linspace(0.0, 2.0 * np.pi, across + 1),
        indexing="ij",
    )
    flat = np.stack([np.cos(u), np.zeros_like(u), np.sin(u)], -1)
    normal = flat * np.cos(v)[..., None] + np.array([0.0, 1.0, 0.0]) * np.sin(v)[..., None]
    arrays = {
        "position": flat * 0.7 + normal * 0.33,
        "normal": normal,
        "uv": np.stack([u, v], -1) / np.pi,
    }
    corner = (np.arange(around)[:, None] * (across + 1) + np.arange(across)).ravel()
    right = corner + across + 1
    index = np.stack([corner, corner + 1, right, right, corner + 1, right + 1], -1).reshape(-1, 3)
    floats = {
        name: array.reshape(-1, array.shape[-1]).astype(np.float32)
        for name, array in arrays.items()
    }
    return Mesh("ring", floats, index.astype(np.uint32))


@cache
def scene() -> Scene:
    """The ring under a camera, with every uniform and texture that a shader may name."""
    folder = Path(mkdtemp(prefix="shadercache-generated-"))
    noise = np.random.default_rng(7)
    np.savez(folder / "flat.npz", pixels=noise.random((16, 16, 4), np.float32))
    np.savez(folder / "cube.npz", faces=noise.random((6, 8, 8, 4), np.float32))
    nowhere = folder / "none"
    inputs = Inputs(
        {"a_position": "position", "a_normal": "normal", "a_uv": "uv"},
        {name: values for name, (_, values) in UNIFORMS.items()},
        {"u_mvp": "model-view-projection"},
        textures={
            "u_mipmapped": TextureSpec(folder / "flat.npz", "linear", True, "repeat", 1.0),
            "u_plain": TextureSpec(folder / "flat.npz", "linear", False, "repeat", 1.0),
            "u_cube": TextureSpec(folder / "cube.npz", "linear", True, "repeat", 1.0),
        },
    )
    motion = Motion((0.3, 1.0, 0.1), 4.0, 0.0, 64)
    ring = SceneObject("ring", nowhere, nowhere, nowhere, motion=motion, inputs=inputs)
    camera = Camera((0.0, 1.6, 2.2), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 42.0, 1.0, 10.0)
    return Scene(folder / "scene.toml", "ring", "ring", ring, View(camera))

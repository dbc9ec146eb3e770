"""What stress tests draw: a corpus node in proof mode, and a knot of as many faces as one likes."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import Configuration, Mode
from shadercache.compiler import emit_original
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner, OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.mesh import Mesh
from tests.configured import DEFAULT, configured, rewritten

ALGORITHMS = ("1-pass", "2-pass", "3-pass")


@dataclass(frozen=True)
class Subject:
    """A world with the variants of a node on it, and the original in the same mode."""

    world: RenderScene
    bundle: Bundle
    plain: Bundle

    def original(self, frame: int) -> NDArray[np.float32]:
        """The original's image, (h, w, 4)."""
        with OriginalRunner(self.world, self.plain) as runner:
            return runner.image(frame).copy()

    def untied(self, frame: int) -> NDArray[np.bool_]:
        """The pixels where no two fragments share the front (law 4), (h, w)."""
        with CoverageRunner(self.world, self.plain) as runner:
            return ~runner.ties(frame)


@cache
def programs(
    name: str, cache: Configuration = DEFAULT, mode: Mode = "proof", which: int = -1
) -> tuple[Scene, Bundle, Bundle]:
    """A corpus scene, the variants of a node of its demo in RGBA32F, and its original."""
    scene, analysis = analyse_scene(load_scene(data_path("corpus", name)))
    assert scene.demo is not None
    label = scene.demo.nodes[which]
    node = analysis.nodes_of(scene.nodes.get(label, label))
    found = rewritten(
        analysis, node, configured(cache, mode=mode, form="rgba32f"), unprofitable=True
    )
    plain = emit_original(analysis, mode)
    return scene, Bundle(found.manifest, found.files), Bundle(plain.manifest, plain.files)


@contextmanager
def subject(
    gpu: Gpu,
    name: str,
    size: tuple[int, int] = (96, 96),
    cache: Configuration = DEFAULT,
    which: int = -1,
) -> Iterator[Subject]:
    """A corpus scene with a node's variants in proof mode, on float targets."""
    scene, bundle, plain = programs(name, cache, which=which)
    with RenderScene(gpu, scene.small, size, "rgba32f") as world:
        yield Subject(world, bundle, plain)


def changed(image: NDArray[np.float32], other: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Which pixels do not have the same bits, (h, w)."""
    found: NDArray[np.bool_] = (image.view(np.uint32) != other.view(np.uint32)).any(axis=-1)
    return found


def knot(around: int, across: int) -> Mesh:
    """A closed band about a torus knot, of 2 x ``around`` x ``across`` faces."""
    u = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)[:, None]
    v = np.linspace(0.0, 2.0 * np.pi, across, endpoint=False)[None, :]
    ring = 0.7 + 0.25 * np.cos(3.0 * u)
    centre = np.stack([ring * np.cos(2.0 * u), 0.3 * np.sin(3.0 * u), ring * np.sin(2.0 * u)], -1)
    along = np.roll(centre, -1, 0) - np.roll(centre, 1, 0)
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    side = np.cross(along, [0.0, 1.0, 0.0])
    side /= np.linalg.norm(side, axis=-1, keepdims=True)
    normal = np.cos(v)[..., None] * side + np.sin(v)[..., None] * np.cross(side, along)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    here, right = i * across + j, (i + 1) % around * across + j
    up, beyond = i * across + (j + 1) % across, (i + 1) % around * across + (j + 1) % across
    quads = np.stack([here, right, beyond, here, beyond, up], -1)
    arrays = {"position": centre + 0.12 * normal, "normal": normal}
    floats = {name: array.reshape(-1, 3).astype(np.float32) for name, array in arrays.items()}
    return Mesh("knot", floats, quads.reshape(-1, 3).astype(np.uint32))

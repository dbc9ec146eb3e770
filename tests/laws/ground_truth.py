"""Law 5's ground truth: which surface point a pixel shows, and which one a hit brings back.

A scene's mesh is drawn by shaders of our own whose payload is the object-space position (or the
normal, or the body's number), so that each cache texel says which surface point it holds. The
truth is the same shader unchanged. Bodies are rigid and turn with their frame of reference, so
that object space is where points of two frames can be compared.

Arrays have row 0 at the bottom; pixel coordinates are those of ``gl_FragCoord``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.compiler import analyse
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import semantic_values
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.mesh import Mesh, load_mesh
from shadercache.source import Source
from tests.altered import altered
from tests.configured import DEFAULT, configured, rewritten

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
Mutation = Callable[[str], str]

VERTEX = """#version 330
in vec3 a_position;
in vec3 a_normal;
in vec3 a_facet;
in float a_body;
uniform mat4 u_modelViewProjection;
out vec3 v_position;
out vec3 v_normal;
out vec3 v_facet;
out vec3 v_body;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_facet = a_facet;
    v_body = vec3(a_body);
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
"""

FRAGMENT = """#version 330
in vec3 WHAT;
out vec4 o_color;
void main() {
    vec3 value = WHAT * 1.0;
    o_color = vec4(value, 1.0);
}
"""

FOOTPRINT = 2.0
"""Pixels: a bilinear filter reaches less than this far."""

LEAST_COSINE = 1e-3
"""Where a facet is seen edge on, its footprint is taken as a thousand times a pixel."""


@cache
def bundle_of(what: str, form: CacheFormat, cached: Configuration = DEFAULT) -> Bundle:
    """The rewritten shader whose payload is the varying ``what``, with a cache of that format."""
    text = FRAGMENT.replace("WHAT", what)
    analysis = analyse(Source("truth.frag", text), Source("truth.vert", VERTEX))
    node = next(node for node in analysis.nodes if node.text == f"{what} * 1.0")
    emission = rewritten(analysis, node, configured(cached, form=form), unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def mutated(bundle: Bundle, mutation: Mutation | None) -> Bundle:
    """The bundle with every file changed by ``mutation``."""
    if mutation is None:
        return bundle
    return Bundle(bundle.manifest, {name: mutation(text) for name, text in bundle.files.items()})


def body_scene(name: str, degrees: float, zoom: float = 1.0) -> Scene:
    """A corpus scene for the shaders above, turning by ``degrees`` a frame.

    With ``zoom`` above 1 the camera sees less, so that the body leaves the picture.
    """
    scene = load_scene(data_path("corpus", name, "scene.toml"))
    arrays = {"a_position": "position", "a_normal": "normal", "a_facet": "facet", "a_body": "body"}
    return altered(
        scene,
        attributes=arrays,
        constants={},
        semantics={"u_modelViewProjection": "model-view-projection"},
        textures={},
        fov_degrees=scene.view.camera.fov_degrees / zoom,
        degrees_per_frame=degrees,
    )


def facets(mesh: Mesh) -> Mesh:
    """The mesh with three vertices of its own for each triangle, and the triangles' normals."""
    arrays = {name: array[mesh.index.ravel()] for name, array in mesh.arrays.items()}
    corner = arrays["position"].reshape(-1, 3, 3).astype(np.float64)
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
    arrays["facet"] = np.repeat(normal, 3, axis=0).astype(np.float32)
    arrays.setdefault("body", np.zeros((len(arrays["position"]), 1), np.float32))
    return Mesh(mesh.name, arrays, np.arange(mesh.index.size, dtype=np.uint32).reshape(-1, 3))


def with_sphere(mesh: Mesh, centre: Sequence[float], radius: float, rings: int = 32) -> Mesh:
    """The mesh as body 0 and a sphere as body 1."""
    around, down = np.meshgrid(np.arange(2 * rings), np.arange(rings), indexing="ij")
    here, right = around * (rings + 1) + down, (around + 1) % (2 * rings) * (rings + 1) + down
    index = np.stack([here, here + 1, right, right, here + 1, right + 1], -1).reshape(-1, 3)
    u, v = np.meshgrid(
        np.arange(2 * rings) * (np.pi / rings), np.linspace(0.0, np.pi, rings + 1), indexing="ij"
    )
    normal = np.stack([np.sin(v) * np.sin(u), np.cos(v), np.sin(v) * np.cos(u)], -1).reshape(-1, 3)
    count = len(mesh.arrays["position"])
    arrays = {
        "position": np.concatenate([mesh.arrays["position"], centre + radius * normal]),
        "normal": np.concatenate([mesh.arrays["normal"], normal]),
        "body": np.concatenate([np.zeros((count, 1)), np.ones((len(normal), 1))]),
    }
    floats = {name: array.astype(np.float32) for name, array in arrays.items()}
    return Mesh("two bodies", floats, np.concatenate([mesh.index, index + count]).astype(np.uint32))


def body_mesh(name: str, sphere: bool = False) -> Mesh:
    """The full mesh of a corpus scene, as facets; on request with a sphere as second body.

    The sphere is meant for the dragon: it passes in front of body, neck and wings.
    """
    mesh = load_mesh(load_scene(data_path("corpus", name, "scene.toml")).common.mesh)
    return facets(with_sphere(mesh, (0.0, 1.0, 1.1), 0.25) if sphere else mesh)


@dataclass(frozen=True)
class TrueFrame:
    """What is to be seen in one frame: arrays (h, w) or (h, w, 3), only meant where ``covered``.

    ``w`` is the depth (clip-space w), ``footprint`` the length in object space that one pixel spans
    along the facet, ``matrix`` the model-view-projection.
    """

    covered: Mask
    position: Floats
    normal: Floats
    body: Floats
    w: Floats
    footprint: Floats
    matrix: Floats

    def texels(self, what: str) -> NDArray[np.float32]:
        """The cache as it would be if nothing had ever been reused."""
        values = getattr(self, what.removeprefix("v_"))
        if values.ndim == 2:
            values = np.repeat(values[..., None], 3, axis=-1)
        texels = np.concatenate([values, (16.0 / self.w)[..., None]], axis=-1)
        texels[~self.covered] = 0.0, 0.0, 0.0, -1.0
        return texels.astype(np.float32)


def true_frames(world: RenderScene, frames: Sequence[int]) -> list[TrueFrame]:
    """Render the truth of these frames."""
    parts = zip(
        *(
            _rendered(world, f"v_{what}", frames)
            for what in ("position", "normal", "facet", "body")
        ),
        strict=True,
    )
    return [_true_frame(world, frame, *part) for frame, part in zip(frames, parts, strict=True)]


def project(matrix: Floats, points: Floats, size: tuple[int, int]) -> tuple[Floats, Floats]:
    """Pixel coordinates (..., 2) and w (...) of object-space points (..., 3)."""
    clip = points @ matrix[:, :3].T + matrix[:, 3]
    w = clip[..., 3]
    return (clip[..., :2] / w[..., None] * 0.5 + 0.5) * np.asarray(size), w


def due(size: tuple[int, int], clock: int, period: int, block: int) -> Mask:
    """Which pixels the stratified refresh renews (docs/why/refresh.md), (h, w), written anew.

    Of blocks numbered row by row each group of ``period`` neighbours takes every turn once, in an
    order turned by a hash and shuffled by two rounds of swaps.
    """
    across, up = (-(-side // block) for side in size)
    x, y = np.meshgrid(np.arange(across), np.arange(up))
    number = y * across + x
    group, turn = np.divmod(number.astype(np.uint64), np.uint64(period))
    key = _mixed(group * 9277 + 26699)
    turn = (turn + _residue(key * 0xC2B2AE35, period)) % period
    for partner, keys in ((key, key), (key << 16, key ^ 0x85EBCA6B)):
        other = (_residue(partner, period) + period - turn) % period
        swaps = (keys + np.maximum(turn, other)) * 0x9E3779B9 >> 31 & 1
        turn = np.where(swaps == 1, other, turn)
    due = (turn + clock) % period == 0
    found: Mask = np.kron(due, np.ones((block, block), bool))[: size[1], : size[0]]
    return found


_BITS = 0xFFFFFFFF


def _residue(hashed: NDArray[np.uint64], period: int) -> NDArray[np.uint64]:
    """A hash made even in [0, period)."""
    return ((hashed & _BITS) >> 16) * period >> 16


def _mixed(numbers: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """A hash of 32 bits: xorshift and a product."""
    mixed = numbers & _BITS
    mixed ^= (mixed << 13) & _BITS
    mixed ^= mixed >> 17
    mixed ^= (mixed << 5) & _BITS
    mixed = (mixed * 0x9E3779B9) & _BITS
    return mixed ^ (mixed >> 15)


def taps(place: Floats, size: tuple[int, int]) -> Iterator[tuple[NDArray[np.intp], ...]]:
    """Row and column of the four texels that a bilinear filter at ``place`` reads."""
    low = np.floor(place - 0.5).astype(np.intp)
    for up in (0, 1):
        for right in (0, 1):
            row = np.clip(low[..., 1] + up, 0, size[1] - 1)
            yield row, np.clip(low[..., 0] + right, 0, size[0] - 1)


def _rendered(world: RenderScene, what: str, frames: Sequence[int]) -> list[NDArray[np.float32]]:
    with OriginalRunner(world, bundle_of(what, "rgba32f")) as runner:
        return [runner.image(frame).copy() for frame in frames]


def _true_frame(world: RenderScene, frame: int, *images: NDArray[np.float32]) -> TrueFrame:
    position, normal, facet, body = (image[..., :3].astype(np.float64) for image in images)
    width, height = world.size
    values = semantic_values(world.scene.view, world.scene.common.motion, frame, width / height)
    matrix = values["model-view-projection"]
    eye = np.linalg.inv(values["model-view"])[:3, 3]
    w = project(matrix, position, world.size)[1]
    view = eye - position
    cosine = np.abs((facet * view).sum(-1)) / np.linalg.norm(view, axis=-1)
    pixel = 2.0 * np.tan(np.radians(world.scene.view.camera.fov_degrees) / 2.0) * w / height
    return TrueFrame(
        covered=images[0][..., 3] > 0.0,
        position=position,
        normal=normal,
        body=body[..., 0],
        w=w,
        footprint=pixel / np.maximum(cosine, LEAST_COSINE),
        matrix=matrix,
    )

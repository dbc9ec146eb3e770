"""Scenes of several bodies whose payloads say which point of which body they are, and the judge.

As ``laws.ground_truth`` and ``laws.look_ups``, for bodies that move apart, appear, vanish and jump,
before a camera that may do anything. Every look-up is judged by itself, from a cache that holds
the truth of the frame before. Arrays have row 0 at the bottom.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
from laws.ground_truth import (
    FOOTPRINT,
    FRAGMENT,
    LEAST_COSINE,
    VERTEX,
    Floats,
    Mask,
    body_scene,
    facets,
    project,
    taps,
)
from numpy.typing import NDArray

from shadercache.caching.settings import with_settings
from shadercache.compiler import analyse
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.camera import camera_at, semantic_values
from shadercache.scene.description import Scene
from shadercache.scene.mesh import Mesh
from shadercache.scene.motion import Camera, CameraPath, Key, Motion
from shadercache.source import Source
from tests.altered import altered
from tests.configured import DEFAULT, configured, rewritten, variant

Vector = tuple[float, float, float]
BLOCK = 4
MOST_STALE = 1e-5
"""Share of hits that may be farther away on their surface than allowed (law 5)."""
MOST_FOREIGN = 1e-3
"""A hit comes from another body if more than this of its number does: more than rounding."""

AT_REST = 0.01
"""Pixels by which the place of a point that was drawn may be off."""

REST = Motion((0.0, 1.0, 0.0), 0.0, 0.0, 999)


@cache
def bundle_of(what: str, cached: str = "") -> Bundle:
    """The shader whose payload is the varying ``what``, rewritten with these options."""
    text = FRAGMENT.replace("WHAT", what)
    analysis = analyse(Source("truth.frag", text), Source("truth.vert", VERTEX))
    node = next(node for node in analysis.nodes if node.text == f"{what} * 1.0")
    options = configured(with_settings(DEFAULT, [cached] if cached else []), form="rgba32f")
    emission = rewritten(analysis, node, options, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


@dataclass(frozen=True)
class Body:
    """A mesh, and how it moves."""

    mesh: Mesh
    motion: Motion = REST


def crowd(
    folder: Path,
    bodies: Mapping[str, Body],
    camera: Camera,
    keys: Sequence[Key] = (),
) -> Scene:
    """The scene of these bodies, numbered from 1; their meshes are written to the folder."""
    like = body_scene("trashcan", 0.0)
    shots = CameraPath(keys=tuple(keys))
    scene = altered(like, name="crowd", camera=camera, camera_path=shots, cull=False)
    items = []
    for number, (name, body) in enumerate(bodies.items(), 1):
        path = folder / f"{name}.npz"
        if not path.exists():
            made = facets(body.mesh)
            made.arrays["body"][:] = number  # type: ignore[index]
            np.savez(path, index=made.index, **made.arrays)
        items.append(replace(scene.common, name=name, mesh=path, motion=body.motion))
    return replace(scene, objects=tuple(items))


def shape(name: str, position: Floats, index: NDArray[np.integer]) -> Mesh:
    """A mesh with some normals (nobody looks at them)."""
    arrays = {"position": np.asarray(position, np.float32)}
    arrays["normal"] = np.tile(np.float32([0, 1, 0]), (len(position), 1))
    return Mesh(name, arrays, np.asarray(index, np.uint32).reshape(-1, 3))


def sheet(name: str, corners: Sequence[Vector], cells: int = 8) -> Mesh:
    """A parallelogram (three corners, the second where both sides meet), in cells."""
    left, middle, right = (np.asarray(corner, np.float64) for corner in corners)
    s, t = np.meshgrid(np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1), indexing="ij")
    position = middle + s[..., None] * (left - middle) + t[..., None] * (right - middle)
    i, j = np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij")
    here = i * (cells + 1) + j
    quads = [here, here + cells + 1, here + cells + 2, here, here + cells + 2, here + 1]
    return shape(name, position.reshape(-1, 3), np.stack(quads, -1))


def ball(name: str, radius: float, rings: int = 16, centre: Vector = (0.0, 0.0, 0.0)) -> Mesh:
    """A sphere."""
    around = 2 * rings
    u, v = np.meshgrid(
        np.arange(around) * (2 * np.pi / around), np.linspace(0, np.pi, rings + 1), indexing="ij"
    )
    point = np.stack([np.sin(v) * np.sin(u), np.cos(v), np.sin(v) * np.cos(u)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(around), np.arange(rings), indexing="ij")
    here, right = i * (rings + 1) + j, (i + 1) % around * (rings + 1) + j
    quads = np.stack([here, here + 1, right, right, here + 1, right + 1], -1)
    return shape(name, centre + radius * point, quads)


def fence(name: str, bars: int, width: float, height: float, thin: float) -> Mesh:
    """Upright flat bars side by side, ``thin`` wide each."""
    at = np.linspace(-0.5 * width, 0.5 * width, bars)
    corners = [(-thin, 0.0), (thin, 0.0), (thin, height), (-thin, height)]
    position = [(x + 0.5 * dx, y, 0.0) for x in at for dx, y in corners]
    index = [(4 * n + a, 4 * n + b, 4 * n + c) for n in range(bars)
             for a, b, c in ((0, 1, 2), (0, 2, 3))]  # fmt: skip
    return shape(name, np.asarray(position), np.asarray(index))


@dataclass(frozen=True)
class Truth:
    """What is to be seen in one frame, (h, w) or (h, w, 3), only meant where ``covered``.

    ``body`` is the number of the body, 0 for none; ``matrices`` are model-view-projections by
    number, of the bodies that are there; ``footprint`` is what a pixel spans along the facet.
    """

    covered: Mask
    position: Floats
    body: NDArray[np.intp]
    w: Floats
    footprint: Floats
    matrices: Mapping[int, Floats]

    def texels(self, what: str) -> NDArray[np.float32]:
        """The cache as it would be if nothing had ever been reused."""
        numbers = np.repeat(self.body[..., None].astype(np.float64), 3, axis=-1)
        values = self.position if what == "v_position" else numbers
        texels = np.concatenate([values, (16.0 / self.w)[..., None]], axis=-1)
        texels[~self.covered] = 0.0, 0.0, 0.0, -1.0
        return texels.astype(np.float32)


def truth_of(world: RenderScene, frame: int) -> Truth:
    """Render the truth of a frame."""
    position, facet, body = (
        _rendered(world, what, frame) for what in ("v_position", "v_facet", "v_body")
    )
    covered = position[..., 3] > 0.0
    number = np.rint(body[..., 0]).astype(np.intp) * covered
    width, height = world.size
    camera = camera_at(world.scene.view, frame)
    w, cosine = np.ones(covered.shape), np.ones(covered.shape)
    matrices: dict[int, Floats] = {}
    for drawable in world.drawables:
        if not drawable.is_there(frame):
            continue
        values = semantic_values(
            world.scene.view, drawable.scene_object.motion, frame, width / height
        )
        matrices[drawable.number] = values["model-view-projection"]
        mine = number == drawable.number
        points = position[mine][:, :3].astype(np.float64)
        w[mine] = project(matrices[drawable.number], points, world.size)[1]
        view = np.linalg.inv(values["model-view"])[:3, 3] - points
        facing = (facet[mine][:, :3] * view).sum(-1) / np.maximum(
            np.linalg.norm(view, axis=-1) * np.linalg.norm(facet[mine][:, :3], axis=-1), 1e-30
        )
        # The lengths below are in object space.
        cosine[mine] = np.abs(facing) * drawable.scene_object.motion.scale
    pixel = 2.0 * np.tan(np.radians(camera.fov_degrees) / 2.0) * np.abs(w) / height
    return Truth(
        covered=covered,
        position=position[..., :3].astype(np.float64),
        body=number,
        w=np.where(covered, w, 1.0),
        footprint=pixel / np.maximum(cosine, LEAST_COSINE),
        matrices=matrices,
    )


def _rendered(world: RenderScene, what: str, frame: int) -> NDArray[np.float32]:
    with OriginalRunner(world, bundle_of(what)) as runner:
        return runner.image(frame).copy()


@dataclass(frozen=True, slots=True)
class Stale:
    """A hit that is not sound: ``pixels`` off on its own surface, or of another body."""

    frame: int
    x: int
    y: int
    why: str

    def __str__(self) -> str:
        return f"frame {self.frame}, pixel ({self.x}, {self.y}): {self.why}"


@dataclass(slots=True)
class Record:
    """What was found, over all frames."""

    covered: int = 0
    hits: int = 0
    seen: int = 0
    stale: list[Stale] = field(default_factory=list)
    foreign: list[Stale] = field(default_factory=list)
    unseen: list[Stale] = field(default_factory=list)

    def add(self, other: Record) -> None:
        """Count another record's findings as well."""
        self.covered += other.covered
        self.hits += other.hits
        self.seen += other.seen
        self.stale += other.stale
        self.foreign += other.foreign
        self.unseen += other.unseen

    @property
    def broken(self) -> list[str]:
        """What breaks law 5, with every pixel of it (the first hundred of a kind)."""
        found = []
        if self.foreign:
            found.append(f"{len(self.foreign)} of {self.hits} hits are of another body")
        for name, list_of in (("too far away", self.stale), ("not visible before", self.unseen)):
            if len(list_of) > MOST_STALE * self.hits:
                found.append(f"{len(list_of)} of {self.hits} hits are {name}")
        if found:
            found += [str(item) for item in (*self.foreign, *self.stale, *self.unseen)[:100]]
        return found

    def __str__(self) -> str:
        return (
            f"{self.covered} pixels, {self.seen} seen before, {self.hits} hits; "
            f"{len(self.foreign)} foreign, {len(self.stale)} stale, {len(self.unseen)} unseen"
        )


def judge(
    world: RenderScene, frames: Sequence[int], cached: str = "", period: int = 65535
) -> Iterator[tuple[int, Record]]:
    """Frame by frame what that frame's look-ups bring, each from the truth of the frame before."""
    options = {"period": period, "block": BLOCK}
    with (
        variant(world, bundle_of("v_position", cached), "2-pass", **options) as points,
        variant(world, bundle_of("v_body", cached), "2-pass", **options) as bodies,
    ):
        before = truth_of(world, frames[0])
        fill(points, before, "v_position", frames[0])
        fill(bodies, before, "v_body", frames[0])
        for last, frame in pairwise(frames):
            now = truth_of(world, frame)
            refill(points, before, "v_position", last)
            refill(bodies, before, "v_body", last)
            mask = points.hit_mask(frame)
            points.draw(frame)
            bodies.draw(frame)
            hit = (mask == points.bundle.mask_values["hit"]) & now.covered
            found = Record(covered=int(now.covered.sum()), hits=int(hit.sum()))
            _judge(found, world.size, frame, now, before, hit, points.cache(), bodies.cache())
            yield frame, found
            before = now


def fill(runner: VariantRunner, truth: Truth, what: str, frame: int) -> None:
    """Draw a first frame, so that the caches hold all that options add to them."""
    runner.draw(frame)
    refill(runner, truth, what, frame)


def refill(runner: VariantRunner, truth: Truth, what: str, frame: int) -> None:
    """Put the truth of the last drawn frame in place of its payloads."""
    texels = runner.cache()
    texels[..., :4] = truth.texels(what)
    runner.restore(texels, frame)


def _judge(
    found: Record,
    size: tuple[int, int],
    frame: int,
    now: Truth,
    before: Truth,
    hit: Mask,
    points: NDArray[np.float32],
    bodies: NDArray[np.float32],
) -> None:
    epsilon = bundle_of("v_position").naming.defaults["epsilon"]
    allowed = FOOTPRINT * now.footprint + epsilon * np.abs(now.w)
    away = np.linalg.norm(points[..., :3] - now.position, axis=-1)
    near = _taps(now, before, size)
    # The filter's footprint is in texels of the frame before: where the camera has come closer,
    # these lie farther apart than pixels do now.
    for tap, same in near:
        allowed = np.maximum(allowed, np.where(same, FOOTPRINT * before.footprint[tap], 0.0))
    foreign = hit & (np.abs(bodies[..., 0] - now.body) > MOST_FOREIGN)
    seen = now.covered & np.logical_or.reduce(
        [
            same & (np.linalg.norm(before.position[tap] - now.position, axis=-1) <= allowed)
            for tap, same in near
        ]
    )
    found.seen = int((seen & now.covered).sum())
    for mask, why, into in (
        (foreign, "of another body", found.foreign),
        (hit & ~foreign & (away > allowed), "", found.stale),
        (hit & ~foreign & ~seen, "not visible before", found.unseen),
    ):
        for y, x in np.argwhere(mask):
            off = f"{away[y, x] / now.footprint[y, x]:.1f} pixels off"
            into.append(Stale(frame, int(x), int(y), why or off))


def _taps(
    now: Truth, before: Truth, size: tuple[int, int]
) -> list[tuple[tuple[NDArray[np.intp], ...], Mask]]:
    """The four texels around each pixel's place in the frame before, and whether each of them holds
    the same body, and the place lies in the picture."""
    place = np.full((*now.covered.shape, 2), -1e3)
    for number, matrix in before.matrices.items():
        mine = now.covered & (now.body == number)
        where, w = project(matrix, now.position[mine], size)
        place[mine] = np.where((w > 0.0)[:, None], np.nan_to_num(where, nan=-1e3), -1e3)
    place = np.clip(place, -1e4, 1e4)
    # At rest a pixel lies where it lay, but its point as it is drawn is off by a little.
    inside = ((place >= 0.5 - AT_REST) & (place <= np.asarray(size) - 0.5 + AT_REST)).all(-1)
    return [
        (tap, inside & before.covered[tap] & (before.body[tap] == now.body))
        for tap in taps(place, size)
    ]

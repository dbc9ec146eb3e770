"""How cameras and objects move, as a scene file says it. Matrices: ``camera.py``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from shadercache.scene.models.pose import Pose
from shadercache.scene.toml_reader import Table

Vector = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Camera:
    """A perspective camera at rest: world-space points, the vertical angle in degrees."""

    eye: Vector
    target: Vector
    up: Vector
    fov_degrees: float
    near: float
    far: float


@dataclass(frozen=True, slots=True)
class Key:
    """Where a camera is at a frame. ``cut``: it jumps there, and runners are told so."""

    frame: int
    eye: Vector
    target: Vector
    up: Vector
    fov_degrees: float
    cut: bool = False


@dataclass(frozen=True, slots=True)
class CameraPath:
    """How a camera leaves its place: about its target, or along keys (Catmull-Rom between them).

    ``degrees_per_frame``: of an orbit, about ``Camera.up``. Before the first key and after the last
    the camera rests there. ``recorded_cuts``: frames of cuts that a recording tells of.
    """

    degrees_per_frame: float = 0.0
    keys: tuple[Key, ...] = ()
    recorded_cuts: frozenset[int] = frozenset()

    @property
    def cuts(self) -> frozenset[int]:
        """The frames at which runners are told of a cut."""
        return self.recorded_cuts.union(key.frame for key in self.keys if key.cut)


REST = CameraPath()


@dataclass(frozen=True, slots=True)
class Playback:
    """Which part of a scene's path is shown, and how fast: frame 0 of a run shows ``start``, and
    each one after it ``step`` frames of the scene more."""

    start: int = 0
    step: int = 1

    def at(self, frame: int) -> int:
        """The frame of the scene that a frame of a run shows."""
        return self.start + self.step * frame


AS_WRITTEN = Playback()


@dataclass(frozen=True, slots=True)
class Motion:
    """An object turns about an axis through its pivot, and drifts; ``frames``: the path's length.

    ``position`` at frame 0 and ``velocity`` (a frame) are in world space. ``jumps``: from a frame
    on it is at another position. ``visible``: it is there from the first frame of a pair to before
    the second; always without any. ``pivot``: the point of the object that it turns about.
    ``pose``: what a part of a model does by itself, before all that.
    """

    axis: Vector
    degrees_per_frame: float
    start_degrees: float
    frames: int
    position: Vector = (0.0, 0.0, 0.0)
    velocity: Vector = (0.0, 0.0, 0.0)
    scale: float = 1.0
    jumps: tuple[tuple[int, Vector], ...] = ()
    visible: tuple[tuple[int, int], ...] = ()
    pivot: Vector = (0.0, 0.0, 0.0)
    pose: Pose | None = None

    def is_there(self, frame: int) -> bool:
        """Is the object in the scene at a frame?"""
        return not self.visible or any(first <= frame < end for first, end in self.visible)

    def place(self, frame: int) -> Vector:
        """Where the object's origin is in the world."""
        start, base = 0, self.position
        for jump, position in self.jumps:
            if jump <= frame:
                start, base = jump, position
        x, y, z = (
            at + step * (frame - start) for at, step in zip(base, self.velocity, strict=True)
        )
        return x, y, z


RESTING_CAMERA = Camera((0.0, 0.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 45.0, 0.1, 100.0)
RESTING_MOTION = Motion((0.0, 1.0, 0.0), 0.0, 0.0, 64)
"""Of scenes that are one full-screen triangle, which neither moves."""


def read_camera(table: Table) -> tuple[Camera, CameraPath]:
    """``[camera]`` with its ``path``."""
    camera = Camera(
        eye=table.vector("eye"),
        target=table.vector("target", (0.0, 0.0, 0.0)),
        up=table.vector("up", (0.0, 1.0, 0.0)),
        fov_degrees=table.number("fov_degrees"),
        near=table.number("near"),
        far=table.number("far"),
    )
    in_range = 0.0 < camera.fov_degrees < 180.0
    table.require(in_range, "fov_degrees", "camera.fov_degrees must lie between 0 and 180")
    if table.has("near") and table.has("far"):
        in_order = 0.0 < camera.near < camera.far
        table.require(in_order, "near", "camera.near must be above 0 and below camera.far")
    if table.has("eye"):
        table.require(_spans(camera), "eye", "camera.eye, target and up do not span a view")
    return camera, _read_path(table.table("path"), camera) if table.has("path") else REST


def _read_path(table: Table, camera: Camera) -> CameraPath:
    turn = table.number("degrees_per_frame", 0.0)
    keys: list[Key] = []
    for entry in table.tables("keys"):
        key = _read_key(entry, keys[-1] if keys else camera)
        later = not keys or key.frame > keys[-1].frame
        entry.require(later, "frame", f"{entry.name}.frame must be above the one before")
        keys.append(key)
    table.require(not (keys and turn), "keys", f"{table.name} is an orbit or has keys, not both")
    return CameraPath(turn, tuple(keys))


def _read_key(table: Table, before: Key | Camera) -> Key:
    """What a key does not say is as in the key before it, or as the camera is."""
    key = Key(
        frame=table.whole("frame", None, least=0),
        eye=table.vector("eye", before.eye),
        target=table.vector("target", before.target),
        up=table.vector("up", before.up),
        fov_degrees=table.number("fov_degrees", before.fov_degrees),
        cut=table.boolean("cut", False),
    )
    spans = _spans(key) and 0.0 < key.fov_degrees < 180.0
    table.require(spans, "eye", f"{table.name}: eye, target and up do not span a view")
    return key


def _spans(camera: Camera | Key) -> bool:
    a = [target - eye for eye, target in zip(camera.eye, camera.target, strict=True)]
    b = camera.up
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    # Relative, since scenes have any size. Zero vectors do not pass either.
    return max(map(abs, cross)) > 1e-9 * max(map(abs, a)) * max(map(abs, b))


def read_motion(table: Table, turn: float) -> Motion:
    """``[motion]``, by default with ``turn`` degrees a frame."""
    motion = Motion(
        axis=table.vector("axis", (0.0, 1.0, 0.0)),
        degrees_per_frame=table.number("degrees_per_frame", turn),
        start_degrees=table.number("start_degrees", 0.0),
        frames=table.whole("frames", 64, least=1),
        position=table.vector("position", (0.0, 0.0, 0.0)),
        velocity=table.vector("velocity", (0.0, 0.0, 0.0)),
        scale=table.number("scale", 1.0),
        jumps=tuple(
            (jump.whole("frame", None, least=0), jump.vector("position"))
            for jump in table.tables("jumps")
        ),
        pivot=table.vector("pivot", (0.0, 0.0, 0.0)),
        visible=tuple((a, b) for a, b in table.rows("visible", "pairs of frames", _is_span)),
    )
    frames = [frame for frame, _ in motion.jumps]
    table.require(frames == sorted(frames), "jumps", f"{table.name}.jumps must be in their order")
    table.require(any(motion.axis), "axis", f"{table.name}.axis must not be zero")
    table.require(motion.scale > 0.0, "scale", f"{table.name}.scale must be above zero")
    return motion


def _is_span(value: Any) -> bool:
    whole = isinstance(value, list) and all(type(number) is int for number in value)
    return whole and len(value) == 2 and 0 <= value[0] < value[1]

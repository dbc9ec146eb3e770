"""A scene: objects with shaders, meshes, motion and inputs before a camera, from a TOML file.

``load_scene`` checks everything that can be checked without OpenGL and without opening a mesh;
paths in the file are relative to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, cast, get_args

from shadercache.analysis.mapping import MappingKind
from shadercache.scene.graphics_state import PLAIN, GraphicsState, read_engine
from shadercache.scene.models.load import FORMATS, is_model
from shadercache.scene.models.pose import Pose
from shadercache.scene.motion import (
    AS_WRITTEN,
    REST,
    RESTING_CAMERA,
    RESTING_MOTION,
    Camera,
    CameraPath,
    Motion,
    Playback,
    read_camera,
    read_motion,
)
from shadercache.scene.object_inputs import Inputs, read_changes, read_inputs, read_names
from shadercache.scene.recording import Recording, causes_of, check_objects, read_recording
from shadercache.scene.toml_reader import Table, is_numbers, read_toml

REUSE = ("on", "miss", "off")
"""What an object does with the cache where variants ask (``mask``): it reuses; it misses and stores
anew; it misses, and what it stores is not reused either."""

Bounds = tuple[tuple[float, ...], tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class View:
    """What all objects are drawn with: a camera, the application's state, and a clock.

    ``start_time``: the seconds that the clock shows in frame 0 of the scene. Wherever a frame is
    asked for, it is one of a run: ``playback`` says what that shows.
    """

    camera: Camera = RESTING_CAMERA
    camera_path: CameraPath = REST
    engine: GraphicsState = PLAIN
    start_time: float = 0.0
    playback: Playback = AS_WRITTEN

    def is_cut(self, frame: int) -> bool:
        """Does the camera jump between the frame before and this one?"""
        shown = range(self.playback.at(frame - 1) + 1, self.playback.at(frame) + 1)
        return not self.camera_path.cuts.isdisjoint(shown)


@dataclass(frozen=True, slots=True)
class Caching:
    """What is cached of an object, and how.

    ``node`` (an id, or several joined by ``+``) is that of an object with shaders of its own.
    Unless it is ``on``, the original draws the object; unless it is ``allowed``, always. ``block``
    goes before that of a run, ``period`` if it is shorter. ``mask`` is for the uniform of that
    role, an index of :data:`REUSE`.
    """

    on: bool = True
    node: str | None = None
    period: int | None = None
    block: int | None = None
    mask: int = 0
    allowed: bool = True


@dataclass(frozen=True, eq=False)
class SceneObject:
    """What is drawn: shaders, mesh, motion, inputs.

    Without a mesh it is a triangle that covers the picture, ``mesh.FULL_SCREEN``, and may do
    without a vertex shader. ``verify_mesh`` is a small stand-in. ``own_shader``: it is not drawn by
    the scene's shaders. ``bounds``: a box in object space that it never leaves, so that it need not
    be drawn while that is outside of the picture.
    """

    name: str
    fragment: Path
    vertex: Path | None = None
    mesh: Path | None = None
    verify_mesh: Path | None = None
    cull: bool = False
    motion: Motion = RESTING_MOTION
    inputs: Inputs = field(default_factory=Inputs)
    own_shader: bool = False
    caching: Caching = Caching()
    bounds: Bounds | None = None

    @property
    def part(self) -> str | None:
        """The part of a model that its mesh is."""
        pose = self.motion.pose
        # A stand-in or another mesh has no such part.
        return pose.part if pose is not None and pose.path == self.mesh else None


@dataclass(frozen=True, slots=True)
class Demo:
    """What the demo shows of a scene."""

    nodes: tuple[str, ...]
    period: int
    block: int


@dataclass(frozen=True, slots=True)
class SceneReading:
    """How the shaders of a scene are analysed: as ``ReadOptions`` says of these fields."""

    unroll: bool = False
    approximate: bool = False
    moving: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Scene:
    """A checked scene.

    ``common`` is what its objects are unless they say otherwise, and the only object of a scene
    without any. ``changes`` says why a uniform or a texture changes, by its name: one of
    ``object_inputs.CAUSES``. ``nodes`` are names for node ids. ``mapping`` is how payloads are
    found, if the scene says it. ``recording`` is what was laid over it.
    """

    path: Path
    name: str
    title: str
    common: SceneObject
    view: View = View()
    objects: tuple[SceneObject, ...] = ()
    nodes: Mapping[str, str] = field(default_factory=dict)
    changes: Mapping[str, str] = field(default_factory=dict)
    demo: Demo | None = None
    reading: SceneReading = SceneReading()
    mapping: MappingKind | None = None
    recording: Recording | None = None

    @property
    def parts(self) -> tuple[SceneObject, ...]:
        """What is drawn."""
        return self.objects or (self.common,)

    @property
    def small(self) -> Scene:
        """The scene with the small stand-ins of its meshes, where there are any."""
        common, *objects = (
            replace(scene_object, mesh=scene_object.verify_mesh or scene_object.mesh)
            for scene_object in (self.common, *self.objects)
        )
        return replace(self, common=common, objects=tuple(objects))

    def alone(self, scene_object: SceneObject) -> Scene:
        """A scene of nothing but this object. What moves by name is said of other shaders."""
        reading = replace(self.reading, moving=())
        return replace(self, common=scene_object, objects=(), reading=reading)

    def played(self, start: int, step: int = 1) -> Scene:
        """The same scene from another frame of its path on, or at another speed."""
        return replace(self, view=replace(self.view, playback=Playback(start, step)))

    def seen_from(self, camera: Camera, path: CameraPath = REST) -> Scene:
        """The same scene before another camera."""
        return replace(self, view=replace(self.view, camera=camera, camera_path=path))


def load_scene(path: Path) -> Scene:
    """Read a scene file, or ``scene.toml`` in the given folder.

    Raises:
        InputError: SC501-SC507, one diagnostic for each mistake, with the file and the key; as
            ``read_recording`` and ``recorded``.
    """
    if path.is_dir():
        path = path / "scene.toml"
    top = Table(*read_toml(path))
    known = get_args(MappingKind)
    mapping = top.text("mapping", known[0], known) if top.has("mapping") else None
    many = top.has("objects")
    # A full-screen scene is not asked for camera and motion: there they are unknown keys.
    flat = mapping not in (None, "surface") and not top.has("mesh") and not many
    common = SceneObject(
        name=top.text("name"),
        fragment=top.file("fragment"),
        vertex=None if flat and not top.has("vertex") else top.file("vertex"),
        # Where all objects have meshes of their own, the scene need not have one.
        mesh=None if flat or (many and not top.has("mesh")) else top.file("mesh"),
        verify_mesh=top.optional_file("verify_mesh"),
        cull=_culls(top, False),
        motion=RESTING_MOTION if flat else read_motion(top.table("motion"), 0.0 if many else 1.0),
        inputs=read_inputs(top),
    )
    camera, camera_path = (RESTING_CAMERA, REST) if flat else read_camera(top.table("camera"))
    common = _posed(top, common, None)
    engine = read_engine(top.table("engine"))
    nodes = read_names(top.table("nodes"))
    scene = Scene(
        path=path,
        name=common.name,
        title=top.text("title", path.parent.name or "scene"),
        common=common,
        view=View(camera, camera_path, engine, top.number("start_time", 0.0)),
        objects=_objects(top, common, nodes),
        nodes=nodes,
        changes=read_changes(top.table("changes"), common.inputs),
        demo=_demo(top.table("demo")) if top.has("demo") else None,
        reading=SceneReading(
            top.boolean("unroll", False), top.boolean("approximate", False), top.texts("moving")
        ),
        mapping=cast(MappingKind | None, mapping),
    )
    recording = top.table("recording").file("file") if top.has("recording") else None
    top.finish()
    return scene if recording is None else recorded(scene, read_recording(recording))


def recorded(scene: Scene, recording: Recording) -> Scene:
    """The scene with the recording's values for the uniforms that it names.

    The path is as long as the recording, and cut where that is. Nothing that has recorded values is
    left out for lying outside of the picture: where it is, the scene does not know.

    Raises:
        InputError: SC551 for an object that the scene does not have. Names of uniforms are checked
            where shaders are linked.
    """
    check_objects(recording, scene.name, [part.name for part in scene.parts])

    def played(part: SceneObject, name: str | None) -> SceneObject:
        tracks = recording.of(None) | (recording.of(name) if name else {})
        return replace(
            part,
            inputs=Inputs(animated=tracks).over(part.inputs),
            motion=replace(part.motion, frames=recording.frames),
            bounds=None if tracks else part.bounds,
        )

    path = replace(scene.view.camera_path, recorded_cuts=recording.cuts)
    return replace(
        scene,
        # Objects have what is common from here as well, but for what is said of one alone.
        common=played(scene.common, None if scene.objects else scene.common.name),
        objects=tuple(played(part, part.name) for part in scene.objects),
        view=replace(scene.view, camera_path=path),
        changes={**causes_of(recording), **scene.changes},
        recording=recording,
    )


def _objects(top: Table, common: SceneObject, nodes: Mapping[str, str]) -> tuple[SceneObject, ...]:
    objects: list[SceneObject] = []
    for table in top.tables("objects"):
        scene_object = _object(table, common, nodes)
        # Copies, each at its place instead of motion.position.
        places = table.rows("places", "points", lambda value: is_numbers(value, 3))
        objects += [
            replace(
                scene_object,
                name=f"{scene_object.name} {number}",
                motion=replace(scene_object.motion, position=(float(x), float(y), float(z))),
            )
            for number, (x, y, z) in enumerate(places, start=1)
        ] or [scene_object]
    names = {part.name for part in objects}
    top.require(len(names) == len(objects), "objects", "objects must have names of their own")
    return tuple(objects)


def _object(table: Table, common: SceneObject, nodes: Mapping[str, str]) -> SceneObject:
    """One object; what its table does not say is as ``common`` has it."""
    own = table.has("fragment") or table.has("vertex")
    mesh = table.file("mesh", common.mesh)
    # A stand-in belongs to its mesh: for another one it would be the wrong shape.
    stand_in = common.verify_mesh if mesh == common.mesh else None
    made = SceneObject(
        name=table.text("name"),
        fragment=table.file("fragment", common.fragment),
        vertex=table.file("vertex") if table.has("vertex") else common.vertex,
        mesh=mesh,
        verify_mesh=table.optional_file("verify_mesh") or stand_in,
        cull=_culls(table, common.cull),
        motion=read_motion(table.table("motion"), 0.0) if table.has("motion") else common.motion,
        inputs=read_inputs(table).over(common.inputs),
        own_shader=own,
        caching=_caching(table, own, {**nodes, **read_names(table.table("nodes"))}),
        bounds=_bounds(table),
    )
    return _posed(table, made, common.motion.pose)


def _posed(table: Table, made: SceneObject, common: Pose | None) -> SceneObject:
    """The object as a part of a model; what its table does not say is as ``common`` has it."""
    inherited = common if common is not None and common.path == made.mesh else None
    part = inherited.part if inherited else None
    part = table.text("part") if table.has("part") else part
    animation = table.text("animation") if table.has("animation") else None
    speed = table.number("animation_speed", inherited.speed if inherited else 1.0)
    model = made.mesh is not None and is_model(made.mesh)
    message = f"{table.full('part')}: only a model has parts ({', '.join(FORMATS)})"
    table.require(part is None or model, "part", message)
    message = f"{table.full('animation')} needs the part that it moves: part = ..."
    table.require(animation is None or part is not None, "animation", message)
    if part is None or made.mesh is None:
        return replace(made, motion=replace(made.motion, pose=None))
    played = animation or (inherited.animation if inherited else None)
    pose = Pose(made.mesh, part, played, speed)
    return replace(made, motion=replace(made.motion, pose=pose))


def _culls(table: Table, default: bool) -> bool:
    return table.text("cull", "back" if default else "none", ("none", "back")) == "back"


def _caching(table: Table, own_shader: bool, nodes: Mapping[str, str]) -> Caching:
    node = table.text("node") if table.has("node") else None
    message = f"{table.full('node')}: an object has a node of its own only with its own shader"
    table.require(own_shader or node is None, "node", message)
    allowed = table.boolean("cached", True)
    return Caching(
        # The id of a node means nothing in another shader.
        on=allowed and (node is not None or not own_shader),
        node=None if node is None else "+".join(nodes.get(part, part) for part in node.split("+")),
        period=table.whole("period", None, least=1) if table.has("period") else None,
        block=table.whole("block", None, least=2) if table.has("block") else None,
        mask=REUSE.index(table.text("reuse", REUSE[0], REUSE)),
        allowed=allowed,
    )


def _bounds(table: Table) -> Bounds | None:
    corners = table.checked("bounds", "two corners of a box", _is_box, ())
    if not corners:
        return None
    low, high = (tuple(map(float, corner)) for corner in corners)
    return low, high


def _is_box(value: Any) -> bool:
    points = isinstance(value, list) and len(value) == 2
    if not points or not all(is_numbers(corner, 3) for corner in value):
        return False
    return all(low <= high for low, high in zip(*value, strict=True))


def _demo(table: Table) -> Demo:
    nodes = table.texts("nodes")
    return Demo(nodes, table.whole("period", 32, least=1), table.whole("block", 4, least=2))

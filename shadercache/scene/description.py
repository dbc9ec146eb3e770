"""A scene: shaders, meshes, camera, motion, uniforms and textures, read from a TOML file.

``load_scene`` checks everything that can be checked without OpenGL and without opening a mesh;
paths in the file are relative to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import cast, get_args

from shadercache.analysis.mapping import MappingKind
from shadercache.scene.animation import Animations
from shadercache.scene.graphics_state import PLAIN, GraphicsState, read_engine
from shadercache.scene.input_tables import (
    CAUSES,
    SEMANTICS,
    TextureSpec,
    Uniforms,
    causes,
    is_text,
    read_changes,
    read_strings,
    read_textures,
    read_uniforms,
)
from shadercache.scene.motion import (
    REST,
    RESTING_CAMERA,
    RESTING_MOTION,
    Camera,
    CameraPath,
    Key,
    Motion,
    read_camera,
    read_motion,
)
from shadercache.scene.toml_reader import Table, is_number, read_toml

__all__ = [
    "CAUSES",
    "RESTING_CAMERA",
    "RESTING_MOTION",
    "SEMANTICS",
    "Camera",
    "CameraPath",
    "Demo",
    "GraphicsState",
    "Key",
    "Motion",
    "Scene",
    "SceneObject",
    "TextureSpec",
    "causes",
    "load_scene",
]


@dataclass(frozen=True, slots=True)
class Demo:
    """What the demo shows of a scene."""

    nodes: tuple[str, ...]
    period: int
    block: int


@dataclass(frozen=True, eq=False)
class Scene:
    """A checked scene.

    ``constants`` hold the numbers of a uniform in the order of upload: the components of a vector,
    the columns of a matrix, the elements of an array. ``changes`` says why a uniform or a texture
    changes, by its name: one of :data:`CAUSES`. ``nodes`` are names for node ids.

    Without a mesh the scene is a triangle that covers the picture, ``mesh.FULL_SCREEN``, and may do
    without a vertex shader. ``mapping`` is how its payloads are found, if the scene says it;
    ``start_time`` are the seconds that its clock shows in frame 0.

    A scene of several ``objects`` draws these; what it says itself is what they have in common.
    """

    path: Path
    name: str
    title: str
    fragment: Path
    vertex: Path | None
    mesh: Path | None
    verify_mesh: Path | None
    attributes: Mapping[str, str]
    camera: Camera
    motion: Motion
    constants: Mapping[str, tuple[float, ...]]
    semantics: Mapping[str, str]
    textures: Mapping[str, TextureSpec]
    nodes: Mapping[str, str]
    demo: Demo | None
    cull: bool
    changes: Mapping[str, str]
    unroll: bool = False
    mapping: MappingKind | None = None
    start_time: float = 0.0
    animated: Animations = field(default_factory=dict)
    camera_path: CameraPath = REST
    engine: GraphicsState = PLAIN
    objects: tuple[SceneObject, ...] = ()

    @property
    def parts(self) -> tuple[SceneObject, ...]:
        """What is drawn: the objects, or the scene itself as the only one."""
        return self.objects or (SceneObject(self.name, self),)

    def seen_from(self, camera: Camera, path: CameraPath = REST) -> Scene:
        """The same scene before another camera."""
        objects = tuple(
            replace(item, scene=item.scene.seen_from(camera, path)) for item in self.objects
        )
        return replace(self, camera=camera, camera_path=path, objects=objects)


REUSE = ("on", "miss", "off")
"""What an object does with the cache where variants ask (``mask``): it reuses; it misses and stores
anew; it misses, and what it stores is not reused either."""


@dataclass(frozen=True, eq=False)
class SceneObject:
    """One object: ``scene`` is the scene as far as it concerns this object, without others.

    ``own_shader``: it is not drawn by the scene's shaders; ``node`` (an id, or several joined by
    ``+``) is then what is cached of it, if anything is. Without ``cached`` its original draws it.
    ``block`` goes before that of a run, ``period`` if it is shorter. ``mask`` is for the uniform of
    that role, an index of :data:`REUSE`. ``bounds``: a box in object space that it never leaves, so
    that it need not be drawn while that is outside of the picture.
    """

    name: str
    scene: Scene
    own_shader: bool = False
    node: str | None = None
    cached: bool = True
    period: int | None = None
    block: int | None = None
    mask: int = 0
    bounds: tuple[tuple[float, ...], tuple[float, ...]] | None = None


def load_scene(path: Path) -> Scene:
    """Read a scene file, or ``scene.toml`` in the given folder.

    Raises:
        InputError: SC501-SC507, one diagnostic for each mistake, with the file and the key.
    """
    if path.is_dir():
        path = path / "scene.toml"
    source, values = read_toml(path)
    top = Table(source, values)
    uniforms = read_uniforms(top.table("uniforms"))
    mapping = _mapping(top)
    many = top.has("objects")
    flat = mapping not in (None, "surface") and not top.has("mesh") and not many
    camera, path_of_camera = (RESTING_CAMERA, REST) if flat else read_camera(top.table("camera"))
    scene = Scene(
        path=path,
        name=top.text("name"),
        title=top.text("title", path.parent.name or "scene"),
        fragment=top.file("fragment"),
        vertex=None if flat and not top.has("vertex") else top.file("vertex"),
        mesh=None if flat or (many and not top.has("mesh")) else top.file("mesh"),
        verify_mesh=top.file("verify_mesh") if top.has("verify_mesh") else None,
        attributes=read_strings(top.table("attributes")),
        camera=camera,
        motion=RESTING_MOTION if flat else read_motion(top.table("motion"), 0.0 if many else 1.0),
        constants=uniforms.constants,
        semantics=uniforms.semantics,
        textures=read_textures(top.table("textures")),
        nodes=read_strings(top.table("nodes")),
        demo=_demo(top.table("demo")) if top.has("demo") else None,
        cull=top.text("cull", "none", ("none", "back")) == "back",
        changes=read_changes(top.table("changes"), uniforms),
        unroll=top.boolean("unroll", False),
        mapping=mapping,
        start_time=top.number("start_time", 0.0),
        animated=uniforms.animated,
        camera_path=path_of_camera,
        engine=read_engine(top.table("engine")) if top.has("engine") else PLAIN,
    )
    scene = replace(scene, objects=_objects(top, scene, uniforms))
    top.refuse_unknown()
    top.raise_problems()
    return scene


def _objects(top: Table, scene: Scene, shared: Uniforms) -> tuple[SceneObject, ...]:
    found: list[SceneObject] = []
    for table in top.tables("objects"):
        item = _object(table, scene, shared)
        places = _places(table)
        table.refuse_unknown()
        found += [_copy(item, number, place) for number, place in enumerate(places)] or [item]
    names = [item.name for item in found]
    if len(set(names)) != len(names):
        top.problem("SC505", "objects", "objects must have names of their own")
    return tuple(found)


def _object(table: Table, scene: Scene, shared: Uniforms) -> SceneObject:
    """One object; what its table does not say is as the scene says it."""
    uniforms = read_uniforms(table.table("uniforms")).over(shared)
    mesh = table.file("mesh") if table.has("mesh") or scene.mesh is None else scene.mesh
    small = table.file("verify_mesh") if table.has("verify_mesh") else None
    motion = read_motion(table.table("motion"), 0.0) if table.has("motion") else scene.motion
    own = table.has("fragment") or table.has("vertex")
    nodes = {**scene.nodes, **read_strings(table.table("nodes"))}
    own_scene = replace(
        scene,
        fragment=table.file("fragment") if table.has("fragment") else scene.fragment,
        vertex=table.file("vertex") if table.has("vertex") else scene.vertex,
        mesh=mesh,
        verify_mesh=small or (scene.verify_mesh if mesh == scene.mesh else None),
        attributes={**scene.attributes, **read_strings(table.table("attributes"))},
        motion=motion,
        constants=uniforms.constants,
        semantics=uniforms.semantics,
        animated=uniforms.animated,
        textures={**scene.textures, **read_textures(table.table("textures"))},
        nodes=nodes,
        cull=table.text("cull", "back" if scene.cull else "none", ("none", "back")) == "back",
    )
    node = table.text("node") if table.has("node") else None
    if node is not None and not own:
        message = f"{table.full('node')}: an object has a node of its own only with its own shader"
        table.problem("SC505", "node", message)
    cached = table.boolean("cached", True)
    return SceneObject(
        name=table.text("name"),
        scene=own_scene,
        own_shader=own,
        node=None if node is None else "+".join(nodes.get(part, part) for part in node.split("+")),
        cached=cached and (node is not None or not own),
        period=table.whole("period", None, least=1) if table.has("period") else None,
        block=table.whole("block", None, least=2) if table.has("block") else None,
        mask=REUSE.index(table.text("reuse", REUSE[0], REUSE)),
        bounds=_bounds(table),
    )


def _places(table: Table) -> list[tuple[float, float, float]]:
    """Where copies of the object stand, each at its place instead of ``motion.position``."""
    value = table.values.get("places", [])
    if table.has("places") and not (isinstance(value, list) and all(map(_is_point, value))):
        table.problem("SC505", "places", f"{table.full('places')} must be points, not {value!r}")
        return []
    return [(float(x), float(y), float(z)) for x, y, z in value]


def _copy(item: SceneObject, number: int, place: tuple[float, float, float]) -> SceneObject:
    motion = replace(item.scene.motion, position=place)
    scene = replace(item.scene, motion=motion)
    return replace(item, name=f"{item.name} {number + 1}", scene=scene)


def _mask(table: Table) -> int:
    mask = table.whole("mask", 0, least=0)
    if mask > 2:
        table.problem("SC505", "mask", f"{table.full('mask')} must be 0, 1 or 2")
    return mask


def _bounds(table: Table) -> tuple[tuple[float, ...], tuple[float, ...]] | None:
    value = table.values.get("bounds")
    if not table.has("bounds"):
        return None
    if isinstance(value, list) and len(value) == 2 and all(map(_is_point, value)):
        low, high = (tuple(map(float, corner)) for corner in value)
        if all(a <= b for a, b in zip(low, high, strict=True)):
            return low, high
    table.problem("SC505", "bounds", f"{table.full('bounds')} must be two corners of a box")
    return None


def _is_point(value: object) -> bool:
    return isinstance(value, list) and len(value) == 3 and all(map(is_number, value))


def _mapping(top: Table) -> MappingKind | None:
    known = get_args(MappingKind)
    return cast(MappingKind, top.text("mapping", known[0], known)) if top.has("mapping") else None


def _demo(table: Table) -> Demo:
    nodes = table.values.get("nodes", [])
    if table.has("nodes") and not (isinstance(nodes, list) and all(map(is_text, nodes))):
        table.problem("SC505", "nodes", "demo.nodes must be an array of strings")
        nodes = []
    period = table.whole("period", 32, least=1)
    demo = Demo(tuple(nodes), period, table.whole("block", 4, least=2))
    table.refuse_unknown()
    return demo

"""A scene: shaders, mesh, camera, motion, uniforms and textures, read from a TOML file.

``load_scene`` checks everything that can be checked without OpenGL and without opening the mesh;
paths in the file are relative to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast, get_args

from shadercache.harness.toml_reader import Table, is_number, read_toml
from shadercache.options import MappingKind

SEMANTICS = (
    "model",
    "view",
    "projection",
    "model-view",
    "view-projection",
    "model-view-projection",
    "normal-matrix",
    "eye",
    "time",
    "time-delta",
    "frame",
    "resolution",
    "resolution-aspect",
)
"""What a uniform can be tied to; ``camera.semantic_values`` and ``scene_values`` define each."""

CAUSES = ("view", "light", "time")
"""Why a uniform may change from frame to frame. Those with a semantic tell it by that."""


@dataclass(frozen=True, slots=True)
class Camera:
    """A perspective camera at rest: world-space points, the vertical angle in degrees."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    up: tuple[float, float, float]
    fov_degrees: float
    near: float
    far: float


@dataclass(frozen=True, slots=True)
class Motion:
    """The object turns about an axis through the origin; ``frames`` is the length of the path."""

    axis: tuple[float, float, float]
    degrees_per_frame: float
    start_degrees: float
    frames: int


RESTING_CAMERA = Camera((0.0, 0.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 45.0, 0.1, 100.0)
RESTING_MOTION = Motion((0.0, 1.0, 0.0), 0.0, 0.0, 64)
"""Of scenes that are one full-screen triangle, which neither moves."""


@dataclass(frozen=True, slots=True)
class TextureSpec:
    """A texture file and how it is sampled. ``made``: it is generated, and ``path`` says what."""

    path: Path
    filter: str
    mipmap: bool
    wrap: str
    anisotropy: float
    made: bool = False


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


def load_scene(path: Path) -> Scene:
    """Read a scene file, or ``scene.toml`` in the given folder.

    Raises:
        InputError: SC501-SC507, one diagnostic for each mistake, with the file and the key.
    """
    if path.is_dir():
        path = path / "scene.toml"
    source, values = read_toml(path)
    top = Table(source, values)
    constants, semantics = _uniforms(top.table("uniforms"))
    mapping = _mapping(top)
    flat = mapping not in (None, "surface") and not top.has("mesh")
    scene = Scene(
        path=path,
        name=top.text("name"),
        title=top.text("title", path.parent.name or "scene"),
        fragment=top.file("fragment"),
        vertex=None if flat and not top.has("vertex") else top.file("vertex"),
        mesh=None if flat else top.file("mesh"),
        verify_mesh=top.file("verify_mesh") if top.has("verify_mesh") else None,
        attributes=_strings(top.table("attributes")),
        camera=RESTING_CAMERA if flat else _camera(top.table("camera")),
        motion=RESTING_MOTION if flat else _motion(top.table("motion")),
        constants=constants,
        semantics=semantics,
        textures=_textures(top.table("textures")),
        nodes=_strings(top.table("nodes")),
        demo=_demo(top.table("demo")) if top.has("demo") else None,
        cull=top.text("cull", "none", ("none", "back")) == "back",
        changes=_changes(top.table("changes"), semantics),
        unroll=top.boolean("unroll", False),
        mapping=mapping,
        start_time=top.number("start_time", 0.0),
    )
    top.refuse_unknown()
    top.raise_problems()
    return scene


def _mapping(top: Table) -> MappingKind | None:
    known = get_args(MappingKind)
    return cast(MappingKind, top.text("mapping", known[0], known)) if top.has("mapping") else None


def _camera(table: Table) -> Camera:
    camera = Camera(
        eye=table.vector("eye"),
        target=table.vector("target", (0.0, 0.0, 0.0)),
        up=table.vector("up", (0.0, 1.0, 0.0)),
        fov_degrees=table.number("fov_degrees"),
        near=table.number("near"),
        far=table.number("far"),
    )
    table.refuse_unknown()
    if table.has("fov_degrees") and not 0.0 < camera.fov_degrees < 180.0:
        table.problem("SC505", "fov_degrees", "camera.fov_degrees must lie between 0 and 180")
    if table.has("near") and table.has("far") and not 0.0 < camera.near < camera.far:
        table.problem("SC505", "near", "camera.near must be above 0 and below camera.far")
    looks = [target - eye for eye, target in zip(camera.eye, camera.target, strict=True)]
    if table.has("eye") and _parallel(looks, camera.up):
        table.problem("SC505", "eye", "camera.eye, target and up do not span a view")
    return camera


def _parallel(a: list[float], b: tuple[float, float, float]) -> bool:
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    return max(map(abs, cross)) <= 1e-9 * max(map(abs, a)) * max(map(abs, b))


def _motion(table: Table) -> Motion:
    motion = Motion(
        axis=table.vector("axis", (0.0, 1.0, 0.0)),
        degrees_per_frame=table.number("degrees_per_frame", 1.0),
        start_degrees=table.number("start_degrees", 0.0),
        frames=table.whole("frames", 64, least=1),
    )
    table.refuse_unknown()
    if not any(motion.axis):
        table.problem("SC505", "axis", "motion.axis must not be zero")
    return motion


def _uniforms(table: Table) -> tuple[dict[str, tuple[float, ...]], dict[str, str]]:
    constants: dict[str, tuple[float, ...]] = {}
    semantics: dict[str, str] = {}
    for name, value in table.values.items():
        if isinstance(value, str) or (isinstance(value, dict) and set(value) == {"semantic"}):
            word = value if isinstance(value, str) else value["semantic"]
            semantics[name] = word
            if word not in SEMANTICS:
                message = f"{table.full(name)}: unknown semantic {word!r}"
                table.problem("SC506", name, message, hint=f"one of {', '.join(SEMANTICS)}")
            continue
        constant = _constant(value)
        if constant is None:
            wanted = "a number, an array of numbers, or a semantic"
            table.problem("SC505", name, f"{table.full(name)} must be {wanted}, not {value!r}")
        else:
            constants[name] = constant
    return constants, semantics


def _constant(value: Any) -> tuple[float, ...] | None:
    """A number, a vector, or equally long vectors one after another; None if it is neither."""
    if isinstance(value, bool) or is_number(value):
        return (float(value),)
    if not isinstance(value, list) or not value:
        return None
    if all(map(is_number, value)):
        return tuple(map(float, value))
    if not all(isinstance(row, list) and row and all(map(is_number, row)) for row in value):
        return None
    if len({len(row) for row in value}) != 1:
        return None
    return tuple(float(number) for row in value for number in row)


def _textures(table: Table) -> dict[str, TextureSpec]:
    specs: dict[str, TextureSpec] = {}
    for name in table.values:
        entry = table.table(name)
        specs[name] = TextureSpec(
            path=entry.file("file"),
            filter=entry.text("filter", "linear", ("linear", "nearest")),
            mipmap=entry.boolean("mipmap", False),
            wrap=entry.text("wrap", "repeat", ("repeat", "clamp")),
            anisotropy=entry.number("anisotropy", 1.0),
        )
        entry.refuse_unknown()
    return specs


def _strings(table: Table) -> dict[str, str]:
    return {name: table.text(name) for name in table.values}


def _demo(table: Table) -> Demo:
    nodes = table.values.get("nodes", [])
    if table.has("nodes") and not (isinstance(nodes, list) and all(map(_is_text, nodes))):
        table.problem("SC505", "nodes", "demo.nodes must be an array of strings")
        nodes = []
    period = table.whole("period", 32, least=1)
    demo = Demo(tuple(nodes), period, table.whole("block", 4, least=2))
    table.refuse_unknown()
    return demo


def _changes(table: Table, semantics: Mapping[str, str]) -> dict[str, str]:
    """``light = ["u_light"]`` and the like, by the names of uniforms, with what semantics tell."""
    found = causes(semantics)
    for cause in CAUSES:
        names = table.values.get(cause, [])
        if table.has(cause) and not (isinstance(names, list) and all(map(_is_text, names))):
            table.problem("SC505", cause, f"changes.{cause} must be an array of strings")
            continue
        found |= dict.fromkeys(names, cause)
    table.refuse_unknown()
    return found


def causes(semantics: Mapping[str, str]) -> dict[str, str]:
    """Why the uniforms with a semantic change, by name; those of the picture's size do not."""
    return {
        name: "time" if word in ("time", "time-delta", "frame") else "view"
        for name, word in semantics.items()
        if not word.startswith("resolution")
    }


def _is_text(value: Any) -> bool:
    return isinstance(value, str)

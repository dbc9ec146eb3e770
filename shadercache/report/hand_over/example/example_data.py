"""What the example draws: meshes, textures and the values of each frame, as arrays of a file."""

from __future__ import annotations

import io
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.manifest import interface
from shadercache.manifest.interface import InputEntry
from shadercache.report.hand_over.example.example_textures import ExampleTexture
from shadercache.report.hand_over.example.example_values import declared, dtype_of, uniform_tables
from shadercache.report.hand_over.handed_shaders import HandedObject, HandedShader
from shadercache.scene.camera import uniform_values
from shadercache.scene.description import Scene, SceneObject
from shadercache.scene.graphics_state import PLAIN
from shadercache.scene.mesh import FULL_SCREEN, Mesh, load_mesh
from shadercache.scene.object_inputs import TextureSpec

LARGEST = 20_000_000
"""Bytes that the file is kept below; textures are made smaller for it."""

ALONE = "mesh"
"""The mesh of an only object."""

Array: TypeAlias = NDArray[Any]


class UnfitForExampleError(Exception):
    """Why there is no example; the message is a clause."""


@dataclass(frozen=True, eq=False)
class ExampleObject:
    """An object in the file: the name of its mesh there, and of its textures by those that the
    shader has. ``moving``: attributes of its instances, and textures that change from frame to
    frame."""

    given: HandedObject
    mesh: str
    textures: Mapping[str, str]
    moving: tuple[str, ...] = ()


class ExampleData:
    """The arrays, by their names in the file.

    Of an object ``alone`` there are ``values/NAME``, (frames or 1, ...), ``mesh/NAME`` and
    ``index/mesh``; and ``textures/NAME``. Of others, by the folders of their shaders,
    ``values/FOLDER/NAME``, (objects or 1, frames or 1, numbers), and ``there/FOLDER/``, (objects,
    frames), where they come and go; ``MESH/NAME`` and ``index/MESH``, and of an object with arrays
    that change ``moving/MESH/NAME``, (1, frames or 1, ...).
    """

    def __init__(
        self, scene: Scene, size: tuple[int, int], frames: int, mesh: Mesh | None = None
    ) -> None:
        """Args: ``size`` of the picture in pixels; ``mesh``: in place of the scene's."""
        self.size, self.frames = size, frames
        self.objects: dict[HandedShader, tuple[ExampleObject, ...]] = {}
        self.groups: dict[HandedShader, list[int]] = {}
        self.textures: dict[str, ExampleTexture] = {}
        self.arrays: dict[str, Array] = {}
        self._mesh = mesh
        # Of the application's state the example has the most usual.
        self._view = replace(scene.view, engine=PLAIN)
        self.all_there = all(map(self.is_there, scene.parts))
        self.alone = len(scene.parts) == 1 and self.all_there
        self._names: dict[tuple[object, ...], str] = {}

    @property
    def resets(self) -> tuple[int, ...]:
        """The first frame, and those behind a cut."""
        return (0, *(at for at in range(1, self.frames) if self._view.is_cut(at)))

    def add(self, shader: HandedShader) -> None:
        """All that its objects need.

        Raises:
            UnfitForExampleError: it needs something that the example does not give.
            InputError: as ``load_mesh``, ``load_pixels`` and ``block_bytes``.
        """
        names, frames = declared(shader), range(self.frames)
        inputs = {one.name: one for one in shader.inputs if one.name in names}
        for entry in inputs.values():
            _require_usual(entry)
        values = [
            [uniform_values(self._view, item.part, at, self.size) for at in frames]
            for item in shader.objects
        ]
        for name, table in uniform_tables(shader, values).items():
            folder = "" if self.alone else shader.folder
            self.arrays[f"values/{folder}{name}"] = table[0] if self.alone else table
        if not self.all_there:
            there = [self._there(item.part) for item in shader.objects]
            self.arrays[f"there/{shader.folder}"] = np.array(there)
        self.objects[shader] = tuple(self._object(item, inputs) for item in shader.objects)

    def packed(self) -> bytes:
        """The file, with smaller textures where it would be too large.

        Raises:
            UnfitForExampleError: it is too large all the same.
        """
        while True:
            held = {f"textures/{key}": one.pixels for key, one in self.textures.items()}
            arrays: dict[str, Any] = self.arrays | held
            buffer = io.BytesIO()
            np.savez_compressed(buffer, **arrays)
            if buffer.tell() <= LARGEST:
                return buffer.getvalue()
            large = [texture for texture in self.textures.values() if texture.is_large]
            if not large:
                megabytes = buffer.tell() / 1e6
                raise UnfitForExampleError(f"meshes and values would take {megabytes:.0f} MB")
            max(large, key=lambda texture: texture.pixels.nbytes).shrink()

    def is_there(self, part: SceneObject) -> bool:
        """Is an object there in all frames?"""
        return all(self._there(part))

    def _there(self, part: SceneObject) -> list[bool]:
        """In which frames it is."""
        return [part.motion.is_there(self._view.playback.at(at)) for at in range(self.frames)]

    def _object(self, item: HandedObject, inputs: Mapping[str, InputEntry]) -> ExampleObject:
        given = item.part.inputs
        streams = {**given.instances.streams, **given.played}
        moving = {name: streams[name] for name in inputs if name in streams}
        mesh = self._mesh_of(item.part, inputs, bool(moving) or given.instances.number > 1)
        for name, stream in moving.items():
            count = self.frames if stream.moves else 1
            frames = [stream.at(self._view.playback.at(at)) for at in range(count)]
            table = np.array(frames, np.float32).reshape(count, *stream.shape)
            key = f"values/{name}" if self.alone else f"moving/{mesh}/{name}"
            self.arrays[key] = table if self.alone else table[None]
        textures: dict[str, str] = {}
        for name, entry in inputs.items():
            spec = given.textures.get(_original(entry))
            if isinstance(entry, interface.SamplerInput) and spec is not None:
                textures[name] = self._texture(_original(entry), spec)
        return ExampleObject(item, mesh, textures, tuple(moving))

    def _mesh_of(self, part: SceneObject, inputs: Mapping[str, InputEntry], own: bool) -> str:
        """The name of its mesh, which objects share if they map the same arrays to the same
        attributes; not if it has ``own`` arrays besides."""
        given = {
            name: (given_array, dtype_of(entry.type))
            for name, entry in inputs.items()
            if isinstance(entry, interface.AttributeInput)
            and (given_array := part.inputs.attributes.get(_original(entry))) is not None
        }
        key = (part.mesh, part.part, tuple(given.items()), part.name if own else None)
        if key not in self._names:
            stem = part.name if part.mesh is None or own else part.mesh.stem
            name = ALONE if self.alone else _free(self._names.values(), f"mesh {stem}")
            self._names[key] = name
            mesh = self._mesh or _mesh_of(part)
            for attribute, (array, dtype) in given.items():
                self.arrays[f"{name}/{attribute}"] = mesh.arrays[array].astype(dtype)
            self.arrays[f"index/{name}"] = mesh.index
        return self._names[key]

    def _texture(self, name: str, spec: TextureSpec) -> str:
        """The texture's name in the file: the shader's, unless another object's has that."""
        for key, texture in self.textures.items():
            if texture.spec == spec:
                return key
        key = _free(self.textures, name, spec.path.stem, f"{name} of {spec.path.stem}")
        self.textures[key] = ExampleTexture.of(spec)
        return key


def _free(taken: Collection[str], *names: str) -> str:
    """The first of the names that is not taken, or the last with a number."""
    numbered = (f"{names[-1]} {at}" for at in range(2, len(taken) + 3))
    return next(name for name in (*names, *numbered) if name not in taken)


def _mesh_of(part: SceneObject) -> Mesh:
    return FULL_SCREEN if part.mesh is None else load_mesh(part.mesh, part.part)


def _original(entry: InputEntry) -> str:
    """What it is a twin of, or its own name: of what never changes a twin is that itself."""
    of = getattr(entry, "previous_of", None)
    return of if isinstance(of, str) else entry.name


def _require_usual(entry: InputEntry) -> None:
    if isinstance(entry, interface.SamplerInput) and entry.dims:
        raise UnfitForExampleError(f"{entry.name} is an array of textures")
    rare = interface.ImageInput | interface.CounterInput | interface.StorageBlockInput
    if isinstance(entry, rare):
        raise UnfitForExampleError(f"{entry.name} is a {type(entry).__struct_config__.tag}")

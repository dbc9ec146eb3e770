"""Writes the first scene file: every guess stands beside its value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from shadercache.compiler import Analysis
from shadercache.linking.first_scene import guesses as g
from shadercache.linking.first_scene.copies import copies, is_of_instance
from shadercache.linking.first_scene.framing import FOV, FRAMES, Frame, Up, framed
from shadercache.linking.first_scene.guesses import Guess, numbers
from shadercache.linking.first_scene.shader_inputs import ShaderInputs, inputs_of
from shadercache.linking.first_scene.stand_ins import TextureFolder, relative
from shadercache.linking.made_scene import MADE_TEXTURES
from shadercache.scene.models.parts import Model, ModelPart
from shadercache.scene.models.pose import Pose
from shadercache.scene.models.skeleton import ModelAnimation

MOST_OBJECTS = 64
"""A model of more parts is drawn as one mesh at rest: each object is a draw in every pass."""


@dataclass(frozen=True)
class FirstScene:
    """The text of a scene file, how many objects it draws, and what could not be guessed.

    ``guesses``: what attributes and uniforms are given.
    """

    text: str
    objects: int
    unknown: tuple[str, ...]
    guesses: tuple[Guess, ...]


class Sources(NamedTuple):
    """What a scene is made of. ``up``: the axis of the model that points up."""

    model: Model
    fragment: Path
    vertex: Path
    up: Up = "y"


def first_scene(sources: Sources, analysis: Analysis, folder: Path, final: Path) -> FirstScene:
    """A scene of a model and a pair of shaders.

    Args:
        analysis: of the shaders.
        folder: where its textures are written.
        final: what that folder will be called; paths in the text are relative to it.

    Raises:
        InputError: SC521 for an attribute that no array fits, SC523 for too few bones, SC524 for a
            sampler without textures, SC530 for a picture that cannot be read.
    """
    textures = TextureFolder(folder, final)
    writer = _SceneWriter(sources.model, inputs_of(analysis), textures, folder, final, sources.up)
    return writer.scene(sources)


@dataclass
class _SceneWriter:
    model: Model
    inputs: ShaderInputs
    textures: TextureFolder
    folder: Path
    final: Path
    up: Up

    def scene(self, shaders: Sources) -> FirstScene:
        animations = self.model.skeleton.animations
        own = [item for item in self.inputs.attributes if is_of_instance(item)]
        shared = [item for item in self.inputs.attributes if item not in own]
        attributes = g.attributes_of(shared, self.model)
        animation = animations[0].name if animations and self._apart() else None
        # Where a model is depends on its bones, and a light's place on where the model is.
        bends = any(guess.value == '"joints"' for guess in attributes)
        frame = framed(self.model, animation, bends, self.up)
        uniforms = g.uniforms_of(self.inputs, self.model, frame)
        samplers = [text for name, text in self._samplers(self.model.parts[0]).items()]
        text = [
            *self._head(shaders, animations),
            *_camera(frame),
            *_motion(frame),
            *_group("attributes", attributes),
            *copies(own, frame, self.folder),
            *_group("uniforms", uniforms),
            *(line for lines in samplers for line in lines),
            *self._objects(animation, bends),
        ]
        unknown = [*g.unknown(uniforms), *self._without_texture()]
        count = len(self.model.parts) if self._apart() else 1
        guesses = (*attributes, *uniforms)
        return FirstScene("\n".join(text) + "\n", count, tuple(unknown), guesses)

    def _apart(self) -> bool:
        return len(self.model.parts) <= MOST_OBJECTS

    def _head(self, shaders: Sources, animations: Sequence[ModelAnimation]) -> Iterator[str]:
        model, final = self.model, self.final
        yield "# Written by 'shadercache scene' from what the shaders and the model say by name and"
        yield "# type. Where a comment says (guess), look at the picture and correct the value."
        yield "# Every key: docs/SCENES.md. Time runs at 60 frames a second."
        yield ""
        yield f"name = {_text(model.path.stem)}"
        yield f"fragment = {_text(relative(shaders.fragment, final))}"
        yield f"vertex = {_text(relative(shaders.vertex, final))}"
        mesh = f"mesh = {_text(relative(model.path, final))}"
        vertices = sum(len(part.arrays["position"]) for part in model.parts)
        faces = sum(len(part.index) for part in model.parts)
        parts = "1 part" if len(model.parts) == 1 else f"{len(model.parts)} parts"
        yield f"{mesh}  # {parts}, {vertices:,} vertices, {faces:,} triangles"
        if not self._apart():
            yield f"# More than {MOST_OBJECTS} parts: one mesh, at rest, with the first material."
        if animations:
            spans = [f"{_text(item.name)} ({item.duration:.4g} s)" for item in animations]
            yield f"# Animations of the model, of which each object plays one: {', '.join(spans)}"

    def _objects(self, animation: str | None, bends: bool) -> Iterator[str]:
        if not self._apart():
            return
        first = self.model.parts[0]
        own = g.material_values(self.inputs, first.material)
        textures = self._samplers(first)
        for part in self.model.parts:
            yield ""
            yield "[[objects]]"
            yield f"name = {_text(part.name)}"
            yield f"part = {_text(part.name)}"
            if animation is not None:
                yield f"animation = {_text(animation)}"
            if self._culls(part):
                yield 'cull = "back"  # the material has one side'
            if part.skin is not None and not bends:
                yield "# It has bones, which the shader does not: drawn as it was bound to them."
            yield from self._differences(part, own, textures)

    def _differences(
        self, part: ModelPart, own: dict[str, str], textures: dict[str, list[str]]
    ) -> Iterator[str]:
        """What another material has in other colours and textures than the first."""
        for name, value in g.material_values(self.inputs, part.material).items():
            if value != own.get(name):
                yield f"uniforms.{_key(name)} = {value}"
        for name, lines in self._samplers(part).items():
            if lines != textures[name]:
                inside = [line for line in lines[2:] if not line.startswith("#")]
                yield f"textures.{_key(name)} = {{ {', '.join(inside)} }}"

    def _culls(self, part: ModelPart) -> bool:
        # Other formats do not say which side is the front.
        if part.node is None or part.material.two_sided:
            return False
        mirrored = np.linalg.det(Pose(self.model.path, part.name).at(0.0).matrix[:3, :3]) <= 0.0
        return not mirrored

    def _samplers(self, part: ModelPart) -> dict[str, list[str]]:
        """A table for each sampler."""
        roles = g.sampler_roles(self.inputs.samplers)
        tables: dict[str, list[str]] = {}
        for item in self.inputs.samplers:
            kind = MADE_TEXTURES[item.type.name]
            head = ["", f"[textures.{_key(item.name)}]"]
            if kind != "pixels":
                why = f"# {item.spelt}: a model has none; this is a stand-in."
                lines = [why, f"file = {_text(self.textures.array(kind))}", 'filter = "linear"']
                tables[item.name] = [*head, *lines, 'wrap = "clamp"']
                continue
            role = roles[item.name]
            picture = part.material.textures.get(role or "")
            if picture is None:
                what = f"{role}, which the material lacks" if role else "it could not be told what"
                path, why = self.textures.stand_in(role), f"# (guess) {what}: a stand-in."
            else:
                path, why = self.textures.picture(picture), f"# (guess) {role} of the material."
            lines = [why, f"file = {_text(path)}", "mipmap = true"]
            tables[item.name] = [*head, *lines]
        return tables

    def _without_texture(self) -> list[str]:
        roles = g.sampler_roles(self.inputs.samplers)
        own = self.model.parts[0].material.textures
        return [item.name for item in self.inputs.samplers if roles.get(item.name) not in own]


def _camera(frame: Frame) -> Iterator[str]:
    yield ""
    yield "[camera]  # before all of the model, somewhat above it"
    yield f"eye = {numbers(frame.eye)}"
    yield f"target = {numbers(frame.centre)}  # the middle of its bounds"
    other = "z" if frame.up == "y" else "y"
    up = numbers(frame.upright(0.0, 1.0, 0.0))
    yield f"up = {up}  # (guess) where the model lies on its side: scene --up {other}"
    yield f"fov_degrees = {FOV}"
    yield f"near = {numbers([frame.near])}"
    yield f"far = {numbers([frame.far])}"


def _motion(frame: Frame) -> Iterator[str]:
    yield ""
    yield "[motion]  # a turntable: degrees_per_frame = 0.0 stops it"
    yield f"axis = {numbers(frame.upright(0.0, 1.0, 0.0))}"
    yield f"pivot = {numbers(frame.centre)}"
    yield "degrees_per_frame = 1.0"
    yield f"frames = {FRAMES}"


def _group(name: str, guesses: Sequence[Guess]) -> Iterator[str]:
    if not guesses:
        return
    yield ""
    yield f"[{name}]"
    for guess in guesses:
        yield f"{_key(guess.name)} = {guess.value}  # {guess.why}"


def _key(name: str) -> str:
    return name if name.isidentifier() and name.isascii() else _text(name)


def _text(text: str) -> str:
    """A string as TOML writes it."""
    plain = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in plain) + '"'

"""An object of a scene on the GPU: its mesh, its textures, its uniforms at a frame."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from typing import Any, Literal, TypeAlias

import moderngl
import numpy as np

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.gpu.programs import Program
from shadercache.gpu.textures import GlTexture
from shadercache.render.uploads import Streamed, Uploads
from shadercache.scene.camera import Values, semantic_values, shift_of, uniform_values
from shadercache.scene.description import Scene, SceneObject
from shadercache.scene.instances import Instances
from shadercache.scene.streams import Stream
from shadercache.source import Source

When: TypeAlias = Literal["now", "before"]

_KEPT_FRAMES = 512  # a few kilobytes each; more than any sweep's path


class Drawable:
    """One object as it is drawn. ``number`` counts objects from 1: what tells them apart."""

    def __init__(
        self,
        uploads: Uploads,
        scene: Scene,
        scene_object: SceneObject,
        number: int,
        size: tuple[int, int],
    ) -> None:
        """Args: ``size``: of the target, in pixels.

        Raises:
            InputError: SC511, the mesh lacks an array that the scene maps an attribute to, and as
                ``load_mesh``.
        """
        self.scene, self.scene_object, self.number = scene, scene_object, number
        self._uploads, self._size = uploads, size
        self._mesh = uploads.mesh(scene_object.mesh, scene_object.part)
        self.mesh = self._mesh.mesh
        self._values: OrderedDict[tuple[int, int], Values] = OrderedDict()
        self._outside: dict[int, bool] = {}
        self._drawn_textures: dict[str, GlTexture] = {}
        self._check_attributes()

    def seen_as(self, scene: Scene, size: tuple[int, int] | None = None) -> Drawable:
        """The same object as another scene sees it, in a target of a size (else of its own)."""
        return Drawable(self._uploads, scene, self.scene_object, self.number, size or self._size)

    def give(self, name: str, texture: GlTexture) -> None:
        """A texture that is drawn, not read from a file; it goes before the scene's."""
        self._drawn_textures[name] = texture

    def texture(self, name: str) -> GlTexture | None:
        """A texture by its name in the shader; None if the object has none so named."""
        if name in self._drawn_textures:
            return self._drawn_textures[name]
        spec = self.scene_object.inputs.textures.get(name)
        return None if spec is None else self._uploads.texture(spec)

    def storage(self, name: str) -> moderngl.Buffer | None:
        """A storage buffer by the name of its block; None if the object has none so named."""
        spec = self.scene_object.inputs.buffers.get(name)
        return None if spec is None else self._uploads.storage(spec)

    def values(self, frame: int, jittered: int | None = None) -> Values:
        """The object's uniforms at a frame. Equal frames give the same object.

        ``jittered``: the frame whose jitter they have, if it is another.
        """
        view = self.scene.view
        key = (frame, frame if jittered is None or not view.engine.jittered else jittered)
        # The same object again: who compares frames, for a cut or for rest, looks at that first.
        values = self._values.get(key)
        if values is None:
            size = view.engine.viewport(frame, self._size)[2:]
            values = self._values[key] = uniform_values(
                view, self.scene_object, frame, size, key[1]
            )
            if len(self._values) > _KEPT_FRAMES:
                self._values.popitem(last=False)
        return values

    def is_there(self, frame: int) -> bool:
        """Is the object in the scene at a frame?"""
        return self.scene_object.motion.is_there(self.scene.view.playback.at(frame))

    def is_outside(self, frame: int) -> bool:
        """Do its bounds lie beyond one side of the picture at a frame? Never without bounds."""
        if self.scene_object.bounds is None:
            return False
        if frame not in self._outside:
            view = self.scene.view
            size = view.engine.viewport(frame, self._size)[2:]
            # Jitter may bring in what lies less than half a pixel outside.
            shift = shift_of(view, frame, size)
            aspect = size[0] / size[1]
            values = semantic_values(view, self.scene_object.motion, frame, aspect, shift)
            bounds = np.asarray(self.scene_object.bounds, np.float64)
            self._outside[frame] = _is_outside(values["model-view-projection"], bounds)
        return self._outside[frame]

    @property
    def instances(self) -> Instances:
        """How many of it are drawn at once, and what each has of its own."""
        return self.scene_object.inputs.instances

    @property
    def streams(self) -> Mapping[str, Stream]:
        """What may change with each frame beside uniforms: attributes of instances, textures."""
        return {**self.instances.streams, **self.scene_object.inputs.played}

    def streamed(self, name: str, when: When) -> Streamed:
        """What holds a stream, of this frame (``now``) or of the last one."""
        return self._uploads.streamed((self.number, name, when), self.streams[name])

    def prepare(self, frame: int) -> None:
        """Compute and upload what a frame needs, so that timed draws find it done."""
        values = self.values(frame)
        for name in self.streams:
            self.streamed(name, "now").hold(values[name])
            self.streamed(name, "before").hold(self.values(max(0, frame - 1))[name])

    def vertex_array(
        self, program: Program, twins: Mapping[str, str], over_screen: bool = False
    ) -> moderngl.VertexArray:
        """The mesh as the program's input; nothing, for one that draws ``over_screen``. ``twins``
        leads from the names of attributes that hold the last frame's to the others.

        Raises:
            InputError: SC521, an attribute that the scene does not map to an array; SC523, fewer
                bones in the shader than in the model.
        """
        self._check_bones(program)
        content = [self._attribute(program, name, twins) for name in program.attributes]
        index = None if over_screen else self._mesh.index
        key = (index.glo if index else 0, *(buffer.glo for buffer, _, _ in content))
        if key not in program.arrays:
            context = self._uploads.gpu.ctx
            program.arrays[key] = context.vertex_array(program.gl, content, index)
        return program.arrays[key]

    def problem(self, code: str, message: str, hint: str | None = None) -> InputError:
        """Something that the scene file lacks."""
        place = Source(str(self.scene.path), "")
        return InputError(Diagnostic(code, message, place, hint=hint))

    def _attribute(
        self, program: Program, name: str, twins: Mapping[str, str]
    ) -> tuple[moderngl.Buffer, str, str]:
        original = twins.get(name, name)
        if original in self.instances.streams:
            width = self.instances.streams[original].shape[1]
            attribute: Any = program.gl[name]
            if width != attribute.dimension:
                has = f"{program.name} has {attribute.dimension} numbers in {name}"
                message = f"{has}, the instances {width}"
                raise self.problem("SC523", message)
            when: When = "before" if name in twins else "now"
            buffer = self.streamed(original, when).target
            assert isinstance(buffer, moderngl.Buffer)
            return buffer, f"{width}f/i", name
        array = self.scene_object.inputs.attributes.get(original)
        if array is None:
            message = f"{program.name} needs the vertex attribute {name}, which the scene lacks"
            hint = f'under [attributes], add: {name} = "position" (or another array of the mesh)'
            raise self.problem("SC521", message, hint)
        member: Any = program.gl[name]
        kind = member.shape
        width = self.mesh.arrays[array].shape[1]
        return self._mesh.buffer(array, kind), f"{width}{kind}", name

    def _check_bones(self, program: Program) -> None:
        pose, words = self.scene_object.motion.pose, self.scene_object.inputs.semantics
        if pose is None:
            return
        for name, uniform in program.uniforms.items():
            # Poses have more matrices than bones, so that shaders may; the rest would be dropped.
            if words.get(name) == "bones" and uniform.count < 16 * pose.bone_count:
                message = f"{name} has {uniform.count // 16} matrices, and '{pose.part}' has"
                raise self.problem("SC523", f"{message} {pose.bone_count} bones")

    def _check_attributes(self) -> None:
        have = self.mesh.arrays
        hint = f"it has: {', '.join(sorted(have))}"
        problems: list[Diagnostic] = []
        for attribute, array in self.scene_object.inputs.attributes.items():
            if array not in have:
                what = f"which the mesh {self.mesh.name} does not have"
                message = f"attributes.{attribute} wants the array {array!r}, {what}"
                problems += self.problem("SC511", message, hint).diagnostics
        if problems:
            raise InputError(problems)


def _is_outside(matrix: np.ndarray, bounds: np.ndarray) -> bool:
    """Do all corners of a box lie beyond one of the six planes of the clip volume?"""
    picks = np.indices((2, 2, 2)).reshape(3, 8).T
    corners = np.take_along_axis(bounds, picks, axis=0)
    clip = np.concatenate([corners, np.ones((8, 1))], axis=1) @ matrix.T
    xyz, w = clip[:, :3], clip[:, 3:]
    # Compared with w and not divided by it, so that corners behind the eye count rightly. A box
    # that is outside, but of no single plane, is kept: nothing is lost but time.
    return bool((xyz > w).all(axis=0).any() or (xyz < -w).all(axis=0).any())

"""An object of a scene on the GPU: its mesh, its textures, its uniforms at a frame."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable

import moderngl
import numpy as np

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.gpu.context import Gpu
from shadercache.gpu.programs import Program
from shadercache.gpu.textures import GlTexture
from shadercache.scene.camera import Values, scene_values, semantic_values
from shadercache.scene.description import SceneObject
from shadercache.scene.mesh import Mesh
from shadercache.source import Source

_KEPT_FRAMES = 512  # a few kilobytes each; more than any sweep's path


class GpuMesh:
    """The arrays of a mesh on the GPU, each uploaded when first wanted."""

    def __init__(self, ctx: moderngl.Context, mesh: Mesh) -> None:
        self.mesh = mesh
        self._ctx = ctx
        self._buffers: dict[str, moderngl.Buffer] = {}
        self.index = ctx.buffer(mesh.index.tobytes())

    def buffer(self, name: str) -> moderngl.Buffer:
        """One of the mesh's arrays."""
        if name not in self._buffers:
            array = np.ascontiguousarray(self.mesh.arrays[name])
            self._buffers[name] = self._ctx.buffer(array.tobytes())
        return self._buffers[name]

    def release(self) -> None:
        """Free the buffers."""
        for buffer in (*self._buffers.values(), self.index):
            buffer.release()


class Drawable:
    """One object as it is drawn. ``number`` counts objects from 1: what tells them apart."""

    def __init__(
        self,
        gpu: Gpu,
        item: SceneObject,
        number: int,
        mesh: GpuMesh,
        size: tuple[int, int],
        texture: Callable[[str], GlTexture | None],
    ) -> None:
        """Args: ``texture`` gives a texture by its name in the shader, uploaded when first wanted.

        Raises:
            InputError: SC511, the mesh lacks an array that the scene maps an attribute to.
        """
        self.item, self.scene, self.number = item, item.scene, number
        self.mesh = mesh.mesh
        self.texture = texture
        self._gpu, self._mesh, self._size = gpu, mesh, size
        self._values: OrderedDict[tuple[int, int], Values] = OrderedDict()
        self._there: dict[int, bool] = {}
        self._check_attributes()

    def seen_as(self, item: SceneObject) -> Drawable:
        """The same mesh and textures for another scene's object."""
        return Drawable(self._gpu, item, self.number, self._mesh, self._size, self.texture)

    def values(self, frame: int, jittered: int | None = None) -> Values:
        """The object's uniforms at a frame. Equal frames give the same object.

        ``jittered``: the frame whose jitter they have, if it is another.
        """
        key = (frame, frame if jittered is None or not self.scene.engine.jitter else jittered)
        found = self._values.get(key)
        if found is None:
            width, height = self.scene.engine.viewport(frame, self._size)[2:]
            found = self._values[key] = scene_values(self.scene, frame, (width, height), key[1])
            if len(self._values) > _KEPT_FRAMES:
                self._values.popitem(last=False)
        return found

    def is_there(self, frame: int) -> bool:
        """Is the object in the scene at a frame?"""
        return self.scene.motion.is_there(frame)

    def is_outside(self, frame: int) -> bool:
        """Do its bounds lie beyond one side of the picture at a frame? Never without bounds."""
        if self.item.bounds is None:
            return False
        found = self._there.get(frame)
        if found is None:
            width, height = self.scene.engine.viewport(frame, self._size)[2:]
            values = semantic_values(self.scene, frame, width / height)
            found = self._there[frame] = _is_outside(
                values["model-view-projection"], np.asarray(self.item.bounds, np.float64)
            )
        return found

    def vertex_array(self, program: Program, over_screen: bool = False) -> moderngl.VertexArray:
        """The mesh as the program's input; nothing, for one that draws ``over_screen``.

        Raises:
            InputError: SC521, an attribute that the scene does not map to an array.
        """
        content = [self._attribute(program, name) for name in program.attributes]
        index = None if over_screen else self._mesh.index
        key = (index.glo if index else 0, *(buffer.glo for buffer, _, _ in content))
        found = program.arrays.get(key)
        if found is None:
            found = self._gpu.ctx.vertex_array(program.gl, content, index)
            program.arrays[key] = found
        return found

    def _attribute(self, program: Program, name: str) -> tuple[moderngl.Buffer, str, str]:
        array = self.scene.attributes.get(name)
        if array is None:
            message = f"{program.name} needs the vertex attribute {name}, which the scene lacks"
            hint = f'under [attributes], add: {name} = "position" (or another array of the mesh)'
            raise InputError(Diagnostic("SC521", message, self._place(), hint=hint))
        return self._mesh.buffer(array), f"{self.mesh.arrays[array].shape[1]}f", name

    def _check_attributes(self) -> None:
        problems = [
            self._missing_array(attribute, array)
            for attribute, array in self.scene.attributes.items()
            if array not in self.mesh.arrays
        ]
        if problems:
            raise InputError(problems)

    def _missing_array(self, attribute: str, array: str) -> Diagnostic:
        have = ", ".join(sorted(self.mesh.arrays))
        message = (
            f"attributes.{attribute} wants the array {array!r}, "
            f"which the mesh {self.mesh.name} does not have"
        )
        return Diagnostic("SC511", message, self._place(), hint=f"it has: {have}")

    def _place(self) -> Source:
        return Source(str(self.scene.path), "")


def _is_outside(matrix: np.ndarray, bounds: np.ndarray) -> bool:
    """Do all corners of a box lie beyond one of the six planes of the clip volume?"""
    picks = np.indices((2, 2, 2)).reshape(3, 8).T
    corners = np.take_along_axis(bounds, picks, axis=0)
    clip = np.concatenate([corners, np.ones((8, 1))], axis=1) @ matrix.T
    xyz, w = clip[:, :3], clip[:, 3:]
    return bool((xyz > w).all(axis=0).any() or (xyz < -w).all(axis=0).any())

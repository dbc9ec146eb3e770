"""A scene on the GPU at one size: everything that runners of many variants share."""

from __future__ import annotations

from collections import OrderedDict

import moderngl
import numpy as np

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.harness.camera import Values, scene_values
from shadercache.harness.context import Gpu
from shadercache.harness.mesh import Mesh, scene_mesh
from shadercache.harness.owner import Owner
from shadercache.harness.programs import Program, Programs
from shadercache.harness.scene import Scene
from shadercache.harness.targets import Targets
from shadercache.harness.textures import GlTexture, upload_texture
from shadercache.source import Source

_KEPT_FRAMES = 512  # a few kilobytes each; more than any sweep's path


class Stage(Owner):
    """Mesh, textures, programs and render targets of one scene at one size."""

    def __init__(
        self,
        gpu: Gpu,
        scene: Scene,
        size: tuple[int, int],
        color: str = "rgba8",
        mesh: Mesh | None = None,
    ) -> None:
        """Upload the mesh (``mesh`` in place of the scene's own) and make the targets.

        Args:
            size: width and height in pixels.
            color: ``rgba8`` for pictures and timing, ``rgba32f`` for proofs.

        Raises:
            InputError: SC51x for an unusable mesh, SC603 for a format that does not exist.
        """
        self.gpu = gpu
        self.scene = scene
        self.mesh = scene_mesh(scene) if mesh is None else mesh
        self._check_attributes()
        self.programs = Programs(gpu)
        self.targets = Targets(gpu.ctx, size, color)
        self._buffers: dict[str, moderngl.Buffer] = {}
        self._index = gpu.ctx.buffer(self.mesh.index.tobytes())
        self._textures: dict[str, GlTexture] = {}
        self._values: OrderedDict[int, Values] = OrderedDict()
        # moderngl cannot free a query, so there is one for all runners.
        self.sample_counter = gpu.ctx.query(samples=True)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.targets.size

    def values(self, frame: int) -> Values:
        """The scene's uniforms at a frame. Equal frames give the same object."""
        found = self._values.get(frame)
        if found is None:
            found = self._values[frame] = scene_values(self.scene, frame, self.size)
            if len(self._values) > _KEPT_FRAMES:
                self._values.popitem(last=False)
        return found

    def texture(self, name: str) -> GlTexture | None:
        """A texture of the scene, uploaded when first wanted; None if the scene has none so named.

        Raises:
            InputError: SC530, SC531 for a file that is no texture.
        """
        if name not in self._textures and name in self.scene.textures:
            self._textures[name] = upload_texture(self.gpu, self.scene.textures[name])
        return self._textures.get(name)

    def vertex_array(self, program: Program) -> moderngl.VertexArray:
        """The mesh as the program's input.

        Raises:
            InputError: SC521, an attribute that the scene does not map to an array.
        """
        if program.array is None:
            content = [self._attribute(program, name) for name in program.attributes]
            program.array = self.gpu.ctx.vertex_array(program.gl, content, self._index)
        return program.array

    def begin(self) -> None:
        """Set the state a frame starts from, and clear colour and depth."""
        flags = moderngl.DEPTH_TEST | (moderngl.CULL_FACE if self.scene.cull else 0)
        self.gpu.ctx.enable_only(flags)
        self.targets.clear()

    def release(self) -> None:
        """Free every GL object of the stage; its runners can draw no more."""
        self.programs.release_all()
        for buffer in (*self._buffers.values(), self._index):
            buffer.release()
        for texture in self._textures.values():
            texture.release()
        self.targets.release()

    def _attribute(self, program: Program, name: str) -> tuple[moderngl.Buffer, str, str]:
        array_name = self.scene.attributes.get(name)
        if array_name is None:
            message = f"{program.name} needs the vertex attribute {name}, which the scene lacks"
            hint = f'under [attributes], add: {name} = "position" (or another array of the mesh)'
            raise InputError(Diagnostic("SC521", message, self._place(), hint=hint))
        array = self.mesh.arrays[array_name]
        if array_name not in self._buffers:
            self._buffers[array_name] = self.gpu.ctx.buffer(np.ascontiguousarray(array).tobytes())
        return self._buffers[array_name], f"{array.shape[1]}f", name

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

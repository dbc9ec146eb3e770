"""Meshes and textures on the GPU, each uploaded when it is first wanted."""

from __future__ import annotations

from math import prod
from pathlib import Path
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from shadercache.gpu.context import Gpu
from shadercache.gpu.resource import Resource
from shadercache.gpu.textures import GlTexture, upload_texture
from shadercache.scene.mesh import FULL_SCREEN, Mesh, load_mesh
from shadercache.scene.object_inputs import BufferSpec, TextureSpec
from shadercache.scene.streams import Stream


class GpuMesh(Resource):
    """The arrays of a mesh on the GPU."""

    def __init__(self, ctx: moderngl.Context, mesh: Mesh) -> None:
        self.mesh = mesh
        self._ctx = ctx
        self._buffers: dict[tuple[str, str], moderngl.Buffer] = {}
        self.index = ctx.buffer(mesh.index.tobytes())

    def buffer(self, name: str, kind: str = "f") -> moderngl.Buffer:
        """One of the mesh's arrays, as floats, or as whole numbers for a ``kind`` of ``i``."""
        key = (name, kind)
        if key not in self._buffers:
            dtype = np.int32 if kind == "i" else np.float32
            array = np.ascontiguousarray(self.mesh.arrays[name], dtype)
            self._buffers[key] = self._ctx.buffer(array.tobytes())
        return self._buffers[key]

    def release(self) -> None:
        """Free the buffers."""
        for buffer in (*self._buffers.values(), self.index):
            buffer.release()


class Streamed(Resource):
    """A buffer or a texture whose numbers change from frame to frame."""

    def __init__(self, target: moderngl.Buffer | moderngl.Texture) -> None:
        self.target = target
        self._held: NDArray[np.floating[Any]] | None = None

    def hold(self, numbers: NDArray[np.floating[Any]]) -> None:
        """Upload numbers, unless they are there already."""
        # Equal frames give the same object.
        if numbers is not self._held:
            self._held = numbers
            self.target.write(numbers.astype(np.float32).tobytes())

    def release(self) -> None:
        """Free it."""
        self.target.release()


class Uploads(Resource):
    """What objects that draw the same files share."""

    def __init__(self, gpu: Gpu, given: Mesh | None) -> None:
        """Args: ``given``: a mesh in place of those in files."""
        self.gpu = gpu
        self._given = given
        self._meshes: dict[tuple[Path | None, str | None], GpuMesh] = {}
        self._textures: dict[TextureSpec, GlTexture] = {}
        self._storage: dict[BufferSpec, moderngl.Buffer] = {}
        self._streams: dict[tuple[int, str, str], Streamed] = {}

    def streamed(self, key: tuple[int, str, str], stream: Stream) -> Streamed:
        """What holds a stream of an object (by number and name), for this frame or the last."""
        if key not in self._streams:
            ctx, shape = self.gpu.ctx, stream.shape
            target: moderngl.Buffer | moderngl.Texture
            if stream.dims < 3:
                target = ctx.buffer(reserve=4 * prod(shape))
            else:
                height, width, channels = shape
                target = ctx.texture((width, height), channels, dtype="f4")
                target.filter = (moderngl.NEAREST, moderngl.NEAREST)
                target.repeat_x = target.repeat_y = False
            self._streams[key] = Streamed(target)
        return self._streams[key]

    def storage(self, spec: BufferSpec) -> moderngl.Buffer:
        """A storage buffer. Raises InputError SC541 for a file without its array."""
        if spec not in self._storage:
            self._storage[spec] = self.gpu.ctx.buffer(spec.content())
        return self._storage[spec]

    def mesh(self, path: Path | None, part: str | None = None) -> GpuMesh:
        """A mesh, or a part of a model; None is that of full-screen scenes. Raises as
        ``load_mesh``."""
        key = (path, part)
        if key not in self._meshes:
            mesh = self._given or (FULL_SCREEN if path is None else load_mesh(path, part))
            self._meshes[key] = GpuMesh(self.gpu.ctx, mesh)
        return self._meshes[key]

    def texture(self, spec: TextureSpec) -> GlTexture:
        """A texture. Raises InputError SC530, SC531 for a file that is none."""
        if spec not in self._textures:
            self._textures[spec] = upload_texture(self.gpu, spec)
        return self._textures[spec]

    def release(self) -> None:
        """Free everything."""
        everything = (self._meshes, self._textures, self._streams, self._storage)
        for held in (one for table in everything for one in table.values()):
            held.release()

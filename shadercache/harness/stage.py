"""A scene on the GPU at one size: everything that runners of many variants share."""

from __future__ import annotations

from collections.abc import Collection
from copy import copy
from dataclasses import replace
from pathlib import Path

import moderngl

from shadercache.diagnostics import input_error
from shadercache.harness.camera import Values
from shadercache.harness.cast import Cast
from shadercache.harness.context import Gpu
from shadercache.harness.mesh import Mesh, scene_mesh
from shadercache.harness.motion import REST
from shadercache.harness.owner import Owner
from shadercache.harness.programs import Programs
from shadercache.harness.prop import GpuMesh, Prop
from shadercache.harness.scene import Camera, CameraPath, Scene, SceneObject, TextureSpec
from shadercache.harness.targets import Targets
from shadercache.harness.textures import GlTexture, upload_texture


class Stage(Owner):
    """Objects, textures, programs and render targets of one scene at one size.

    ``props`` are the objects; of a scene of one, ``mesh``, ``values`` and ``texture`` are its own.
    With ``culling`` objects outside of the picture are not drawn.
    """

    def __init__(
        self,
        gpu: Gpu,
        scene: Scene,
        size: tuple[int, int],
        color: str = "rgba8",
        mesh: Mesh | None = None,
        small: bool = False,
    ) -> None:
        """Upload the meshes (``mesh`` in place of the scene's own) and make the targets.

        Args:
            size: width and height in pixels.
            color: ``rgba8`` for pictures and timing, ``rgba32f`` for proofs.
            small: take the meshes' low resolution stand-ins where there are any.

        Raises:
            InputError: SC51x for an unusable mesh, SC540 for a mesh in place of those of several
                objects, SC603 for a format that does not exist.
        """
        if mesh is not None and scene.objects:
            message = f"the scene {scene.name} has several objects; one mesh cannot replace theirs"
            raise input_error("SC540", message)
        self.gpu = gpu
        self.scene = scene
        self.culling = True
        self._owns = True
        self.cast = Cast()
        self.programs = Programs(gpu)
        self._meshes: dict[Path | None, GpuMesh] = {}
        self._textures: dict[TextureSpec, GlTexture] = {}
        self.props = tuple(
            self._prop(self.cast.named(item), number + 1, self._mesh(item.scene, mesh, small), size)
            for number, item in enumerate(scene.parts)
        )
        self.targets = Targets(gpu.ctx, size, color, scene.engine.empty_depth)
        self._mixed = len({item.scene.cull for item in scene.parts}) > 1
        # moderngl cannot free a query, so there is one for all runners.
        self.sample_counter = gpu.ctx.query(samples=True)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.targets.size

    @property
    def mesh(self) -> Mesh:
        """The mesh of the first object."""
        return self.props[0].mesh

    def values(self, frame: int) -> Values:
        """The uniforms of the first object at a frame. Equal frames give the same values."""
        return self.props[0].values(frame)

    def texture(self, name: str) -> GlTexture | None:
        """A texture of the first object; None if it has none so named. Raises as :meth:`load`."""
        return self.props[0].texture(name)

    def viewport(self, frame: int) -> tuple[int, int, int, int]:
        """Left, bottom, width and height of what a frame is drawn into, in pixels."""
        return self.scene.engine.viewport(frame, self.size)

    def drawn(self, frame: int) -> tuple[Prop, ...]:
        """The objects that are drawn in a frame: there, and not outside of the picture."""
        return tuple(
            prop
            for prop in self.props
            if prop.is_there(frame) and not (self.culling and prop.is_outside(frame))
        )

    def prepare(self, frame: int) -> None:
        """Compute all that a frame needs of the CPU, so that timed draws find it done."""
        for prop in self.drawn(frame):
            prop.values(frame)

    def seen_from(self, camera: Camera, path: CameraPath = REST) -> Stage:
        """The same objects before another camera, for a view beside this one.

        It shares all that is on the GPU with this stage, which must outlive it. Runners of several
        views take turns; each has a cache of its own.
        """
        other = copy(self)
        other._owns = False
        other.scene = self.scene.seen_from(camera, path)
        other.props = tuple(
            prop.seen_as(replace(prop.item, scene=prop.scene.seen_from(camera, path)))
            for prop in self.props
        )
        return other

    def without_caching(self, names: Collection[str]) -> Stage:
        """The same objects, some of them drawn by their originals.

        It shares all that is on the GPU with this stage, which must outlive it.
        """
        other = copy(self)
        other._owns = False
        other.props = tuple(
            prop.seen_as(replace(prop.item, cached=False)) if prop.item.name in names else prop
            for prop in self.props
        )
        return other

    def load(self, spec: TextureSpec) -> GlTexture:
        """A texture, uploaded when first wanted.

        Raises:
            InputError: SC530, SC531 for a file that is no texture.
        """
        if spec not in self._textures:
            self._textures[spec] = upload_texture(self.gpu, spec)
        return self._textures[spec]

    def begin(self) -> None:
        """Set the state a frame starts from, and clear colour and depth."""
        flags = moderngl.DEPTH_TEST | (moderngl.CULL_FACE if self.props[0].scene.cull else 0)
        self.gpu.ctx.enable_only(flags)
        self.scene.engine.apply(self.gpu.ctx)
        self.targets.clear()

    def set_culling(self, prop: Prop) -> None:
        """Draw back faces of this object or not, where objects differ in that."""
        if self._mixed:
            change = self.gpu.ctx.enable if prop.scene.cull else self.gpu.ctx.disable
            change(moderngl.CULL_FACE)

    def release(self) -> None:
        """Free every GL object of the stage; its runners can draw no more. Of a view: nothing."""
        if not self._owns:
            return
        self.programs.release_all()
        for mesh in self._meshes.values():
            mesh.release()
        for texture in self._textures.values():
            texture.release()
        self.targets.release()

    def _mesh(self, scene: Scene, given: Mesh | None, small: bool) -> GpuMesh:
        """What an object draws; objects that draw the same file share it."""
        path = scene.verify_mesh if small and scene.verify_mesh else scene.mesh
        if path not in self._meshes:
            self._meshes[path] = GpuMesh(self.gpu.ctx, given or scene_mesh(scene, small))
        return self._meshes[path]

    def _prop(self, item: SceneObject, number: int, mesh: GpuMesh, size: tuple[int, int]) -> Prop:
        def texture(name: str) -> GlTexture | None:
            spec = item.scene.textures.get(name)
            return None if spec is None else self.load(spec)

        return Prop(self.gpu, item, number, mesh, size, texture)

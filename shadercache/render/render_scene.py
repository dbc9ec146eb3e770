"""A scene on the GPU at one size: everything that runners of many variants share."""

from __future__ import annotations

from copy import copy
from dataclasses import replace
from itertools import accumulate

import moderngl

from shadercache.diagnostics import input_error
from shadercache.gpu.context import Gpu, apply_state
from shadercache.gpu.fractions import Viewport, divided, divided_size
from shadercache.gpu.programs import Programs
from shadercache.gpu.resource import Resource
from shadercache.gpu.targets import Targets
from shadercache.render.drawable import Drawable
from shadercache.render.uploads import Uploads
from shadercache.scene.description import Scene
from shadercache.scene.graphics_state import GraphicsState
from shadercache.scene.mesh import Mesh
from shadercache.scene.motion import REST, Camera, CameraPath


class RenderScene(Resource):
    """Objects, textures, programs and render targets of one scene at one size.

    ``drawables`` are the objects. With ``culling`` those outside of the picture are not drawn.
    """

    def __init__(
        self,
        gpu: Gpu,
        scene: Scene,
        size: tuple[int, int],
        color: str = "rgba8",
        mesh: Mesh | None = None,
    ) -> None:
        """Upload the meshes (``mesh`` in place of the scene's own) and make the targets.

        Args:
            size: width and height in pixels.
            color: ``rgba8`` for pictures and timing, ``rgba32f`` for proofs.

        Raises:
            InputError: SC51x for an unusable mesh, SC540 for a mesh in place of those of several
                objects, SC603 for a format that does not exist.
        """
        if mesh is not None and scene.objects:
            message = f"the scene {scene.name} has several objects; one mesh cannot replace theirs"
            raise input_error("SC540", message)
        self.gpu, self.scene, self.size = gpu, scene, size
        self._whole, self._divisor = size, 1
        self.culling = True
        self.programs = Programs(gpu)
        self._uploads: Uploads | None = Uploads(gpu, mesh)
        self._owns_targets = True
        # Each instance has a number of its own.
        counts = (scene_object.inputs.instances.number for scene_object in scene.parts)
        self.drawables = tuple(
            Drawable(self._uploads, scene, scene_object, number, size)
            for number, scene_object in zip(
                accumulate(counts, initial=1), scene.parts, strict=False
            )
        )
        self.targets = Targets(gpu.ctx, size, color, scene.view.engine.empty_depth)
        self._mixed = len({scene_object.cull for scene_object in scene.parts}) > 1
        # moderngl cannot free a query, so there is one for all runners.
        self.sample_counter = gpu.ctx.query(samples=True)

    def viewport(self, frame: int) -> Viewport:
        """Left, bottom, width and height of what a frame is drawn into, in pixels."""
        return divided(self.scene.view.engine.viewport(frame, self._whole), self._divisor)

    def drawn(self, frame: int) -> tuple[Drawable, ...]:
        """The objects that are drawn in a frame: there, and not outside of the picture."""
        return tuple(
            drawable
            for drawable in self.drawables
            if drawable.is_there(frame) and not (self.culling and drawable.is_outside(frame))
        )

    def prepare(self, frame: int) -> None:
        """Compute all that a frame needs of the CPU, so that timed draws find it done."""
        for drawable in self.drawn(frame):
            drawable.prepare(frame)

    def seen_from(self, camera: Camera, path: CameraPath = REST) -> RenderScene:
        """The same objects before another camera, for a view beside this one.

        It shares all that is on the GPU with this world, which must outlive it. Runners of several
        views take turns; each has a cache of its own.
        """
        return self.showing(self.scene.seen_from(camera, path))

    def showing(self, scene: Scene) -> RenderScene:
        """The same objects in the same targets as another scene of them says; it shares all that is
        on the GPU with this world, which must outlive it."""
        other = copy(self)
        other._uploads, other._owns_targets = None, False
        other.scene = scene
        other.drawables = tuple(drawable.seen_as(other.scene) for drawable in self.drawables)
        return other

    def smaller(self, divisor: int) -> RenderScene:
        """The same objects with the same inputs, drawn into targets of their own that are so many
        times smaller in each direction.

        It shares everything else with this world, which must outlive it.
        """
        other = copy(self)
        other._uploads, other._owns_targets = None, True
        other._divisor, other.size = divisor, divided_size(self.size, divisor)
        empty, color = self.scene.view.engine.empty_depth, self.targets.color_format
        other.targets = Targets(self.gpu.ctx, other.size, color, empty)
        return other

    def drawn_apart(self, size: tuple[int, int], engine: GraphicsState) -> RenderScene:
        """The same objects before the same camera, drawn into targets of their own, which shaders
        can read.

        It shares meshes, textures and programs with this world, which must outlive it.

        Args:
            size: width and height of the targets in pixels.
            engine: the application's state; the jitter may differ.

        Raises:
            GraphicsError: SC603 for a size that the driver cannot give.
        """
        other = copy(self)
        other._uploads, other.size, other._whole, other._divisor = None, size, size, 1
        other.scene = replace(self.scene, view=replace(self.scene.view, engine=engine))
        other.drawables = tuple(drawable.seen_as(other.scene, size) for drawable in self.drawables)
        empty, color = engine.empty_depth, self.targets.color_format
        other._owns_targets = True
        other.targets = Targets(self.gpu.ctx, size, color, empty, sampled=True)
        return other

    def begin(self) -> None:
        """Set the state a frame starts from, and clear colour and depth."""
        # One state for all. Where objects differ, `set_culling` sets it with each draw.
        flags = moderngl.DEPTH_TEST | (
            moderngl.CULL_FACE if self.drawables[0].scene_object.cull else 0
        )
        self.gpu.ctx.enable_only(flags)
        apply_state(self.gpu.ctx, self.scene.view.engine)
        self.targets.clear_outputs()

    def set_culling(self, drawable: Drawable) -> None:
        """Draw back faces of this object or not, where objects differ in that."""
        if self._mixed:
            change = self.gpu.ctx.enable if drawable.scene_object.cull else self.gpu.ctx.disable
            change(moderngl.CULL_FACE)

    def release(self) -> None:
        """Free every GL object; what runs here can draw no more. Of a view: what it has alone."""
        if self._uploads is not None:
            self.programs.release_all()
            self._uploads.release()
        if self._owns_targets:
            self.targets.release()

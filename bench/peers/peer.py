"""What all peers share: views of the world that draw apart, and a pass over the objects."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from itertools import takewhile
from pathlib import Path

import moderngl
import numpy as np

from bench.peers.scene_programs import ScenePrograms
from shadercache.gpu.cache_textures import CachePair
from shadercache.gpu.resource import Resource
from shadercache.render.bound_pass import BoundPass, FrameInputs
from shadercache.render.bundle import Naming
from shadercache.render.drawable import Drawable
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene
from shadercache.scene.graphics_state import GraphicsState
from shadercache.source import Source

GLSL = Path(__file__).parent / "glsl"

EMPTY = (0.0, 0.0, 0.0, 0.0)


def read_shader(name: str, *parts: str) -> Source:
    """A shader of the peers; ``parts`` are put behind ``#version`` and ``#extension``."""
    lines = (GLSL / name).read_text(encoding="utf-8").splitlines()
    # #version must come first, #extension before all that is no directive (GLSL 4.60 section 3.3).
    head = list(takewhile(lambda line: line.startswith("#"), lines))
    texts = [(GLSL / part).read_text(encoding="utf-8") for part in parts]
    return Source(name, "\n".join([*head, *texts, *lines[len(head) :], ""]))


class Peer(ABC):
    """A way to draw the scene that is no variant: a ``Subject`` of a measurement.

    ``frames``: how many will be drawn. What they need of the CPU is computed ahead, as for the
    original.
    """

    def __init__(self, label: str, programs: ScenePrograms, frames: int) -> None:
        self.label, self.programs, self.frames = label, programs, frames
        self._held = ExitStack()
        self._views: list[RenderScene] = []

    def prepare(self, world: RenderScene) -> None:
        """Compile everything, and draw two frames: what is not drawn is not compiled.

        Raises as ``BoundPass``.
        """
        self.world = world
        self.make()
        for view in self._views:
            for frame in range(self.frames):
                view.prepare(frame)
        for frame in (0, 1):
            self.draw(frame)

    @abstractmethod
    def make(self) -> None:
        """Take what is needed of the GPU; hand it to ``hold``."""

    @abstractmethod
    def draw(self, frame: int) -> None:
        """Draw a frame into the world's colour target; frames come in order, from 0."""

    def release(self) -> None:
        """Give everything back."""
        self._held.close()

    def begins(self, frame: int) -> bool:
        """Is there nothing that the frames before could tell of this one?"""
        return frame == 0 or self.world.scene.view.is_cut(frame)

    def hold(self, view: RenderScene) -> RenderScene:
        """A view that is given back with the peer."""
        self._views.append(view)
        self._held.callback(view.release)
        return view

    def shaded_apart(
        self, size: tuple[int, int], engine: GraphicsState | None = None
    ) -> OriginalRunner:
        """Draws the originals into targets of another size; the state is the world's or another."""
        state = engine or self.world.scene.view.engine
        view = self.hold(self.world.drawn_apart(size, state))
        return self._held.enter_context(OriginalRunner(view, *self.programs.originals))

    def over_objects(self, shader: PeerShader) -> ObjectPass:
        """Draws the objects by a shader of the peer's own. Raises as ``BoundPass``."""
        return self._held.enter_context(ObjectPass(self._full_view(), self.programs, shader))

    def over_screen(self, shader: PeerShader) -> ScreenPass:
        """Draws one triangle over the picture. Raises as ``BoundPass``."""
        return self._held.enter_context(ScreenPass(self._full_view(), shader))

    def lent_history(self) -> CachePair:
        """Textures for what a frame leaves to the next: 16/w, and the colour behind it."""
        targets = self.world.targets
        pair = targets.lend_cache(("rgba16f",))
        self._held.callback(targets.take_back, pair)
        pair.set_filter("linear")
        # A nearness of 0 is infinitely far: no surface is found there.
        pair.clear((EMPTY,))
        return pair

    def _full_view(self) -> RenderScene:
        # A view of its own: the textures that it gives the objects are nobody else's.
        view = self.world.scene.view
        return self.hold(self.world.seen_from(view.camera, view.camera_path))


@dataclass(frozen=True, eq=False)
class PeerShader:
    """A fragment shader of a peer: the uniforms it is given with each draw, the textures it reads.

    ``history``: it reads ``u_history``, and writes the next one as its second output.
    """

    fragment: Source
    numbers: tuple[str, ...] = ()
    textures: Mapping[str, moderngl.Texture] = field(default_factory=dict)
    history: CachePair | None = None

    @property
    def targets(self) -> tuple[str, ...]:
        """What it draws into."""
        return ("color",) if self.history is None else ("color", "cache")

    def naming(self, twins: Mapping[str, str]) -> Naming:
        """Where its inputs come from; ``twins`` are the vertex program's."""
        roles = {name: name for name in self.numbers}
        if self.history is not None:
            roles["u_history"] = "previous-cache"
        return Naming(roles, twins)


Numbers = Mapping[str, Sequence[float]]
"""Values of uniforms, by name."""


OF_DEPTH = ("depth_nearness.glsl", "own_surface.glsl", "search.glsl")
"""Parts of shaders that look a surface up in a picture with depth."""

OF_HISTORY = ("reproject.glsl", "last_picture.glsl", "own_surface.glsl", "what_was_shown.glsl")
"""Parts of shaders that look up what their fragment's point showed in the last picture."""

SEARCH = 4
"""Places where a surface is searched that is not found at its own: at most six texels away."""


def own_surface(world: RenderScene) -> dict[str, Sequence[float]]:
    """The uniforms of ``depth_nearness.glsl`` and ``search.glsl``."""
    camera = world.scene.view.camera
    # The depth of a perspective is far / (far - near) - far near / (far - near) / w, from 0 to 1.
    far = camera.far / (camera.far - camera.near)
    return {"u_planes": (far, far * camera.near), "u_steps": (SEARCH,)}


def _encoded(numbers: Numbers) -> dict[str, np.ndarray]:
    return {name: np.array(values, np.float64) for name, values in numbers.items()}


class ObjectPass(Resource):
    """Draws every object over the vertex program that knows where its vertices were."""

    def __init__(self, view: RenderScene, programs: ScenePrograms, shader: PeerShader) -> None:
        self._view, self._history = view, shader.history
        self._passes: dict[Drawable, BoundPass] = {}
        for drawable, bundle in zip(view.drawables, programs.moving, strict=True):
            for name, texture in shader.textures.items():
                drawable.give(name, texture)
            vertex, inputs = bundle.debug.vertex, bundle.debug.inputs
            spec = PassSpec("peer", vertex, shader.fragment, shader.targets, inputs=inputs)
            naming = shader.naming(bundle.naming.twins)
            self._passes[drawable] = BoundPass(view, drawable, spec, naming)

    def draw(self, frame: int, numbers: Numbers) -> None:
        """Clear the targets and draw; the history is swapped."""
        view, given = self._view, _encoded(numbers)
        view.begin()
        if self._history is not None:
            self._history.clear_current((EMPTY,))
        before = max(0, frame - 1)
        for drawable in view.drawn(frame):
            now, last = drawable.values(frame), drawable.values(before)
            inputs = FrameInputs(now, last, given, view.viewport(frame))
            self._passes[drawable].draw(inputs, self._history)
        if self._history is not None:
            self._history.swap()

    def release(self) -> None:
        """Give the programs back."""
        for bound in self._passes.values():
            bound.release()


class ScreenPass(Resource):
    """Draws one triangle over the whole picture."""

    def __init__(self, view: RenderScene, shader: PeerShader) -> None:
        self._view, drawable = view, view.drawables[0]
        for name, texture in shader.textures.items():
            drawable.give(name, texture)
        vertex = read_shader("screen.vert")
        spec = PassSpec("peer", vertex, shader.fragment, shader.targets, draws="screen")
        self._bound = BoundPass(view, drawable, spec, shader.naming({}))

    def draw(self, frame: int, numbers: Numbers) -> None:
        """Draw; every pixel is written, so nothing is cleared."""
        # The scene's depth test and culling are not for this triangle.
        self._view.gpu.ctx.enable_only(moderngl.NOTHING)
        inputs = FrameInputs({}, {}, _encoded(numbers), self._view.viewport(frame))
        self._bound.draw(inputs, None)

    def release(self) -> None:
        """Give the program back."""
        self._bound.release()

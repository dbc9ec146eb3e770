"""A scene drawn by its originals: what every variant of it is compared with."""

from __future__ import annotations

from copy import copy
from dataclasses import replace
from functools import cached_property

import numpy as np

from shadercache.caching.configuration import Mode
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.gpu.resource import Resource
from shadercache.linking.linker import Linker
from shadercache.linking.user_places import at_home
from shadercache.render.bundle import RATES, Bundle, LinkedObject
from shadercache.render.drawable import Drawable
from shadercache.render.pass_runners import CoverageRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.render.surfaces import Surfaces
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.description import Scene
from shadercache.scene.mesh import Mesh
from shadercache.verify.verdict import PERIOD, Image

MOVING = range(4)
"""The frames that are drawn."""


class References(Resource):
    """The originals' images by mode, and the pixels that count, frame by frame.

    Everything is drawn small (the laws are about bits, not about looks) in RGBA32F, with a low
    resolution stand-in for the mesh where the scene has one. ``covered`` leaves out pixels where
    two fragments tie for the front; ``ties`` is their share (law 4). ``proven``: vertex shaders
    whose previous positions have been found right.
    """

    def __init__(
        self,
        gpu: Gpu,
        opened: tuple[Scene, Analysis],
        size: tuple[int, int],
        mesh: Mesh | None = None,
    ) -> None:
        """Render the originals. Raises as ``RenderScene`` and ``BoundPass``."""
        scene, self.analysis = opened
        self.linker = Linker(scene, self.analysis)
        # The linker's scene has the inputs under the names that raised shaders have for them.
        self.world = RenderScene(gpu, self.linker.scene.small, size, "rgba32f", mesh)
        self.images: dict[Mode, list[Image]] = {}
        modes: tuple[Mode, ...] = ("plain", "proof")
        with at_home(self.analysis):
            for mode in modes:
                originals = self.linker.originals(mode)
                self.images[mode] = render_original(self.world, originals, MOVING)
        self._cover()
        self.proven: set[tuple[Drawable, str]] = set()
        self._smaller: dict[int, References] = {}

    def _cover(self) -> None:
        # The depth function decides which of two tied fragments is seen, and passes differ in it.
        with CoverageRunner(self.world, *self.linker.originals("proof")) as runner:
            ties = [runner.ties(frame) for frame in MOVING]
            self.covered = [
                runner.coverage(frame) & ~tie for frame, tie in zip(MOVING, ties, strict=True)
            ]
        self.ties = float(np.mean(ties))

    def smaller(self, divisor: int) -> References:
        """The same scene in a picture that is so many times smaller in each direction, as caches
        at a fraction of the rate show it. It has no images of the original."""
        if divisor == 1:
            return self
        if divisor not in self._smaller:
            other = copy(self)
            other.world, other.images = self.world.smaller(divisor), {}
            # What the copied one has drawn is of another size.
            other.__dict__.pop("surfaces", None)
            other._cover()
            self._smaller[divisor] = other
        return self._smaller[divisor]

    @cached_property
    def surfaces(self) -> Surfaces:
        """What each pixel shows."""
        return Surfaces(self.world, self.linker.originals("proof"))

    def run(
        self, bundle: Bundle, algorithm: str, period: int = PERIOD, moving: bool = True
    ) -> VariantRunner:
        """A run of a bundle's variant, with the other objects' own."""
        chosen = replace(bundle.configuration, algorithm=algorithm).with_refresh(period)
        if bundle.enlarged > 1:
            chosen = replace(chosen, payload_rate=RATES[bundle.enlarged])
        linked = self.linker.link(self.linker.assign(chosen), bundle)
        if bundle.enlarged > 1:
            # What shares the cache shares its depth buffer.
            linked = tuple(map(_enlarged, linked))
        return VariantRunner(self.world, *linked, moving=moving)

    def release(self) -> None:
        """Free everything on the GPU."""
        for other in self._smaller.values():
            other.world.release()
        self.world.release()


def _enlarged(linked: LinkedObject) -> LinkedObject:
    """The same with a texel for each pixel (:meth:`Bundle.enlarge`)."""
    if linked.configuration is None:
        return linked
    full = replace(linked.configuration, payload_rate="full")
    return LinkedObject(linked.bundle.enlarge(), full)

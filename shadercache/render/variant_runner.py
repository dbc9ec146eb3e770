"""Draw variants, frame by frame, as the manifest says.

Arrays that are read back have row 0 at the bottom, as in OpenGL.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.fractions import spread
from shadercache.render.bundle import Bundle, LinkedObject
from shadercache.render.cut_detector import CutDetector, ResetReason
from shadercache.render.draw_items import (
    ORIGINAL,
    DrawItem,
    RunInputs,
    Turn,
    cached_item,
    turns,
    uncached_item,
)
from shadercache.render.empty_passes import EmptyPasses
from shadercache.render.pass_runners import Runner
from shadercache.render.render_scene import RenderScene

NEVER = 65535
"""The longest refresh period that manifests allow: next to nothing is refreshed on purpose."""

_UNWRITTEN = -1.5e38
"""What no shader writes."""


class VariantRunner(Runner):
    """Runs one variant as its manifest says. Frames are drawn in order; the cache carries over.

    Objects with shaders of their own are drawn by their own variants, or their originals, in the
    same frame: all objects finish a pass before the next begins. ``roles`` are how each object is
    drawn, those first that are not cached.

    ``hit_mask`` and ``work`` look at the frame that is about to be drawn, with the caches as they
    are then, and leave the run as it was: call them before ``draw`` of the same frame.
    """

    def __init__(
        self,
        world: RenderScene,
        *objects: LinkedObject,
        moving: bool = True,
        short_reset: bool = False,
    ) -> None:
        """Compile the passes and take a pair of caches; the first frame is a reset frame.

        Args:
            objects: one for all objects of the scene, or as many; as :class:`Linker` makes them.
            moving: without it every frame shows the scene of frame 0, while the clock runs on.
            short_reset: a frame after a reset is one pass that looks nothing up, where there is
                such a pass. The cache is the same (law 4), and so is the image, but that three
                passes show what half floats hold of a payload.

        Raises:
            UsageError: SC026 for an algorithm that the manifest lacks, SC441 for a period that
                the cache's ages cannot count to; InputError as ``BoundPass``.
        """
        super().__init__(world)
        linked = objects * len(world.drawables) if len(objects) == 1 else objects
        self.bundle, self.configuration = _principal(world, linked)
        self.algorithm = self.configuration.algorithm
        self.divisor = self.bundle.cache.divisor
        self.inputs = RunInputs(world, self.configuration, moving)
        self.resets: list[ResetReason] = []
        self.cuts = CutDetector()
        self.idle = EmptyPasses(self.configuration.refresh, world.sample_counter)
        self._moving = moving
        self._caches = world.targets.lend_cache(self.bundle.cache.formats, self.divisor)
        self._holds_caches = True
        try:
            self._caches.set_filter(self.bundle.cache.filter)
            # Asked for its error alone: objects that their originals draw ask for no passes.
            self.bundle.passes(self.algorithm)
            roles = [
                cached_item(self, drawable, linked_object, self._caches, short_reset)
                if linked_object.configuration is not None
                and linked_object.bundle.cache == self.bundle.cache
                else uncached_item(self, drawable, linked_object, self.bundle)
                for drawable, linked_object in zip(world.drawables, linked, strict=True)
            ]
        except DiagnosticError:
            self.release()
            raise
        # What is not cached comes first, for what it hides must not be stored: objects drawn before
        # it would be, those drawn after it would not.
        self.roles = tuple(sorted(roles, key=lambda role: role.caches is not None))
        self.reset()

    @property
    def pass_names(self) -> tuple[str, ...]:
        """The passes, in order; those of other objects' shaders by their own names."""
        return tuple(dict.fromkeys(bound.name for role in self.roles for bound in role.passes))

    @property
    def cached(self) -> tuple[DrawItem, ...]:
        """The objects whose payloads are those that the bundle tells of."""
        return tuple(r for r in self.roles if r.caches is not None and r.bundle is self.bundle)

    def reset(self, reason: ResetReason = "first frame") -> None:
        """Forget everything, and why: the next frame is a reset frame."""
        self.resets.append(reason)
        self.cuts.reset()
        self._caches.clear(self.bundle.cache.clear)
        for role in self.roles:
            role.before = None

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target and the caches, and swap these.

        At a cut of the scene's camera path the frame is a reset frame.
        """
        if self._is_cut(frame):
            self.reset("cut")
        shown = self.inputs.shown(frame)
        self.cuts.watch(frame, self.roles, shown)
        drawn = self._drawn(frame)
        values = {role.drawable: role.drawable.values(shown, frame) for role in drawn}
        self.idle.begin(values, resets=any(role.before is None for role in drawn))
        for turn in self._begin(drawn, frame):
            if self.idle.draw(turn):
                self.world.gpu.submit()
        self._caches.swap()
        self._remember(frame)

    def draw_pass(self, frame: int, name: str) -> None:
        """Draw one pass alone on cleared targets; the caches are not swapped (for measuring).

        What has no passes is drawn with the first of the others'.
        """
        for turn in self._begin(self._drawn(frame), frame):
            if turn.bound.name in (name, ORIGINAL):
                turn.draw()

    def work(self, frame: int) -> dict[str, int]:
        """Fragments that pass the depth test and are not discarded, by pass, in this frame.

        Occlusion queries count overdraw. What a pass of the frame would skip counts as 0.
        """
        counts = dict.fromkeys(self.pass_names, 0)
        # What these draws store is cleared when the frame itself begins.
        query = self.world.sample_counter
        for turn in self._begin(self._drawn(frame), frame):
            with query:
                turn.draw()
            counts[turn.bound.name] = counts.get(turn.bound.name, 0) + int(query.samples)
        return counts

    def hit_mask(self, frame: int) -> NDArray[np.uint8]:
        """What becomes of each texel in this frame, (h, w): 0 uncovered, else ``mask_values``. At
        the full rate there is one for each pixel.

        Objects that are not cached hide what is behind them and count as uncovered.
        """
        # The mask's draws would close the depth that passes must find open. It is cleared here and
        # when the frame itself begins.
        self._clear()
        targets = self.world.targets
        targets.clear(targets.mask_of(self.divisor), keep_depth=True)
        for role in self._drawn(frame):
            if role.debug is None:
                role.debug = self.bind(role.drawable, role.debug_spec, role.naming)
            role.debug.draw(self.inputs.of(role, frame), role.caches)
        return targets.mask_values(self.divisor)

    def outcomes(self, frame: int) -> NDArray[np.uint8]:
        """The same of each pixel: what became of the texel that it lies in."""
        return spread(self.hit_mask(frame), self.world.size)

    def computed(self, frame: int) -> NDArray[np.bool_]:
        """Which pixels the last pass draws in this frame, (h, w): with a cache that is a fraction
        of the picture, those that compute a payload of their own, since none of its texels fits.

        For colours in floats: the last pass draws over one that no shader writes.
        """
        targets, last = self.world.targets, self.pass_names[-1]
        frame_turns = list(self._begin(self._drawn(frame), frame))
        for turn in frame_turns:
            if turn.bound.name != last:
                turn.draw()
        targets.paint(_UNWRITTEN)
        for turn in frame_turns:
            if turn.bound.name == last:
                turn.draw()
        return ~targets.painted(_UNWRITTEN)

    def note_hits(self, frame: int, rate: float) -> None:
        """Tell the run the share of hits of the frame that is about to be drawn: where it falls
        without a cut of the scene, ``cuts`` has it."""
        if not self._is_cut(frame):
            self.cuts.hit(frame, rate)

    def cache(self) -> NDArray[np.float32]:
        """What the last drawn frame stored, (h, w, channels): the next frame will read it.

        Channels of unsigned integers come as the floats of the same bits.
        """
        return self._caches.read_previous()

    def ages(self) -> NDArray[np.float32] | None:
        """How old what the last drawn frame stored is, in frames (h, w), where the cache says; of
        each pixel that of the texel it lies in."""
        channel = self.bundle.cache.age_channel
        return None if channel is None else spread(self.cache()[..., channel], self.world.size)

    def restore(self, cache: NDArray[np.float32], frame: int) -> None:
        """Go on as if ``frame`` had been the last one drawn and had stored ``cache``."""
        self._caches.write_previous(cache)
        self._remember(frame)

    def release(self) -> None:
        """Give programs and caches back to the render scene."""
        super().release()
        # Given back twice, the pair would be lent to two runners.
        if self._holds_caches:
            self.world.targets.take_back(self._caches)
            self._holds_caches = False

    def _is_cut(self, frame: int) -> bool:
        return self._moving and self.world.scene.view.is_cut(frame)

    def _drawn(self, frame: int) -> list[DrawItem]:
        drawn = set(self.world.drawn(self.inputs.shown(frame)))
        return [role for role in self.roles if role.drawable in drawn]

    def _begin(self, drawn: Sequence[DrawItem], frame: int) -> Iterator[Turn]:
        """Clear what a frame begins with; its draws, in order."""
        self._clear()
        self._caches.clear_current(self.bundle.cache.clear)
        return turns(drawn, self.inputs, frame)

    def _clear(self) -> None:
        self.world.begin()
        if self.bundle.apart:
            self.world.targets.clear_depth(self.divisor)

    def _remember(self, frame: int) -> None:
        """What was not drawn has nothing in the cache: it begins anew when it is back."""
        shown = self.inputs.shown(frame)
        drawn = set(self.world.drawn(shown))
        for role in self.roles:
            role.before = shown if role.drawable in drawn else None


def _principal(world: RenderScene, objects: Sequence[LinkedObject]) -> tuple[Bundle, Configuration]:
    """Whose cache it is: the scene's own shader's, where an object that has it is cached."""
    cached = [
        (drawable.scene_object.own_shader, linked.bundle, linked.configuration)
        for drawable, linked in zip(world.drawables, objects, strict=True)
        if linked.configuration is not None
    ]
    if not cached:  # A cache that nothing is stored in.
        return objects[0].bundle, objects[0].bundle.configuration
    _, bundle, configuration = min(cached, key=lambda candidate: candidate[0])
    return bundle, configuration

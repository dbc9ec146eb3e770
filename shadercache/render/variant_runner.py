"""Draw variants, frame by frame, as the manifest says.

Arrays that are read back have row 0 at the bottom, as in OpenGL.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import Configuration
from shadercache.caching.layout import precision_of
from shadercache.diagnostics import DiagnosticError, usage_error
from shadercache.gpu.cache_textures import CachePair, as_precise_as
from shadercache.render.bound_pass import NO_NAMES, BoundPass, FrameInputs, Naming
from shadercache.render.bundle import Bundle, PassSpec
from shadercache.render.cut_detector import CutDetector, ResetReason
from shadercache.render.drawable import Drawable
from shadercache.render.empty_passes import EmptyPasses
from shadercache.render.linked_object import LinkedObject
from shadercache.render.pass_runners import (
    CoverageRunner,
    GeometryRunner,
    OriginalRunner,
    PassRunner,
    PayloadRunner,
    Runner,
    object_numbers,
    render_original,
)
from shadercache.render.render_scene import RenderScene
from shadercache.scene.camera import Values
from shadercache.scene.description import Camera

__all__ = [
    "NEVER",
    "CoverageRunner",
    "DrawItem",
    "GeometryRunner",
    "OriginalRunner",
    "PassRunner",
    "PayloadRunner",
    "VariantRunner",
    "render_original",
]

NEVER = 65535
"""The longest refresh period that manifests allow: next to nothing is refreshed on purpose."""

OLDEST_IN_HALF = 1024
"""Frames that ages in half floats count to: above it, one more frame may be rounded away."""

ORIGINAL = "original"
"""The pass of objects that are not cached."""


@dataclass(eq=False)
class DrawItem:
    """An object in a run: its passes in order, those of a reset, its caches.

    These are None for an object that its original draws: it is not to be cached, or its texels are
    of another kind than the cache's.

    ``debug_spec`` says what becomes of its pixels. ``before``: the frame that was shown when it was
    last drawn; None if the last frame did not show it.
    """

    drawable: Drawable
    linked: LinkedObject
    naming: Naming
    passes: tuple[BoundPass, ...]
    on_reset: tuple[BoundPass | None, ...]
    debug_spec: PassSpec
    caches: CachePair | None
    before: int | None = None
    debug: BoundPass | None = None

    @property
    def bundle(self) -> Bundle:
        """The object's programs."""
        return self.linked.bundle

    @property
    def due(self) -> tuple[BoundPass | None, ...]:
        """The passes of the coming frame, each at its place in the order; None: it is left out."""
        return self.on_reset if self.before is None else self.passes


class VariantRunner(Runner):
    """Runs one variant as its manifest says. Frames are drawn in order; the cache carries over.

    Objects with shaders of their own are drawn by their own variants, or their originals, in the
    same frame: all objects finish a pass before the next begins.

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
        self.moving, self._short_reset = moving, short_reset
        self.resets: list[ResetReason] = []
        self.cuts = CutDetector()
        self._roles: list[DrawItem] = []
        formats = as_precise_as(self.bundle.cache.formats, self.configuration.storage.format)
        self._fixed_numbers = _fixed_numbers(world.scene.camera, formats[0])
        self._caches = world.targets.lend_cache(formats)
        self._holds_caches = True
        try:
            self._caches.set_filter(self.bundle.cache.filter)
            self.bundle.passes(self.algorithm)
            roles = [
                self._role(drawable, item, formats)
                for drawable, item in zip(world.drawables, linked, strict=True)
            ]
        except DiagnosticError:
            self.release()
            raise
        # What is not cached comes first, for what it hides must not be stored: objects drawn before
        # it would be, those drawn after it would not.
        self._idle = EmptyPasses(self.configuration.refresh, world.sample_counter)
        self._roles = sorted(roles, key=lambda role: role.caches is not None)
        self.reset()

    @property
    def algorithm(self) -> str:
        """By which algorithm the objects are drawn whose payloads the bundle tells of."""
        return self.configuration.algorithm

    @property
    def pass_names(self) -> tuple[str, ...]:
        """The passes, in order; those of other objects' shaders by their own names."""
        named = [bound.name for role in self._roles for bound in role.passes]
        return tuple(dict.fromkeys(named))

    @property
    def cached(self) -> tuple[DrawItem, ...]:
        """The objects whose payloads are those that the bundle tells of."""
        return tuple(r for r in self._roles if r.caches is not None and r.bundle is self.bundle)

    @property
    def roles(self) -> tuple[DrawItem, ...]:
        """How each object is drawn, those first that are not cached."""
        return tuple(self._roles)

    @property
    def skipped(self) -> int:
        """How many passes were not drawn, since they had nothing to do."""
        return self._idle.skipped

    def reset(self, reason: ResetReason = "first frame") -> None:
        """Forget everything, and why: the next frame is a reset frame."""
        self.resets.append(reason)
        self.cuts.reset()
        self._caches.clear(self.bundle.cache.clear)
        for role in self._roles:
            role.before = None

    def draw(self, frame: int) -> None:
        """Draw one frame into the colour target and the caches, and swap these.

        At a cut of the scene's camera path the frame is a reset frame.
        """
        if self._is_cut(frame):
            self.reset("cut")
        self._watch(frame)
        self._begin()
        self._idle.begin(*self._to_show(frame))
        for bound, inputs, caches in self._turns(frame):
            if not self._idle.skips(bound):
                self._draw(bound, inputs, caches)
        self._end(frame)

    def draw_pass(self, frame: int, name: str) -> None:
        """Draw one pass alone on cleared targets; the caches are not swapped (for measuring).

        What has no passes is drawn with the first of the others'.
        """
        self._begin()
        for bound, inputs, caches in self._turns(frame):
            if bound.name in (name, ORIGINAL):
                bound.draw(inputs, caches)

    def work(self, frame: int) -> dict[str, int]:
        """Fragments that pass the depth test and are not discarded, by pass, in this frame.

        Occlusion queries count overdraw. What a pass of the frame would skip counts as 0.
        """
        counts = dict.fromkeys(self.pass_names, 0)
        self._begin()
        query = self.world.sample_counter
        for bound, inputs, caches in self._turns(frame):
            with query:
                bound.draw(inputs, caches)
            counts[bound.name] = counts.get(bound.name, 0) + int(query.samples)
        return counts

    def hit_mask(self, frame: int) -> NDArray[np.uint8]:
        """What becomes of each pixel in this frame, (h, w): 0 uncovered, else ``mask_values``.

        Objects that are not cached hide what is behind them and count as uncovered.
        """
        self.world.begin()
        self.world.targets.clear_mask()
        for role in self._drawn(frame):
            if role.debug is None:
                role.debug = self._bind(role.drawable, role.debug_spec, role.naming)
            inputs = self.inputs(role, frame)
            role.debug.draw(inputs, role.caches)
        return self.world.targets.mask_values()

    def cache(self) -> NDArray[np.float32]:
        """What the last drawn frame stored, (h, w, channels): the next frame will read it.

        Channels of unsigned integers come as the floats of the same bits.
        """
        return self._caches.read_previous()

    def ages(self) -> NDArray[np.float32] | None:
        """How old what the last drawn frame stored is, in frames (h, w), where the cache says."""
        channel = self.bundle.age_channel
        return None if channel is None else self.cache()[..., channel]

    def restore(self, cache: NDArray[np.float32], frame: int) -> None:
        """Go on as if ``frame`` had been the last one drawn and had stored ``cache``."""
        self._caches.write_previous(cache)
        self._remember(frame)

    def release(self) -> None:
        """Give programs and caches back to the render scene."""
        super().release()
        if self._holds_caches:
            self.world.targets.take_back(self._caches)
            self._holds_caches = False

    def _role(self, drawable: Drawable, linked: LinkedObject, formats: Sequence[str]) -> DrawItem:
        """How an object is drawn in this run."""
        bundle, chosen = linked.bundle, linked.configuration
        if chosen is None or bundle.cache != self.bundle.cache:
            spec = replace(bundle.original, name=ORIGINAL)
            bound = (self._bind(drawable, spec, NO_NAMES),)
            hidden = replace(bundle.coverage, targets=("mask",))
            return DrawItem(drawable, linked, NO_NAMES, bound, bound, hidden, None)
        _check_period(bundle, formats, chosen.refresh.period)
        naming = Naming(bundle.roles, bundle.twins)
        specs = bundle.passes(chosen.algorithm)
        passes = tuple(self._bind(drawable, spec, naming) for spec in specs)
        on_reset: tuple[BoundPass | None, ...] = tuple(
            bound if spec.on_reset else None for bound, spec in zip(passes, specs, strict=True)
        )
        whole = bundle.reset_pass if self._short_reset else None
        if whole is not None and whole.fragment.name not in {spec.fragment.name for spec in specs}:
            on_reset = (self._bind(drawable, whole, naming),)
        return DrawItem(drawable, linked, naming, passes, on_reset, bundle.debug, self._caches)

    def _draw(self, bound: BoundPass, inputs: FrameInputs, caches: CachePair | None) -> None:
        query = self._idle.counting(bound)
        if query is None:
            bound.draw(inputs, caches)
        else:
            with query:
                bound.draw(inputs, caches)
            self._idle.counted(bound)
        self.world.gpu.submit()

    def _to_show(self, frame: int) -> tuple[list[tuple[Drawable, Values]], bool]:
        """The objects with their uniforms, and whether any of them draws the passes of a reset."""
        drawn = self._drawn(frame)
        shown = self._shown(frame)
        values = [(role.drawable, role.drawable.values(shown, frame)) for role in drawn]
        return values, any(role.before is None for role in drawn)

    def _drawn(self, frame: int) -> list[DrawItem]:
        drawn = set(self.world.drawn(self._shown(frame)))
        return [role for role in self._roles if role.drawable in drawn]

    def _turns(self, frame: int) -> Iterator[tuple[BoundPass, FrameInputs, CachePair | None]]:
        """Every draw of a frame: all objects finish a pass before the next begins."""
        drawn = [(role, self.inputs(role, frame)) for role in self._drawn(frame)]
        over_screen: set[tuple[Bundle, str]] = set()
        for number in range(max((len(role.due) for role, _ in drawn), default=0)):
            for role, inputs in drawn:
                bound = role.due[number] if number < len(role.due) else None
                if bound is None or (role.bundle, bound.name) in over_screen:
                    continue
                if bound.over_screen:
                    over_screen.add((role.bundle, bound.name))
                yield bound, inputs, role.caches

    def note_hits(self, frame: int, rate: float) -> None:
        """Tell the run the share of hits of the frame that is about to be drawn: where it falls
        without a cut of the scene, ``cuts`` has it."""
        if not self._is_cut(frame):
            self.cuts.hit(frame, rate)

    def _is_cut(self, frame: int) -> bool:
        return self.moving and frame in self.world.scene.camera_path.cuts

    def _watch(self, frame: int) -> None:
        """Does what an object is seen from leap, though no reset was told?"""
        for role in self._roles:
            if role.caches is not None and role.before is not None:
                before, now = (
                    role.drawable.values(role.before),
                    role.drawable.values(self._shown(frame)),
                )
                self.cuts.moved(frame, before, now, set(role.bundle.twins.values()))

    def _begin(self) -> None:
        self.world.begin()
        self._caches.clear_current(self.bundle.cache.clear)

    def _end(self, frame: int) -> None:
        self._caches.swap()
        self._remember(frame)

    def _remember(self, frame: int) -> None:
        """What was not drawn has nothing in the cache: it begins anew when it is back."""
        drawn = set(self.world.drawn(self._shown(frame)))
        for role in self._roles:
            role.before = self._shown(frame) if role.drawable in drawn else None

    def inputs(self, role: DrawItem, frame: int) -> FrameInputs:
        """What the role's passes read in the frame that is about to be drawn."""
        shown = self._shown(frame)
        before = shown if role.before is None else role.before
        chosen = role.linked.configuration or self.configuration
        refresh = chosen.refresh
        numbers = {
            # What is drawn uncached knows none of these.
            **(role.bundle.defaults if role.caches else {}),
            **self._fixed_numbers,
            "clock": frame % refresh.period,
            "period": refresh.period,
            "block": refresh.block,
            "epsilon": chosen.hit_test.epsilon,
            "reset": 0,
        }
        if role.before is None and role.caches is not None:
            numbers |= role.bundle.reset_numbers
        given = {name: np.array([value], np.float64) for name, value in numbers.items()}
        given |= object_numbers(role.drawable)
        viewport = self.world.viewport(shown)
        given["viewport"] = np.array(viewport, np.float64)
        given["previous-viewport"] = np.array(self.world.viewport(before), np.float64)
        # Told of the jitter, the last frame's place of a point is the one it had with this frame's.
        told = self.world.scene.engine.told or role.before is None
        last = role.drawable.values(before, frame if told else frame - 1)
        return FrameInputs(role.drawable.values(shown, frame), last, given, viewport)

    def _shown(self, frame: int) -> int:
        return frame if self.moving else 0


def _principal(world: RenderScene, objects: Sequence[LinkedObject]) -> tuple[Bundle, Configuration]:
    """Whose cache it is: the scene's own shader's, where an object that has it is cached."""
    cached = [
        (drawable.item.own_shader, item.bundle, item.configuration)
        for drawable, item in zip(world.drawables, objects, strict=True)
        if item.configuration is not None
    ]
    if not cached:  # A cache that nothing is stored in.
        return objects[0].bundle, objects[0].bundle.configuration
    _, bundle, configuration = min(cached, key=lambda found: found[0])
    return bundle, configuration


def _check_period(bundle: Bundle, formats: Sequence[str], period: int) -> None:
    """Can the ages in these textures count to the period? Raises UsageError SC441 where not."""
    channel = bundle.age_channel
    if channel is None or period <= OLDEST_IN_HALF or not formats[channel // 4].endswith("16f"):
        return
    message = f"ages in half floats count to {OLDEST_IN_HALF}, and the period is {period}"
    raise usage_error("SC441", message, "take --format rgba32f")


def _fixed_numbers(camera: Camera, texel: str) -> dict[str, float]:
    """What is the same in every frame, by role: what follows from the camera and from the format
    that the cache really has."""
    depth = 2.0 * camera.near * camera.far / (camera.far - camera.near)
    return {"unit": depth, **asdict(precision_of(texel))}

"""How each object of a run is drawn, what it reads, and which passes of whom come when."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeAlias

import numpy as np

from shadercache.caching.configuration import Configuration
from shadercache.caching.slots import MOST_GROUPS
from shadercache.diagnostics import usage_error
from shadercache.gpu.cache_textures import CachePair
from shadercache.gpu.fractions import scale_of
from shadercache.render.bound_pass import BoundPass, FrameInputs, object_numbers
from shadercache.render.bundle import (
    NO_NAMES,
    Bundle,
    CacheSpec,
    LinkedObject,
    Naming,
)
from shadercache.render.depth_spec import DepthSpec
from shadercache.render.drawable import Drawable
from shadercache.render.pass_runners import Runner
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene

OLDEST_IN_HALF = 1024
"""Frames that ages in half floats count to: above it, one more frame may be rounded away."""

ORIGINAL = "original"
"""The pass of objects that are not cached."""


@dataclass(eq=False)
class DrawItem:
    """How one object is drawn in a run: its programs, the passes of a frame, the caches it has.

    ``caches`` is None for an object that its original draws: it is not to be cached, or its texels
    are not like those of the others. ``debug_spec`` tells what becomes of its pixels. ``before``:
    the frame that was shown when it was last drawn; None if the last frame did not show it. A None
    among the passes ``on_reset`` is one that a reset leaves out. ``renewed``: is all computed in
    every frame, so that those passes are enough?
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
    renewed: bool = False

    @property
    def bundle(self) -> Bundle:
        """The object's programs."""
        return self.linked.bundle

    @property
    def due(self) -> tuple[BoundPass | None, ...]:
        """The passes of the coming frame, each at its place in the order."""
        return self.on_reset if self.before is None or self.renewed else self.passes


def uncached_item(
    run: Runner, drawable: Drawable, linked: LinkedObject, others: Bundle
) -> DrawItem:
    """An object that its original draws; ``others`` have the caches. Raises as ``BoundPass``."""
    spec = replace(linked.bundle.original, name=ORIGINAL)
    bound = (run.bind(drawable, spec, NO_NAMES),)
    # Where others are asked for their hits, it hides what is behind it.
    hides = replace(
        linked.bundle.coverage,
        targets=("mask",),
        divisor=others.cache.divisor,
        depth=DepthSpec(buffer="apart" if others.apart else "shared"),
    )
    return DrawItem(drawable, linked, NO_NAMES, bound, bound, hides, None)


def cached_item(
    run: Runner, drawable: Drawable, linked: LinkedObject, caches: CachePair, short_reset: bool
) -> DrawItem:
    """An object that a variant draws; ``short_reset`` and what is raised: as ``VariantRunner``."""
    bundle, naming = linked.bundle, linked.bundle.naming
    assert linked.configuration is not None
    _check_period(bundle.cache, linked.configuration)
    specs = bundle.passes(linked.configuration.algorithm)
    passes = tuple(run.bind(drawable, spec, naming) for spec in specs)
    on_reset: tuple[BoundPass | None, ...] = tuple(
        bound if spec.on_reset else None for bound, spec in zip(passes, specs, strict=True)
    )
    whole = bundle.reset_pass if short_reset else None
    # Two passes have the pass themselves, and keep it at its place in their order.
    if whole is not None and whole.fragment.name not in {spec.fragment.name for spec in specs}:
        on_reset = (run.bind(drawable, whole, naming),)
    item = DrawItem(drawable, linked, naming, passes, on_reset, bundle.debug, caches)
    item.renewed = short_reset and bundle.apart and linked.configuration.refresh.renews
    return item


def _check_period(cache: CacheSpec, configuration: Configuration) -> None:
    """Can the ages in the textures count to the period? Raises UsageError SC441 where not."""
    period = configuration.refresh.period
    if cache.age_channel is None or period <= OLDEST_IN_HALF:
        return
    form = cache.formats[cache.age_channel // 4]
    # Where half floats are asked for and floats taken, offsets lie in the lowest bits of ages.
    tucked = form.endswith("32f") and configuration.storage.format == "rgba16f"
    if tucked or form.endswith("16f"):
        where = "beside tucked offsets" if tucked else "in half floats"
        message = f"ages {where} count to {OLDEST_IN_HALF}, and the period is {period}"
        raise usage_error("SC441", message, "take --format rgba32f")


class RunInputs:
    """What the objects of a run read in the frame that is about to be drawn."""

    def __init__(self, world: RenderScene, configuration: Configuration, moving: bool) -> None:
        """Args: ``configuration`` is of objects without; ``moving`` as ``VariantRunner``."""
        self._world, self._configuration, self._moving = world, configuration, moving
        camera = world.scene.view.camera
        # 1/w is this many depths from -1 to 1, in a perspective.
        self._unit = 2.0 * camera.near * camera.far / (camera.far - camera.near)

    def shown(self, frame: int) -> int:
        """The frame of the scene that a frame of the run shows."""
        return frame if self._moving else 0

    def of(self, role: DrawItem, frame: int) -> FrameInputs:
        """What an object's passes read."""
        shown = self.shown(frame)
        # After a reset twins may have any value: nothing is looked up, or nothing found.
        before = shown if role.before is None else role.before
        chosen = role.linked.configuration or self._configuration
        refresh = chosen.refresh
        # What comes later wins: the run's own numbers over defaults, those of a reset over both.
        numbers = {
            **role.naming.defaults,
            "unit": self._unit,
            # Reduced here: shaders add the clock to a turn below the period and take no remainder.
            "clock": frame % refresh.period,
            "period": refresh.period,
            "block": refresh.block,
            "epsilon": chosen.hit_test.epsilon,
            "change": chosen.refresh.adaptive,
            "reset": 0,
            **(role.naming.on_reset if role.before is None else {}),
        }
        given = {name: np.array([value], np.float64) for name, value in numbers.items()}
        given |= object_numbers(role.drawable)
        viewport = self._world.viewport(shown)
        previous = self._world.viewport(before)
        given["viewport"] = np.array(viewport, np.float64)
        given["previous-viewport"] = np.array(previous, np.float64)
        if role.caches is not None:
            given["scale"] = scale_of(viewport, role.bundle.cache.divisor)
        # Told of the jitter, the last frame's place of a point is the one it had with this frame's.
        same_jitter = self._world.scene.view.engine.jitter_told or role.before is None
        last = role.drawable.values(before, frame if same_jitter else frame - 1)
        now = role.drawable.values(shown, frame)
        return FrameInputs(now, last, given, viewport, previous)


class Turn(NamedTuple):
    """One draw: a pass of an object, with what it reads."""

    bound: BoundPass
    inputs: FrameInputs
    caches: CachePair | None

    def draw(self) -> None:
        """Draw it."""
        self.bound.draw(self.inputs, self.caches)


def turns(items: Sequence[DrawItem], inputs: RunInputs, frame: int) -> Iterator[Turn]:
    """Every draw of a frame: all objects finish a pass before the next begins.

    What is drawn over the screen from a pass on comes behind all passes of objects.
    """
    reads = _grouped(items, [inputs.of(role, frame) for role in items])
    for behind in (False, True):
        parts = [_part(role.due, behind) for role in items]
        yield from _drawn(items, reads, parts)


_Passes: TypeAlias = tuple[BoundPass | None, ...]


def _part(due: _Passes, behind: bool) -> _Passes:
    """The passes up to the last one of objects, or those behind it."""
    objects = [at for at, bound in enumerate(due, 1) if bound is not None and not bound.over_screen]
    end = max(objects, default=0)
    return due[end:] if behind else due[:end]


def _drawn(
    items: Sequence[DrawItem],
    reads: Sequence[FrameInputs],
    parts: Sequence[_Passes],
) -> Iterator[Turn]:
    # A pass over the screen is drawn once for all objects of a bundle, or for all of a group. One
    # that only marks pixels reads nothing but the cache, which all bundles share.
    over_screen: set[tuple[Bundle | None, str, float]] = set()
    for number in range(max(map(len, parts), default=0)):
        for role, read, part in zip(items, reads, parts, strict=True):
            bound = part[number] if number < len(part) else None
            if bound is None:
                continue
            group = float(read.numbers["group"][0]) if bound.in_groups else 0.0
            key = (None if bound.marks else role.bundle, bound.name, group)
            if key in over_screen:
                continue
            if bound.over_screen:
                over_screen.add(key)
            yield Turn(bound, read, role.caches)


def _grouped(items: Sequence[DrawItem], reads: Sequence[FrameInputs]) -> list[FrameInputs]:
    """What they read, with the number of the group that each object belongs to."""
    known: dict[tuple[object, ...], int] = {}
    grouped: list[FrameInputs] = []
    for role, read in zip(items, reads, strict=True):
        keys = [bound.key(read) for bound in role.due if bound is not None and bound.in_groups]
        if keys:
            number = known.setdefault((role.bundle, *keys), len(known) + 1)
            if number > MOST_GROUPS:
                message = f"misses of {MOST_GROUPS} draws can be told apart, and there are more"
                raise usage_error("SC444", message, "take --passes 2, or give objects one value")
            group = {"group": np.array([number], np.float64)}
            read = replace(read, numbers={**read.numbers, **group})
        grouped.append(read)
    return grouped

"""Whether a variant reuses what it should, and looks for it where it was (laws 3 and 4).

What is expected comes from the originals (:mod:`surfaces`, :mod:`positions`) and, where not every
pixel has a payload, from a program that stores nothing. What is found is told by the hit mask, and
that the variant does as that says is seen by marking what it reads.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from shadercache.analysed import Analysis
from shadercache.caching.algorithms import algorithm
from shadercache.caching.layout import Layout
from shadercache.compiler import emit_needed
from shadercache.render.bound_pass import BoundPass, FrameInputs, Naming
from shadercache.render.bundle import Bundle
from shadercache.render.drawable import Drawable
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import DrawItem, VariantRunner
from shadercache.verify.expected_hits import (
    Hits,
    Outcomes,
    Stored,
    Tests,
    at_rest,
    in_motion,
    shown_before,
)
from shadercache.verify.surfaces import Mask, Surfaces
from shadercache.verify.vertex_positions import previous_fault, shaken

Texels = NDArray[np.float32]

DEPTH = 3
"""The channel of a cache that holds 1/w."""

_WITHOUT, _UNFIT = 2, 3
"""What :attr:`Bundle.needed` says of pixels without payloads, and of those with unfit ones."""

_HEADING = re.compile(r"^// shadercache: .*$", re.MULTILINE)


@dataclass(eq=False)
class Reuse:
    """Judges the runs of one bundle. ``covered``: by frame, pixels that count.

    ``proven``: vertex shaders whose previous positions have been found right, for all bundles.
    """

    world: RenderScene
    analysis: Analysis
    bundle: Bundle
    surfaces: Surfaces
    covered: list[Mask]
    period: int
    proven: set[tuple[Drawable, str]] = field(default_factory=set)
    _needed: dict[int, Outcomes] = field(default_factory=dict)

    def __post_init__(self) -> None:
        nodes = self.analysis.nodes_of(self.bundle.node("id"))
        self.configuration = self.bundle.configuration
        self.mapping = self.analysis.mapping
        layout = Layout(tuple(node.type for node in nodes))
        self._channels = [channel for channel, _ in layout.read_back]
        self._discrete = [channel for channel, discrete in layout.read_back if discrete]
        emission = emit_needed(self.analysis, self.configuration)
        self._witness = Bundle(emission.manifest, emission.files)

    def rest_fault(self, runner: VariantRunner, masks: list[Outcomes], frame: int) -> str:
        """What is wrong with the hits of a run at rest, or nothing.

        ``masks`` are those of one period, ``frame`` is about to be drawn after it.
        """
        values, has = self.bundle.mask_values, self._has(runner, 0)
        hits = at_rest(masks, has, self._unfit(runner, masks, 0), values, self.configuration)
        if not hits.enough:
            return str(hits)
        mask = runner.hit_mask(frame)
        among = has & np.isin(mask, [values[w] for w in ("hit", "refresh", "old") if w in values])
        among &= self._fit(runner.cache())
        reused = self._reused(runner, among, among & (mask == values["hit"]), frame)
        if reused is None:
            return ""
        must = among & (mask == values["hit"])
        found = int(np.count_nonzero(reused & must))
        amiss = int(np.count_nonzero(among & (reused != must)))
        expected = int(np.count_nonzero(must))
        told = Hits(int(np.count_nonzero(among)), expected, found, exact=True, amiss=amiss)
        return "" if told.enough else f"of what was stored is reused: {told}"

    def motion_fault(self, runner: VariantRunner, looks: list[Look]) -> str:
        """What is wrong with the hits of a run in motion, or nothing."""
        values = self.bundle.mask_values
        masks = [look.mask for look in looks]
        some = self.mapping == "user"
        shown = self._has_in if some else self._shown
        seen = [shown(runner, look) for look in looks]
        guarded = any(self._unfit(runner, masks, look.frame - 1).any() for look in looks)
        hits = in_motion(masks, seen, values, self.configuration, some, guarded)
        return "" if hits.enough else str(hits)

    def previous_fault(self, runner: VariantRunner, frame: int) -> str:
        """What is wrong with where a frame's passes take the last one's vertices to have been.

        Each vertex shader is asked once more with uniforms of which each has changed.
        """
        if self.mapping != "surface":
            return ""
        for role in runner.cached:
            inputs = runner.inputs(role, frame)
            naming = Naming(self.bundle.roles, self.bundle.twins)
            for spec in self.bundle.passes(runner.algorithm):
                if not spec.looks or role.before is None:
                    continue
                asked = [(inputs, self.surfaces.before(role.drawable, frame))]
                known = (role.drawable, _HEADING.sub("", spec.vertex.text))
                if known not in self.proven:
                    asked.append(self._shaken(role, inputs))
                for given, truth in asked:
                    varying = self._prefix + "previous"
                    found = previous_fault(
                        self.world, role.drawable, spec, naming, varying, given, truth
                    )
                    if found:
                        return found
                self.proven.add(known)
        return ""

    def look(self, runner: VariantRunner, frame: int) -> Look | None:
        """The hit mask of a frame that is about to be drawn; None for a frame that is a cut or
        that is drawn into another part of the target than the variant can follow."""
        world = self.world
        moved = world.viewport(frame) != world.viewport(max(frame - 1, 0))
        follows = self.configuration.hit_test.viewport
        if frame in world.scene.camera_path.cuts or (moved and not follows):
            return None
        height, width = self.covered[0].shape
        discrete = np.zeros((height, width, 0), np.uint32)
        if self._discrete:
            discrete = _bits(runner.cache(), self._discrete)
        return Look(frame, runner.hit_mask(frame), discrete)

    @property
    def _marks(self) -> bool:
        """Do hits keep the sign of a depth? (It tells payloads that are of a part of a filter.)"""
        return self.configuration.filter.kind == "bilateral" and self.mapping != "screen"

    @property
    def _prefix(self) -> str:
        names = {role: name for name, role in self.bundle.roles.items()}
        return names["previous-cache"].removesuffix("cache")

    def _shaken(
        self, role: DrawItem, inputs: FrameInputs
    ) -> tuple[FrameInputs, NDArray[np.float32]]:
        before = shaken(inputs.before)
        given = FrameInputs(inputs.now, before, inputs.numbers, inputs.viewport)
        there = FrameInputs(before, before, inputs.numbers, inputs.viewport)
        return given, self.surfaces.at(role.drawable, there)

    def _has_in(self, runner: VariantRunner, look: Look) -> Mask:
        return self._has(runner, look.frame)

    def _shown(self, runner: VariantRunner, look: Look) -> Mask:
        """The pixels that have to hit unless they are due."""
        was = look.frame - 1
        still = self.mapping == "screen"
        numbers = runner.inputs(runner.cached[0], look.frame).numbers
        tests = Tests(self.configuration, float(numbers["epsilon"][0]), float(numbers["unit"][0]))
        stored = Stored(self._has(runner, was), look.discrete, self.world.viewport(was))
        now, before = self.surfaces.frame(look.frame), self.surfaces.frame(was)
        return self._has(runner, look.frame) & shown_before(now, before, stored, tests, still)

    def _has(self, runner: VariantRunner, frame: int) -> Mask:
        """The pixels that have payloads of the bundle's nodes and are refreshed in its period."""
        counted = [
            role.drawable.number
            for role in runner.cached
            if not role.drawable.item.mask
            and role.linked.configuration is not None
            and role.linked.configuration.refresh.period >= self.period
        ]
        has: Mask = self.covered[frame] & np.isin(self.surfaces.frame(frame).number, counted)
        if self._witness.needed_by_some:
            has &= self._needs(runner, frame) != _WITHOUT
        return has

    def _unfit(self, runner: VariantRunner, masks: list[Outcomes], frame: int) -> Mask:
        """The pixels whose payloads a guard keeps from being reused, where look-ups say that there
        are any."""
        poison = self.bundle.mask_values.get("poison", -1)
        if not any((mask == poison).any() for mask in masks):
            return np.zeros_like(self.covered[frame])
        unfit: Mask = self._needs(runner, frame) == _UNFIT
        return unfit

    def _needs(self, runner: VariantRunner, frame: int) -> Outcomes:
        """What the program says that tells pixels with payloads from those without."""
        if frame not in self._needed:
            spec = self._witness.needed
            self.surfaces.lay_depth(frame)
            self.world.targets.clear_mask_alone()
            viewport = self.world.viewport(frame)
            for role in runner.cached:
                if role.drawable in self.world.drawn(frame):
                    values = role.drawable.values(frame)
                    given = FrameInputs(
                        values, values, runner.inputs(role, frame).numbers, viewport
                    )
                    bound = BoundPass(
                        self.world, role.drawable, spec, Naming(self.bundle.roles, {})
                    )
                    bound.draw(given, None, "==")
                    bound.release()
            self._needed[frame] = self.world.targets.mask_values()
        return self._needed[frame]

    def _fit(self, texels: Texels) -> Mask:
        """Which texels hold what no guard minds: depths that match, and usual numbers."""
        floats = [channel for channel in self._channels if channel not in self._discrete]
        sizes = np.abs(texels[..., floats])
        usual = np.isfinite(sizes) & ((sizes == 0.0) | (sizes >= np.finfo(np.float32).tiny))
        found: Mask = usual.all(axis=-1)
        return found & (texels[..., DEPTH] > 0.0) if self._marks else found

    def _reused(self, runner: VariantRunner, among: Mask, hits: Mask, frame: int) -> Mask | None:
        """Which pixels store again what the frame before stored.

        Hits are given the payloads of others. Where a payload decides on a loop, or all are the
        same, it is told by the signs of depths, and where hits do not keep these, not at all.
        """
        cache = runner.cache()
        given = cache.copy()
        read_back = any(algorithm(name).reads_back for name in self.bundle.algorithms)
        exchanged = read_back and _exchange(given, hits, self._channels)
        if not exchanged:
            if not self._marks:
                return None
            given[among, DEPTH] *= -1.0
        runner.restore(given, frame - 1)
        runner.draw(frame)
        after = runner.cache()
        if not exchanged:
            found: Mask = after[..., DEPTH] < 0.0
            return found
        one, other, own = (_bits(texels, self._channels) for texels in (after, given, cache))
        found = (one == other).all(axis=-1) & (other != own).any(axis=-1)
        return found


@dataclass(frozen=True, eq=False)
class Look:
    """What a frame's look-ups find: the hit mask, and what was stored that no filter blends."""

    frame: int
    mask: Outcomes
    discrete: NDArray[np.uint32]


def _exchange(texels: Texels, among: Mask, channels: list[int]) -> bool:
    """Give each of some texels the payload of another, of the next in order; False if all are the
    same. So none is there that the shader has not made."""
    bits = _bits(texels, channels)[among]
    known, which = np.unique(bits, axis=0, return_inverse=True)
    if len(known) < 2:
        return False
    part = texels[among]
    part[:, channels] = np.roll(known, -1, axis=0)[which.reshape(-1)].view(np.float32)
    texels[among] = part
    return True


def _bits(texels: Texels, channels: list[int]) -> NDArray[np.uint32]:
    return np.ascontiguousarray(texels[..., channels]).view(np.uint32)

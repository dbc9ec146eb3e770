"""Whether a variant reuses what it should, and looks for it where it was (laws 3 and 4).

What is expected comes from the originals (:mod:`surfaces`, :mod:`vertex_positions`) and, where not
every pixel has a payload, from a program that stores nothing. The hit mask says what is found.
Marking what a variant reads shows that it does as the mask says.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.algorithms import algorithm
from shadercache.caching.layout import Layout
from shadercache.compiler import emit_needed
from shadercache.diagnostics import InputError
from shadercache.render.bound_pass import BoundPass, FrameInputs, plain_inputs
from shadercache.render.bundle import Bundle, Naming
from shadercache.render.draw_items import DrawItem
from shadercache.render.pass_spec import PassSpec
from shadercache.render.position_pass import PositionPass, Positions
from shadercache.render.surfaces import Mask
from shadercache.render.variant_runner import VariantRunner
from shadercache.verify import expected_hits as expected
from shadercache.verify.expected_hits import HitMasks, Hits, Outcomes
from shadercache.verify.references import References
from shadercache.verify.verdict import PERIOD
from shadercache.verify.vertex_positions import misplaced, shaken

Texels = NDArray[np.float32]

DEPTH = 3
"""The channel of a cache that holds 1/w."""

_NOTHING, _WITHOUT, _UNFIT = 0, 2, 3
"""What :attr:`Bundle.needed` says of pixels where nothing is drawn, of those without payloads, and
of those with unfit ones."""

_HEADING = re.compile(r"^// shadercache: .*$", re.MULTILINE)


@dataclass(frozen=True, eq=False)
class Look:
    """What a frame's look-ups find: the hit mask, and what was stored that no filter blends."""

    frame: int
    mask: Outcomes
    discrete: NDArray[np.uint32]


class Reuse:
    """Judges the runs of one bundle."""

    def __init__(self, references: References, bundle: Bundle) -> None:
        self.references, self.bundle = references, bundle
        self.configuration, self.mapping = bundle.configuration, references.analysis.mapping
        nodes = references.analysis.nodes_of(bundle.node("id"))
        layout = Layout(tuple(node.type for node in nodes))
        self._channels = [channel for channel, _ in layout.read_back]
        self._discrete = [channel for channel, discrete in layout.read_back if discrete]
        emission = emit_needed(references.analysis, self.configuration)
        self._witness = Bundle(emission.manifest, emission.files)
        self._needed: dict[int, Outcomes] = {}

    def rest_fault(self, runner: VariantRunner, frames: list[Outcomes], frame: int) -> str:
        """What is wrong with the hits of a run at rest, or nothing.

        ``frames`` are the hit masks of one period, ``frame`` is about to be drawn after it.
        """
        masks, has = HitMasks(frames, self.bundle.mask_values), self._has(runner, 0)
        hits = expected.at_rest(masks, has, self._unfit(runner, masks, 0), self.configuration)
        if not hits.enough:
            return str(hits)
        mask = runner.hit_mask(frame)
        # The masks say hit; whether what is drawn is what was stored, only a changed cache shows.
        among = has & masks.where(mask, "hit", "refresh", "old") & self._fit(runner.cache())
        must = among & masks.where(mask, "hit")
        reused = self._reused(runner, among, must, frame)
        if reused is None:
            return ""
        of_stored = Hits(
            pixels=expected.count(among),
            expected=expected.count(must),
            hit=expected.count(reused & must),
            exact=True,
            amiss=expected.count(among & (reused != must)),
        )
        return "" if of_stored.enough else f"of what was stored is reused: {of_stored}"

    def motion_fault(self, runner: VariantRunner, looks: list[Look]) -> str:
        """What is wrong with the hits of a run in motion, or nothing."""
        masks = HitMasks([look.mask for look in looks], self.bundle.mask_values)
        # Where the shader itself says from where it reuses, only it knows what was there.
        some = self.mapping == "user"
        seen = [
            self._has(runner, look.frame) if some else self._shown(runner, look) for look in looks
        ]
        guarded = any(self._unfit(runner, masks, look.frame - 1).any() for look in looks)
        hits = expected.in_motion(masks, seen, self.configuration, some, guarded)
        return "" if hits.enough else str(hits)

    def previous_fault(self, runner: VariantRunner, frame: int) -> str:
        """What is wrong with where a frame's passes take the last one's vertices to have been.

        Each vertex shader is asked once more with uniforms of which each has changed.
        """
        if self.mapping != "surface":
            return ""
        for role in runner.cached:
            if role.before is None:
                continue
            inputs = runner.inputs.of(role, frame)
            for spec in self.bundle.passes(runner.algorithm):
                if not spec.looks:
                    continue
                asked = [(inputs, self.references.surfaces.before(role.drawable, frame))]
                # Passes and bundles often share a vertex shader but for its heading.
                shader = (role.drawable, _HEADING.sub("", spec.vertex.text))
                if shader not in self.references.proven:
                    asked.append(self._shaken(role, inputs))
                fault = self._position_fault(role, spec, asked)
                if fault:
                    return fault
                self.references.proven.add(shader)
        return ""

    def _position_fault(
        self, role: DrawItem, spec: PassSpec, asked: list[tuple[FrameInputs, Positions]]
    ) -> str:
        # Added names share a prefix. The manifest tells of no varying, but of the cache's sampler.
        names = {added: name for name, added in role.naming.roles.items()}
        varying = names["previous-cache"].removesuffix("cache") + "previous"
        world, drawable = self.references.world, role.drawable
        try:
            program = PositionPass(world, drawable, spec, role.naming, varying)
        except InputError:
            return f"{spec.vertex.name} does not compute where the vertices were in the last frame"
        faults = [misplaced(program, given, truth) for given, truth in asked]
        program.release()
        return next(filter(None, faults), "")

    def look(self, runner: VariantRunner, frame: int) -> Look | None:
        """The hit mask of a frame that is about to be drawn.

        None for a frame that is a cut or that is drawn into another part of the target than the
        variant can follow.
        """
        world = self.references.world
        moved = world.viewport(frame) != world.viewport(max(frame - 1, 0))
        follows = self.configuration.hit_test.viewport
        if world.scene.view.is_cut(frame) or (moved and not follows):
            return None
        height, width = self.references.covered[0].shape
        discrete = np.zeros((height, width, 0), np.uint32)
        if self._discrete:
            discrete = _bits(runner.cache(), self._discrete)
        return Look(frame, runner.hit_mask(frame), discrete)

    @property
    def _marks(self) -> bool:
        """Do hits keep the sign of a depth? (It tells payloads that are of a part of a filter.)"""
        return self.configuration.filter.kind == "bilateral" and self.mapping != "screen"

    def _shaken(self, role: DrawItem, inputs: FrameInputs) -> tuple[FrameInputs, Positions]:
        # A scene may leave a uniform as it is from frame to frame, and hide that its twin is wrong.
        # An attribute or a texture without a twin rests, as the manifest says.
        resting = role.drawable.streams.keys() - set(role.naming.twins.values())
        before = {**shaken(inputs.before), **{name: inputs.before[name] for name in resting}}
        there = replace(inputs, now=before, before=before)
        truth = self.references.surfaces.at(role.drawable, there)
        return replace(inputs, before=before), truth

    def _shown(self, runner: VariantRunner, look: Look) -> Mask:
        """The pixels that have to hit unless they are due."""
        was, surfaces = look.frame - 1, self.references.surfaces
        numbers = runner.inputs.of(runner.cached[0], look.frame).numbers
        test = expected.DepthTest(
            self.configuration, float(numbers["epsilon"][0]), float(numbers["unit"][0])
        )
        viewport = self.references.world.viewport(was)
        stored = expected.Stored(self._has(runner, was), look.discrete, viewport)
        now, before = surfaces.frame(look.frame), surfaces.frame(was)
        still = self.mapping == "screen"
        shown = expected.shown_before(now, before, stored, test, still)
        return self._has(runner, look.frame) & shown

    def _has(self, runner: VariantRunner, frame: int) -> Mask:
        """The pixels that have payloads of the bundle's nodes and are refreshed in its period."""
        # Draws that opt out, and those with a shorter period, miss more often than is expected.
        counted = [
            role.drawable.number
            for role in runner.cached
            if not role.drawable.scene_object.caching.mask
            and role.linked.configuration is not None
            and role.linked.configuration.refresh.period >= PERIOD
        ]
        seen = self.references.surfaces.frame(frame).number
        has: Mask = self.references.covered[frame] & np.isin(seen, counted)
        if self._witness.needed.by_some:
            needs = self._needs(runner, frame)
            has &= needs != _WITHOUT
            if self.bundle.cache.divisor > 1:
                # The original, drawn as small, discards by places other than those of texels.
                has &= needs != _NOTHING
        return has

    def _unfit(self, runner: VariantRunner, masks: HitMasks, frame: int) -> Mask:
        """The pixels whose payloads a guard keeps from being reused.

        Only where look-ups say that there are any.
        """
        if not any(masks.where(mask, "poison").any() for mask in masks.frames):
            return np.zeros_like(self.references.covered[frame])
        unfit: Mask = self._needs(runner, frame) == _UNFIT
        return unfit

    def _needs(self, runner: VariantRunner, frame: int) -> Outcomes:
        """What the program says that tells pixels with payloads from those without."""
        if frame not in self._needed:
            world, spec = self.references.world, self._witness.needed.spec
            self.references.surfaces.lay_depth(frame)
            world.targets.clear(world.targets.mask, keep_depth=True)
            for role in runner.cached:
                if role.drawable in world.drawn(frame):
                    numbers = runner.inputs.of(role, frame).numbers
                    given = replace(plain_inputs(world, role.drawable, frame), numbers=numbers)
                    naming = Naming(role.naming.roles)
                    bound = BoundPass(world, role.drawable, spec, naming)
                    bound.draw(given, None, "==")  # the front, as the originals have drawn it
                    bound.release()
            self._needed[frame] = world.targets.mask_values()
        return self._needed[frame]

    def _fit(self, texels: Texels) -> Mask:
        """Which texels hold what no guard minds: depths that match, and usual numbers."""
        floats = [channel for channel in self._channels if channel not in self._discrete]
        sizes = np.abs(texels[..., floats])
        # What is smaller a driver may flush to zero (GLSL 4.60 section 4.7.1).
        usual = np.isfinite(sizes) & ((sizes == 0.0) | (sizes >= np.finfo(np.float32).tiny))
        fit: Mask = usual.all(axis=-1)
        return fit & (texels[..., DEPTH] > 0.0) if self._marks else fit

    def _reused(self, runner: VariantRunner, among: Mask, hits: Mask, frame: int) -> Mask | None:
        """Which pixels store again what the frame before stored; None where nothing tells."""
        cache = runner.cache()
        given = cache.copy()
        # Hits are given the payloads of others, but not where a payload decides on a loop: there
        # no algorithm reads back.
        read_back = any(algorithm(name).reads_back for name in self.bundle.algorithms)
        exchanged = read_back and _exchange(given, hits, self._channels)
        if not exchanged:
            if not self._marks:
                return None
            # All are the same, or not to be exchanged: the signs of depths, which hits keep, tell.
            given[among, DEPTH] *= -1.0
        runner.restore(given, frame - 1)
        runner.draw(frame)
        after = runner.cache()
        if not exchanged:
            marked: Mask = after[..., DEPTH] < 0.0
            return marked
        one, other, own = (_bits(texels, self._channels) for texels in (after, given, cache))
        reused: Mask = (one == other).all(axis=-1) & (other != own).any(axis=-1)
        return reused


def _exchange(texels: Texels, among: Mask, channels: list[int]) -> bool:
    """Give each of some texels the payload of another, the next in order.

    So none is there that the shader has not made. False if all are the same.
    """
    bits = _bits(texels, channels)[among]
    known, which = np.unique(bits, axis=0, return_inverse=True)
    if len(known) < 2:
        return False
    part = texels[among]
    # Versions of numpy differ in the shape of the inverse.
    part[:, channels] = np.roll(known, -1, axis=0)[which.reshape(-1)].view(np.float32)
    texels[among] = part
    return True


def _bits(texels: Texels, channels: list[int]) -> NDArray[np.uint32]:
    return np.ascontiguousarray(texels[..., channels]).view(np.uint32)

"""Law 5: judge every hit of a run by the ground truth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from laws.ground_truth import (
    FOOTPRINT,
    Mask,
    Mutation,
    TrueFrame,
    bundle_of,
    due,
    mutated,
    project,
    taps,
)
from numpy.typing import NDArray

from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from tests.configured import DEFAULT, variant

MOST_STALE = 1e-5
"""Share of hits that may lie farther away than the filter's footprint plus epsilon (law 5)."""

MOST_MISSED = {False: 0.02, True: 0.03}
"""Margin of the hit rate: share of the pixels that must hit and may miss all the same.

A point must hit if its whole neighbourhood was seen: all four texels of the filter hold points of
the same surface, within the footprint. Two kinds of them miss. Where facets meet between texels,
the filter finds the depth of the flat surface through all four: at a crease where the slope changes
by 2 that is half a pixel's length off, which here is 1e-3 of the depth, or epsilon. And each
texel's own depth must agree roughly, to within 16 epsilon or 8 pixels' length, so what is seen
under less than 7 degrees misses. Measured at 256 x 256: 0.1 to 1.0 % on the dragon, 1.6 % on the
trash can, whose smooth flanks are seen edge on; a quarter of that at 512 x 512.

True: of carried samples, which also miss where none lies near the pixel; 2.6 % at most, on the
trash can at 5 degrees a frame without any refresh.
"""

OPPOSED = -0.5
"""Cosine between the normals of a point and of what a hit brings, below which that is another side.

The two sides of a wing lie at -1. What a filter blends across a crease within its footprint may
turn by a little over a right angle, and is sound.
"""

MOST_FOREIGN = 1e-3
"""A hit comes from another body if more than this of its value does: more than rounding."""

BLOCK = 4


@dataclass(frozen=True, slots=True)
class Stale:
    """A hit too far away: how many ``pixels`` from the truth, and how many were ``allowed``."""

    frame: int
    x: int
    y: int
    pixels: float
    allowed: float

    def __str__(self) -> str:
        place = f"frame {self.frame}, pixel ({self.x}, {self.y})"
        return f"{place}: {self.pixels:.1f} pixels off, {self.allowed:.1f} allowed"


@dataclass(slots=True)
class Findings:
    """Numbers of pixels over all frames.

    ``unseen``: hits at points that the previous frame did not show. ``whole``: points that were
    seen whole and are not due, so must hit; ``missed`` of them do not. ``seen``: points that were
    seen at all and are not due. ``untimely``: pixels renewed out of turn, or not in their turn.
    """

    covered: int = 0
    hits: int = 0
    seen: int = 0
    whole: int = 0
    missed: int = 0
    unseen: int = 0
    opposed: int = 0
    foreign: int = 0
    untimely: int = 0
    most_missed: float = MOST_MISSED[False]
    stale: list[Stale] = field(default_factory=list)

    @property
    def broken(self) -> list[str]:
        """What does not hold; each stale hit is listed."""
        hits = max(self.hits, 1)
        found = []
        if len(self.stale) > MOST_STALE * hits:
            listed = "\n  ".join(map(str, self.stale[:20]))
            found.append(f"{len(self.stale)} of {hits} hits are too far away:\n  {listed}")
        if self.unseen > MOST_STALE * hits:
            found.append(f"{self.unseen} of {hits} hits were not visible in the previous frame")
        if self.opposed:
            found.append(f"{self.opposed} of {hits} hits come from the other side of a surface")
        if self.foreign:
            found.append(f"{self.foreign} of {hits} hits come from another body")
        if self.missed > self.most_missed * self.whole:
            found.append(f"hit rate: {self.missed} of {self.whole} sound values are not reused")
        if self.untimely:
            found.append(f"{self.untimely} pixels are renewed out of turn, or not in their turn")
        return found

    def __str__(self) -> str:
        covered = max(self.covered, 1)
        worst = max((hit.pixels for hit in self.stale), default=0.0)
        return (
            f"{self.hits} hits ({self.hits / covered:.4f} of covered; seen and not due "
            f"{self.seen / covered:.4f}, seen whole {self.whole / covered:.4f} of which missed "
            f"{self.missed / max(self.whole, 1):.4f}), stale {len(self.stale)} (worst {worst:.1f} "
            f"pixels), unseen {self.unseen}, opposed {self.opposed}, foreign {self.foreign}, "
            f"untimely {self.untimely}"
        )


@dataclass(frozen=True)
class LawFive:
    """A body on the GPU with the truth of frames 0, 1, 2, ...

    ``carried``: the cache is the run's own from frame to frame, so that errors add up; else each
    frame starts from the truth of the one before, so that every look-up is judged by itself.
    """

    world: RenderScene
    truth: list[TrueFrame]
    form: CacheFormat = "rgba32f"
    period: int = 32
    carried: bool = False
    mutation: Mutation | None = None
    cached: Configuration = DEFAULT

    def findings(self) -> Findings:
        """Judge positions, then sides, then bodies where there are several."""
        found = Findings(most_missed=MOST_MISSED[self.cached.filter.carries])
        for frame, mask, values in self._run("v_position"):
            self._judge_positions(found, frame, mask, values)
        for frame, mask, values in self._run("v_normal"):
            opposed = _cosine(values, self.truth[frame].normal) < OPPOSED
            found.opposed += _count(_hit(mask) & opposed)
        if self.truth[0].body.any():
            for frame, mask, values in self._run("v_body"):
                away = np.abs(values[..., 0] - self.truth[frame].body)
                found.foreign += _count(_hit(mask) & (away > MOST_FOREIGN))
        return found

    def _run(self, what: str) -> Iterator[tuple[int, NDArray[np.uint8], NDArray[np.float32]]]:
        """Frame, hit mask and the payloads (h, w, 3) that the frame stores; where a filter keeps
        other ones than it shows, those that it shows."""
        bundle = mutated(bundle_of(what, self.form, self.cached), self.mutation)
        with variant(self.world, bundle, "2-pass", **self._options()) as runner:
            runner.draw(0)
            for frame in range(1, len(self.truth)):
                if not self.carried:
                    runner.restore(self._true_cache(runner, what, frame - 1), frame - 1)
                mask = runner.hit_mask(frame)
                image = runner.image(frame)
                shown = image if self.cached.filter.carries else runner.cache()
                yield frame, mask, shown[..., :3]

    def _true_cache(self, runner: VariantRunner, what: str, frame: int) -> NDArray[np.float32]:
        """A frame's truth as a cache: each sample in the middle of its texel."""
        texels = self.truth[frame].texels(what)
        beside = runner.cache().shape[-1] - texels.shape[-1]
        if self.cached.filter.carries and not beside:
            # Offsets lie in the lowest 12 bits of x and y (caching/glsl/tuck/offsets.glsl).
            bits = np.ascontiguousarray(texels[..., :2]).view(np.uint32) & 0xFFFFF000 | 0x800
            texels[..., :2] = bits.view(np.float32)
        return np.pad(texels, ((0, 0), (0, 0), (0, beside)))

    def _options(self) -> dict[str, int]:
        return {"period": self.period, "block": BLOCK}

    def _judge_positions(
        self, found: Findings, frame: int, mask: NDArray[np.uint8], values: NDArray[np.float32]
    ) -> None:
        true, hit = self.truth[frame], _hit(mask)
        allowed = self._allowed(true)
        away = np.linalg.norm(values - true.position, axis=-1)
        for y, x in np.argwhere(hit & (away > allowed)):
            unit = true.footprint[y, x]
            found.stale.append(
                Stale(frame, int(x), int(y), away[y, x] / unit, allowed[y, x] / unit)
            )
        is_due = due(self.world.size, frame % self.period, self.period, BLOCK)
        seen, whole = self._visible(frame)
        found.covered += _count(true.covered)
        found.hits += _count(hit)
        found.seen += _count(seen & ~is_due)
        found.whole += _count(whole & ~is_due)
        found.missed += _count(whole & ~is_due & ~hit)
        found.unseen += _count(hit & ~seen)
        found.untimely += _count((mask == bundle_values()["refresh"]) != (is_due & true.covered))

    def _allowed(self, true: TrueFrame) -> NDArray[np.float64]:
        epsilon = bundle_of("v_position", self.form).naming.defaults["epsilon"]
        return FOOTPRINT * true.footprint + epsilon * true.w

    def _visible(self, frame: int) -> tuple[Mask, Mask]:
        """Whether the previous frame showed a pixel's point: at all; and with all around it.

        The point counts as shown by a texel that holds a point within the filter's footprint.
        """
        true, before = self.truth[frame], self.truth[frame - 1]
        size = self.world.size
        place = project(before.matrix, true.position, size)[0]
        place[~true.covered] = 1.0
        inside = ((place >= 0.5) & (place <= np.asarray(size) - 0.5)).all(-1) & true.covered
        near = [
            before.covered[tap]
            & (np.linalg.norm(before.position[tap] - true.position, axis=-1) <= self._allowed(true))
            for tap in taps(place, size)
        ]
        return inside & np.logical_or.reduce(near), inside & np.logical_and.reduce(near)


def bundle_values() -> dict[str, int]:
    """What the hit mask's values mean."""
    return bundle_of("v_position", "rgba32f").mask_values


def _cosine(one: NDArray[np.float32], other: NDArray[np.float64]) -> NDArray[np.float64]:
    lengths = np.linalg.norm(one, axis=-1) * np.linalg.norm(other, axis=-1)
    found: NDArray[np.float64] = (one * other).sum(-1) / np.maximum(lengths, 1e-9)
    return found


def _hit(mask: NDArray[np.uint8]) -> Mask:
    found: Mask = mask == bundle_values()["hit"]
    return found


def _count(mask: Mask) -> int:
    return int(np.count_nonzero(mask))

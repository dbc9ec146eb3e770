"""How many hits there must be, and how many there are (laws 3 and 4).

At rest each pixel that has its payload hits in every frame but the one of its turn. In motion the
points hit that the frame before showed whole, up to a margin. Arrays are (h, w).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import Configuration
from shadercache.caching.outcomes import INTERPOLATION, SPREAD
from shadercache.render.surfaces import Floats, Mask, Surface

Outcomes = NDArray[np.uint8]

LEAST = 0.9
"""Share of the points that the frame before showed whole which have to hit. (The corpus: 98 to
100 %; 95 % where one texel is tested by the slope of the surface.)"""

LEAST_ROUNDED = 0.1
"""The same where depths may be off by no more than rounding: then it is that which decides."""

_DUE = ("refresh", "old")


@dataclass(frozen=True, slots=True)
class Hits:
    """Pixels that might hit, all frames together: ``expected`` have to, ``hit`` do.

    ``amiss`` pixels do not hit or miss when they have to, whatever the sum says. ``misses`` are the
    others' outcomes; ``where`` says what the pixels are, in words that follow their number.
    """

    pixels: int
    expected: int
    hit: int
    exact: bool
    amiss: int = 0
    misses: tuple[tuple[str, int], ...] = ()
    where: str = ""

    @property
    def enough(self) -> bool:
        """Is it as expected?"""
        if self.exact:
            return self.hit == self.expected and not self.amiss
        return self.hit >= self.expected

    def __str__(self) -> str:
        least = "" if self.exact else "at least "
        text = f"{self.hit:,} of {self.pixels:,} pixels{self.where} hit, {least}"
        text += f"{self.expected:,} expected"
        if self.hit == self.expected and self.amiss:
            text += f", {self.amiss:,} pixels out of turn"
        missed = ", ".join(f"{number:,} by '{word}'" for word, number in self.misses if number)
        return f"{text} (missed: {missed})" if missed else text


@dataclass(frozen=True, eq=False)
class HitMasks:
    """The hit masks of a run, frame by frame; ``values``: an outcome's number in them."""

    frames: Sequence[Outcomes]
    values: Mapping[str, int]

    def where(self, mask: Outcomes, *words: str) -> Mask:
        """Which pixels have one of these outcomes."""
        return np.isin(mask, [self.values[word] for word in words if word in self.values])

    def times(self, *words: str) -> NDArray[np.int64]:
        """In how many of the frames each pixel has one of these outcomes."""
        counts: NDArray[np.int64] = np.sum([self.where(mask, *words) for mask in self.frames], 0)
        return counts

    def misses(self, among: Sequence[Mask]) -> tuple[tuple[str, int], ...]:
        """How often each outcome but a hit is among pixels, the most frequent first."""
        outcomes = {**self.values, "nothing drawn": 0}
        del outcomes["hit"]
        counts = {
            word: sum(
                count(part & (mask == value)) for mask, part in zip(self.frames, among, strict=True)
            )
            for word, value in outcomes.items()
        }
        return tuple(sorted(counts.items(), key=lambda entry: -entry[1]))


def at_rest(masks: HitMasks, has: Mask, unfit: Mask, configuration: Configuration) -> Hits:
    """Over the frames of one period, of the pixels that have payloads (``has``).

    Some of these are ``unfit`` for reuse. Each has one turn in a period, or none where nothing is
    refreshed on purpose.
    """
    frames, refresh = len(masks.frames), configuration.refresh
    if refresh.adaptive:
        return _at_rest_adaptive(masks, has, unfit)
    age = refresh.age
    hit, due = masks.times("hit"), masks.times(*_DUE)
    exempt = np.where(unfit, masks.times("poison"), 0)
    turns = 1 if refresh.schedule != "none" else 0
    # With ages a payload that was computed out of turn misses it, and one that is too old is
    # computed again: once more, or not at all.
    in_turn = due <= 1 + turns if age else due == turns
    right = in_turn & (hit + due + exempt == frames)
    expected = frames - exempt - (np.minimum(due, 1 + turns) if age else turns)
    return Hits(
        pixels=frames * count(has),
        expected=int(np.maximum(expected, 0)[has].sum()),
        hit=int(hit[has].sum()),
        exact=True,
        amiss=count(has & ~right),
        misses=masks.misses([has] * frames),
        where=f" in {frames} frames",
    )


def _at_rest_adaptive(masks: HitMasks, has: Mask, unfit: Mask) -> Hits:
    """Where periods adapt: how often a pixel is due is up to them, but each is at least once, and
    hits whenever it is not."""
    frames = len(masks.frames)
    hit, due = masks.times("hit"), masks.times(*_DUE)
    exempt = np.where(unfit, masks.times("poison"), 0)
    right = (due >= 1) & (hit + due + exempt == frames)
    expected = int((frames - exempt - due)[has].sum())
    return Hits(
        pixels=frames * count(has),
        expected=expected,
        hit=int(hit[has].sum()),
        exact=True,
        amiss=count(has & ~right),
        misses=masks.misses([has] * frames),
        where=f" in {frames} frames",
    )


def in_motion(
    masks: HitMasks,
    seen: Sequence[Mask],
    configuration: Configuration,
    some: bool = False,
    guarded: bool = False,
) -> Hits:
    """Of the pixels whose point the frame before showed (``seen``), frame by frame.

    ``guarded``: some payloads are unfit for reuse, and so is what a filter makes with them.
    ``some``: nobody knows what it showed, so where a point is inside of it, one hit will do.
    """
    least = LEAST_ROUNDED if configuration.hit_test.tolerance == "akeley-su" else LEAST
    exempt = (*_DUE, "magnified", *["outside"] * some, *["poison"] * guarded)
    seen_in = zip(masks.frames, seen, strict=True)
    must = [shown & ~masks.where(mask, *exempt) for mask, shown in seen_in]
    pairs = zip(masks.frames, must, strict=True)
    pixels = sum(map(count, must))
    return Hits(
        pixels=pixels,
        expected=min(1, pixels) if some else int(least * pixels),
        hit=sum(count(shown & masks.where(mask, "hit")) for mask, shown in pairs),
        exact=False,
        misses=masks.misses(must),
        where=f" that the frame before {'may have shown' if some else 'showed'}",
    )


@dataclass(frozen=True, slots=True)
class DepthTest:
    """What decides whether a depth agrees; ``unit`` is the number of that role."""

    configuration: Configuration
    epsilon: float
    unit: float

    def allowed(self, inverse_w: Floats) -> Floats:
        """What a depth may be off, relative to 1/w."""
        tolerance = self.configuration.hit_test.tolerance
        if tolerance != "fixed":
            relative = INTERPOLATION if tolerance == "akeley-su" else self.epsilon
            return np.full_like(inverse_w, relative)
        # A fixed difference of what is stored of a depth, as a share of 1/w. What is stored is
        # 16/w, w, or z/w, whose slope over 1/w is the camera's.
        units = {"inverse-w": 16.0 * inverse_w, "linear": 1.0 / inverse_w}
        depth = self.configuration.storage.depth
        return self.epsilon / np.abs(units.get(depth, self.unit * inverse_w))


@dataclass(frozen=True, eq=False)
class Stored:
    """What a frame stored. ``kept``: pixels with payloads; ``discrete`` (h, w, channels): their
    integers and booleans, between which no filter goes; ``viewport``: what was drawn into."""

    kept: Mask
    discrete: NDArray[np.uint32]
    viewport: tuple[int, int, int, int]


def shown_before(
    now: Surface, before: Surface, stored: Stored, test: DepthTest, still: bool
) -> Mask:
    """Which pixels show a point that the frame before showed whole.

    All four texels that a filter reads are of that surface, and flat enough for the test of depths.
    ``still``: what is looked up is the pixel's own place.
    """
    height, width = now.number.shape
    if still:
        y, x = np.mgrid[0:height, 0:width]
        corner, expected = np.stack([x, y], -1).astype(np.float64), now.inverse_w
    else:
        corner, expected = now.place - 0.5, now.before
    # Pixels that show nothing have a 1/w of 0, and points behind the camera a negative one.
    with np.errstate(divide="ignore", invalid="ignore"):
        low = np.array(stored.viewport[:2])
        last = low + np.array(stored.viewport[2:]) - 1
        inside = (now.number > 0) & (expected > 0.0)
        inside &= ((corner >= low) & (corner <= last)).all(axis=-1)
        allowed = test.allowed(expected)
        # What lies outside counts no more, but must be an index.
        corner = np.where(inside[..., None], corner, low)
        blended = np.zeros_like(expected)
        near = next(_taps(corner, last))[1]
        for weight, tap in _taps(corner, last):
            off = before.inverse_w[tap] / expected - 1.0
            inside &= stored.kept[tap] & (before.number[tap] == now.number)
            inside &= (stored.discrete[tap] == stored.discrete[near]).all(axis=-1)
            # The look-up turns down any single texel that is too far off, whatever its weight.
            inside &= np.abs(off) <= SPREAD * test.epsilon
            blended += weight * off
        shown: Mask = inside & (np.abs(blended) <= allowed)
    return shown


def _taps(
    corner: Floats, last: NDArray[np.int64]
) -> Iterator[tuple[Floats, tuple[NDArray[np.int64], NDArray[np.int64]]]]:
    """Weight, row and column of the four texels that a filter reads."""
    whole = np.floor(corner)
    part = corner - whole
    near = whole.astype(np.int64)
    # In the middle of a texel there is no second one, and beyond the edge there is none.
    far = np.minimum(near + np.ceil(part).astype(np.int64), last)
    for up in (0, 1):
        for right in (0, 1):
            # 1 - part for a near texel, part for a far one.
            weight = np.abs(1 - right - part[..., 0]) * np.abs(1 - up - part[..., 1])
            yield weight, ((far if up else near)[..., 1], (far if right else near)[..., 0])


def count(mask: Mask) -> int:
    """How many pixels."""
    return int(np.count_nonzero(mask))

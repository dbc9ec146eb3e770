"""How many hits there must be, and how many there are (laws 3 and 4 of DESIGN section 4).

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
from shadercache.verify.surfaces import Floats, Mask, Surface

Outcomes = NDArray[np.uint8]
Rectangle = tuple[int, int, int, int]

LEAST = 0.9
"""Share of the points that the frame before showed whole which have to hit. (The corpus: 98 to
100 %; 95 % where one texel is tested by the slope of the surface.)"""

LEAST_ROUNDED = 0.1
"""The same where depths may be off by no more than rounding: then it is that which decides."""

_DUE = ("refresh", "old")


@dataclass(frozen=True, slots=True)
class Hits:
    """Pixels that might hit, all frames together: ``expected`` have to, ``found`` do.

    ``amiss`` pixels do not hit or miss when they have to, whatever the sum says. ``misses`` are the
    others' outcomes; ``where`` says what the pixels are, in words that follow their number.
    """

    pixels: int
    expected: int
    found: int
    exact: bool
    amiss: int = 0
    misses: tuple[tuple[str, int], ...] = ()
    where: str = ""

    @property
    def enough(self) -> bool:
        """Is it as expected?"""
        if self.exact:
            return self.found == self.expected and not self.amiss
        return self.found >= self.expected

    def __str__(self) -> str:
        least = "" if self.exact else "at least "
        text = f"{self.found:,} of {self.pixels:,} pixels{self.where} hit, {least}"
        text += f"{self.expected:,} expected"
        if self.found == self.expected and self.amiss:
            text += f", {self.amiss:,} pixels out of turn"
        told = ", ".join(f"{count:,} by '{word}'" for word, count in self.misses if count)
        return f"{text} (missed: {told})" if told else text


def at_rest(
    masks: Sequence[Outcomes],
    has: Mask,
    unfit: Mask,
    values: Mapping[str, int],
    configuration: Configuration,
) -> Hits:
    """Over the frames of one period, of the pixels that have payloads (``has``), of which some are
    ``unfit`` for reuse.

    Each has one turn in a period, or none where nothing is refreshed on purpose. With ages a
    payload that was computed out of turn misses it, and one that is too old is computed again.
    """
    hit = _times(masks, values, ("hit",))
    due = _times(masks, values, _DUE)
    exempt = np.where(unfit, _times(masks, values, ("poison",)), 0)
    turns = 1 if configuration.refresh.schedule != "none" else 0
    in_turn = due <= 1 + turns if configuration.refresh.age else due == turns
    right = in_turn & (hit + due + exempt == len(masks))
    renewed = np.minimum(due, 1 + turns) if configuration.refresh.age else turns
    expected = len(masks) - exempt - renewed
    return Hits(
        pixels=len(masks) * _count(has),
        expected=int(np.maximum(expected, 0)[has].sum()),
        found=int(hit[has].sum()),
        exact=True,
        amiss=_count(has & ~right),
        misses=_misses(masks, [has] * len(masks), values),
        where=f" in {len(masks)} frames",
    )


def in_motion(
    masks: Sequence[Outcomes],
    seen: Sequence[Mask],
    values: Mapping[str, int],
    configuration: Configuration,
    some: bool = False,
    guarded: bool = False,
) -> Hits:
    """Of the pixels whose point the frame before showed (``seen``), frame by frame.

    ``guarded``: some payloads are unfit for reuse, and so is what a filter makes with them.
    ``some``: nobody knows what it showed, so where a point is inside of it, one hit will do.
    """
    least = LEAST_ROUNDED if configuration.hit_test.tolerance == "akeley-su" else LEAST
    left = (*_DUE, "magnified", *["outside"] * some, *["poison"] * guarded)
    must = [shown & ~_is(mask, values, left) for mask, shown in zip(masks, seen, strict=True)]
    pixels = sum(_count(mask) for mask in must)
    pairs = zip(masks, must, strict=True)
    return Hits(
        pixels=pixels,
        expected=min(1, pixels) if some else int(least * pixels),
        found=sum(_count(shown & _is(mask, values, ("hit",))) for mask, shown in pairs),
        exact=False,
        misses=_misses(masks, must, values),
        where=f" that the frame before {'may have shown' if some else 'showed'}",
    )


@dataclass(frozen=True, slots=True)
class Tests:
    """What decides whether a depth agrees; ``unit`` is the number of that role."""

    configuration: Configuration
    epsilon: float
    unit: float

    def allowed(self, inverse_w: Floats) -> Floats:
        """What a depth may be off, relative to 1/w."""
        if self.configuration.hit_test.tolerance == "akeley-su":
            return np.full_like(inverse_w, INTERPOLATION)
        if self.configuration.hit_test.tolerance == "relative":
            return np.full_like(inverse_w, self.epsilon)
        units = {"inverse-w": 16.0 * inverse_w, "linear": 1.0 / inverse_w}
        depth = self.configuration.storage.depth
        return self.epsilon / np.abs(units.get(depth, self.unit * inverse_w))


@dataclass(frozen=True, eq=False)
class Stored:
    """What a frame stored. ``kept``: pixels with payloads; ``discrete`` (h, w, channels): their
    integers and booleans, between which no filter goes; ``viewport``: what was drawn into."""

    kept: Mask
    discrete: NDArray[np.uint32]
    viewport: Rectangle


def shown_before(now: Surface, before: Surface, stored: Stored, tests: Tests, still: bool) -> Mask:
    """Which pixels show a point that the frame before showed whole: all four texels that a filter
    reads are of that surface, and flat enough for the test of depths.

    ``still``: what is looked up is the pixel's own place.
    """
    height, width = now.number.shape
    if still:
        y, x = np.mgrid[0:height, 0:width]
        corner, expected = np.stack([x, y], -1).astype(np.float64), now.inverse_w
    else:
        corner, expected = now.place - 0.5, now.before
    with np.errstate(divide="ignore", invalid="ignore"):
        low = np.array(stored.viewport[:2])
        last = low + np.array(stored.viewport[2:]) - 1
        inside = (now.number > 0) & (expected > 0.0)
        inside &= ((corner >= low) & (corner <= last)).all(axis=-1)
        allowed = tests.allowed(expected)
        corner = np.where(inside[..., None], corner, low)
        blended = np.zeros_like(expected)
        near = next(_taps(corner, last))[1]
        for weight, tap in _taps(corner, last):
            off = before.inverse_w[tap] / expected - 1.0
            inside &= stored.kept[tap] & (before.number[tap] == now.number)
            inside &= (stored.discrete[tap] == stored.discrete[near]).all(axis=-1)
            inside &= np.abs(off) <= SPREAD * tests.epsilon
            blended += weight * off
        found: Mask = inside & (np.abs(blended) <= allowed)
    return found


def _taps(
    corner: Floats, last: NDArray[np.int64]
) -> Iterator[tuple[Floats, tuple[NDArray[np.int64], NDArray[np.int64]]]]:
    """Weight, row and column of the four texels that a filter reads."""
    whole = np.floor(corner)
    part = corner - whole
    near = whole.astype(np.int64)
    far = np.minimum(near + np.ceil(part).astype(np.int64), last)
    for up in (0, 1):
        for right in (0, 1):
            weight = np.abs(1 - right - part[..., 0]) * np.abs(1 - up - part[..., 1])
            yield weight, ((far if up else near)[..., 1], (far if right else near)[..., 0])


def _times(
    masks: Sequence[Outcomes], values: Mapping[str, int], words: Sequence[str]
) -> NDArray[np.int64]:
    """In how many of the frames each pixel has one of the outcomes."""
    found: NDArray[np.int64] = np.sum([_is(mask, values, words) for mask in masks], axis=0)
    return found


def _is(mask: Outcomes, values: Mapping[str, int], words: Sequence[str]) -> Mask:
    return np.isin(mask, [values[word] for word in words if word in values])


def _misses(
    masks: Sequence[Outcomes], among: Sequence[Mask], values: Mapping[str, int]
) -> tuple[tuple[str, int], ...]:
    """How often each outcome but a hit is among pixels, the most frequent first."""
    pairs = list(zip(masks, among, strict=True))
    counts = {
        word: sum(_count(part & (mask == value)) for mask, part in pairs)
        for word, value in values.items()
        if word != "hit"
    }
    counts["nothing drawn"] = sum(_count(part & (mask == 0)) for mask, part in pairs)
    return tuple(sorted(counts.items(), key=lambda item: -item[1]))


def _count(mask: Mask) -> int:
    return int(np.count_nonzero(mask))

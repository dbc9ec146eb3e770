"""What may be chosen, and what a value is tried with."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from shadercache.caching.algorithms import FRACTIONAL, PROMISING
from shadercache.caching.configuration import (
    CacheFormat,
    Configuration,
    Filter,
    FilterKind,
    PayloadRate,
    Storage,
)

BASE_PERIOD = 1
"""What stands for all periods: they share programs."""


@dataclass(frozen=True, slots=True)
class Space:
    """The choices of each slot; the first of each is what a value is surveyed with.

    ``adaptive``: by how much a refresh may change a payload before it is refreshed more often;
    beside these all are refreshed alike.
    """

    algorithms: tuple[str, ...] = PROMISING
    periods: tuple[int, ...] = (2, 3, 4, 6, 8, 12, 16, 24, 32, 48)
    rates: tuple[PayloadRate, ...] = ("full", "half", "quarter")
    filters: tuple[FilterKind, ...] = ("bilateral", "carried", "lanczos2", "nearest")
    blocks: tuple[int, ...] = (4, 8)
    formats: tuple[CacheFormat, ...] = ("rgba16f", "rgba32f")
    adaptive: tuple[float, ...] = (0.05,)

    def first(self, base: Configuration) -> Configuration:
        """What a value is surveyed with. ``base``: a configuration of the scene."""
        return replace(
            base.with_refresh(BASE_PERIOD, self.blocks[0]),
            algorithm=self.algorithms[0],
            payload_rate=self.rates[0],
            filter=Filter(self.filters[0]),
            storage=Storage(self.formats[0]),
        )

    def main(self, first: Configuration, still: bool) -> Iterator[Configuration]:
        """What else a value is tried with, what pays more often first; one slot is changed at a
        time. ``still``: does the value stay the same on its surface?"""
        rates = [replace(first, algorithm=FRACTIONAL, payload_rate=rate) for rate in self.rates[1:]]
        resampled = [replace(first, filter=Filter(kind)) for kind in self.filters[1:2]]
        yield from (replace(first, algorithm=name) for name in self.algorithms[1:3])
        # What stays is blurred by resampling and by nothing else; what moves gets old.
        yield from (*resampled, *rates) if still else (*rates, *resampled)

    def minor(self, chosen: Configuration) -> Iterator[Configuration]:
        """What may make a good choice a little better."""
        yield from (chosen.with_refresh(block=block) for block in self.blocks[1:])
        yield from (replace(chosen, filter=Filter(kind)) for kind in self.filters[2:])
        yield from (replace(chosen, storage=Storage(form)) for form in self.formats[1:])
        yield from (replace(chosen, algorithm=name) for name in self.algorithms[3:])

    def adapting(self, chosen: Configuration) -> Iterator[Configuration]:
        """The same, refreshed more often where a refresh changes a payload, and else rarely."""
        refresh = replace(chosen.refresh, period=self.periods[-1])
        return (
            replace(chosen, refresh=replace(refresh, adaptive=limit)) for limit in self.adaptive
        )


def of_one_image(one: Configuration, other: Configuration) -> bool:
    """Do two configurations of a value draw the same images, so that only their times differ?

    The algorithms agree at the full rate (law 4), and half floats round alike in all of them.
    """
    return one == replace(other, algorithm=one.algorithm) and one.payload_rate == "full"

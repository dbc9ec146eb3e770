"""A laboratory that computes what a real one would measure: for tests of the search alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.measure.statistics import Ratio
from shadercache.tuning.laboratory import Drawn, Run

ORIGINAL = 0.05
OVERHEAD = {
    "1-pass": (0.5, 0.2),
    "2-pass": (0.15, 0.35),
    "3-pass": (0.25, 0.3),
    "parked": (0.2, 0.1),
}
"""What an algorithm adds to a frame of hits and to one of misses."""


@dataclass(frozen=True, slots=True)
class Physics:
    """What is true of a value: the share of the shader that it saves, and how its error grows with
    the age of what is reused."""

    saved: float
    alpha: float
    rate: float


@dataclass
class Computed:
    """A laboratory. ``values``: by node id, ``mu`` of all. Played twice as fast payloads age twice
    as fast, and err ``haste`` times as much as such do at the usual speed. ``now`` is its clock: a
    drawn frame takes ``ORIGINAL`` seconds. ``noise`` of times. Algorithms that are ``late`` shade
    misses before they discard them."""

    values: dict[str, Physics]
    mu: float = 0.95
    haste: float = 1.0
    noise: float = 0.0
    late: tuple[str, ...] = ()
    now: float = 0.0
    runs: list[tuple[tuple[Assignment, ...], Run]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._random = np.random.default_rng(7)

    def clock(self) -> float:
        """Seconds since it was made."""
        return self.now

    def draw(self, assignments: Sequence[Assignment], run: Run) -> list[Drawn]:
        """What they would come to."""
        self.runs.append((tuple(assignments), run))
        self.now += run.frames * (1 + len(assignments)) * ORIGINAL
        return [self._drawn(_chosen(one), run) for one in assignments]

    def share(self, chosen: Configuration) -> float:
        """The time of a frame over the original's."""
        hit, miss = OVERHEAD[chosen.algorithm]
        saved = max(self._of(chosen).saved, 0.0)
        fetch = 0.05 if chosen.filter.kind == "carried" else 0.0
        pixels = 1.0 / chosen.divisor**2
        rate = self.mu * (1.0 - 1.0 / chosen.refresh.period)
        shaded = 1.0 - saved if chosen.algorithm in self.late else 0.0
        computed = (1.0 - rate) * (miss + saved + shaded) * pixels
        return hit + fetch + (1.0 - saved) + computed

    def error(self, chosen: Configuration, age: float) -> float:
        """The error of payloads of an age."""
        value = self._of(chosen)
        carried = 0.5 if chosen.filter.kind == "carried" else 1.0
        floor = 0.0 if chosen.divisor == 1 else 0.004 * chosen.divisor
        return floor + carried * value.alpha * float(-np.expm1(-value.rate * age))

    def error_of_period(self, chosen: Configuration, step: int = 1) -> float:
        """The error of its period; with a ``step`` of 2 at twice the speed."""
        ages = [self.error(chosen, step * age) for age in range(chosen.refresh.period)]
        factor = self.haste if step > 1 else 1.0
        return factor * float(np.sqrt(np.mean(np.square(ages))))

    def _of(self, chosen: Configuration) -> Physics:
        known = [self.values[name] for name in chosen.nodes]
        return max(known, key=lambda one: one.saved)

    def _drawn(self, chosen: Configuration, run: Run) -> Drawn:
        if chosen.refresh.period > 1000:
            errors = tuple(self.error(chosen, run.step * frame) for frame in run.compared)
        else:
            errors = (self.error_of_period(chosen, run.step),) * len(run.compared)
        share = self.share(chosen) * (1.0 + self.noise * float(self._random.standard_normal()))
        ratio = Ratio(1.0 / share, 0.99 / share, 1.01 / share, 1.0 / share)
        hits = (self.mu,) * len(run.compared) if run.hits else ()
        return Drawn(ratio, errors, hits, ORIGINAL)


def _chosen(assignment: Assignment) -> Configuration:
    [chosen] = [one for _, one in assignment.objects if one is not None]
    return chosen

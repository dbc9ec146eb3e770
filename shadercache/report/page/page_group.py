"""What may be compared: the rows of one scene, at one size, on one machine."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from shadercache.report.page.fronts import pareto_front
from shadercache.sweep.row import Machine, Row, SceneEntry, TrialResult

METRICS: Mapping[str, str] = {"rmse": "RMSE", "flip": "FLIP", "flicker": "flicker"}
"""The errors that the page can draw against time, and what they are called."""


SMALL_ERROR = 0.01
"""An RMSE up to which a difference is hard to see: two and a half levels of 255."""


@dataclass(frozen=True, eq=False)
class Measured:
    """A row that has a result, and its place in the group."""

    place: int
    row: Row
    result: TrialResult

    @property
    def is_peer(self) -> bool:
        return self.row.kind == "peer"

    @property
    def algorithm(self) -> str | None:
        """None of a peer."""
        return None if self.row.configuration is None else self.row.configuration["algorithm"]

    @property
    def time(self) -> float:
        """The share of the original's time."""
        return 1.0 / self.result.times.ratio.median

    def error(self, metric: str) -> float | None:
        """None where the store lacks this measure."""
        image = self.result.image
        if metric == "rmse":
            return image.rmse
        value: float | None = getattr(image.perceived, metric, None)
        return value


@dataclass(frozen=True, eq=False)
class PageGroup:
    """Rows that may be compared; times of two groups may not."""

    scene: SceneEntry
    machine: Machine
    rows: tuple[Row, ...]

    @property
    def name(self) -> str:
        """For a heading or a list."""
        width, height = self.scene.size
        return f"{self.scene.name}, {width} × {height}, {self.machine.name}"

    @cached_property
    def measured(self) -> tuple[Measured, ...]:
        """The rows that have a result."""
        pairs = ((place, row, row.result) for place, row in enumerate(self.rows))
        return tuple(Measured(*pair[:2], pair[2]) for pair in pairs if pair[2] is not None)

    @property
    def variants(self) -> list[Measured]:
        return [one for one in self.measured if not one.is_peer]

    @property
    def peers(self) -> list[Measured]:
        return [one for one in self.measured if one.is_peer]

    @property
    def best(self) -> Measured | None:
        """The fastest variant with a small error; where there is none, the nearest one."""
        small = [one for one in self.variants if one.result.image.rmse <= SMALL_ERROR]
        if small:
            return min(small, key=lambda one: one.time)
        return min(self.variants, key=lambda one: one.result.image.rmse, default=None)

    @property
    def geometry(self) -> float:
        """What the geometry alone takes, as a share of the original's time."""
        every = [one.result.times.samples for one in self.measured]
        shares = [np.median(one.geometry) / np.median(one.original) for one in every]
        return float(np.median(shares))

    @property
    def original(self) -> tuple[float, float, float]:
        """Seconds of the original: the middle, the least and the most of its medians."""
        medians = [np.median(one.result.times.samples.original) for one in self.measured]
        return float(np.median(medians)), float(min(medians)), float(max(medians))

    @property
    def metrics(self) -> list[str]:
        """Those that any row has."""
        return [
            name for name in METRICS if any(one.error(name) is not None for one in self.measured)
        ]

    def front(self, metric: str, among: Sequence[Measured]) -> list[Measured]:
        """Those that none of the others is as fast and as near as."""
        known = [(one, error) for one in among if (error := one.error(metric)) is not None]
        return [known[at][0] for at in pareto_front([(one.time, error) for one, error in known])]

    def worth_a_look(self) -> Iterator[Measured]:
        """All that are measured, what a reader will want to see first: the best, the fronts, the
        peers, the fastest of each payload, then the rest by time."""
        yielded: set[int] = set()
        for one in self._by_interest():
            if one.place not in yielded:
                yielded.add(one.place)
                yield one

    def _by_interest(self) -> Iterator[Measured]:
        if self.best is not None:
            yield self.best
        for metric in self.metrics:
            yield from self.front(metric, self.variants)
        yield from self.peers
        by_time = sorted(self.variants, key=lambda one: one.time)
        # The last that is written for a label stays, which is the fastest.
        yield from {one.row.label: one for one in reversed(by_time)}.values()
        yield from by_time


def page_groups(rows: Iterable[Row]) -> list[PageGroup]:
    """The groups of a store, in the order of their first rows."""
    found: dict[tuple[object, ...], list[Row]] = {}
    for row in rows:
        scene = row.scene
        key = (scene.name, scene.size, scene.frames, scene.mapping, scene.options, row.machine)
        found.setdefault(key, []).append(row)
    return [PageGroup(same[0].scene, same[0].machine, tuple(same)) for same in found.values()]

"""What is known of a value with a set of choices, over all refresh periods."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.measure.metrics.frame_errors import Metric
from shadercache.scene.description import Scene
from shadercache.tuning.age_errors import error_of_period
from shadercache.tuning.groups import ShaderGroup, assignment_of
from shadercache.tuning.models import ErrorModel, TimeModel, fit_error
from shadercache.tuning.values import Value

MOVING_HASTE, STILL_HASTE = 1.0, 1.2
"""How many times larger an error is taken to be at twice the speed than what is expected there: of
values that change with what moves, and of those that are only resampled more."""

UNSURE = 1.25
"""How many times larger what grows with speed is taken to be where nobody has measured it."""

SHORT = (1, 2, 3, 4, 6, 8, 12, 16, 24)
"""Periods that an error's model goes through, beside the longest."""


@dataclass(eq=False)
class Family:
    """Configurations that differ in their period alone.

    ``base`` has any period. ``time`` and ``error`` are fitted to few frames, maybe of a small
    picture; ``scale`` is how many times larger the error was found to be when it was looked at.
    ``haste``: how many times larger it is thought to be where the scene is played twice as fast;
    it is ``sure`` where that was measured. ``times``: those that were measured, as shares of the
    original's, by period.
    """

    group: ShaderGroup
    value: Value
    base: Configuration
    time: TimeModel | None = None
    error: ErrorModel | None = None
    scale: float = 1.0
    haste: float = 0.0
    sure: bool = False
    times: dict[int, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.haste = self.haste or (MOVING_HASTE if self.value.changes else STILL_HASTE)

    def at(self, period: int) -> Configuration:
        """The configuration of a period."""
        return self.base.with_refresh(period)

    @property
    def kind(self) -> Configuration:
        """The choices without the value."""
        return replace(self.base, nodes=())

    def share(self, period: int) -> float:
        """The predicted time of a frame over the original's; 1 where nothing is known."""
        return 1.0 if self.time is None else self.time.at(period)

    def error_at(self, period: int) -> float:
        """The predicted error at full size and usual speed; infinite where nothing is known."""
        return float("inf") if self.error is None else self.scale * self.error.at(period)

    def hasty_error_at(self, period: int) -> float:
        """The same at twice the speed, where what is reused errs more, and what is not does not."""
        fresh = self.error_at(1)
        return fresh + self.guarded_haste * (self._aged(period) - fresh)

    @property
    def guarded_haste(self) -> float:
        """``haste``, or more where it is not sure."""
        return self.haste * (1.0 if self.sure else UNSURE)

    def _aged(self, period: int) -> float:
        """The error of payloads that have seen as much motion as those of a period do at twice the
        speed. What does not move does not age."""
        return self.error_at(2 * period - 1 if self.value.changes else period)

    def correct_haste(self, period: int, worst: float) -> None:
        """Learn from the error that was found at twice the speed."""
        fresh, aged = self.error_at(1), self._aged(period)
        if aged > fresh:
            self.haste = max(0.0, worst - fresh) / (aged - fresh)

    def longest(self, limit: float, periods: Sequence[int]) -> int | None:
        """The longest period whose predicted error is within a limit at twice the speed, too.

        Payloads at a fraction of the rate save something even where all of them are recomputed. Of
        what adapts nothing is known but at the period that it was drawn with, the longest.
        """
        some = (1, *periods) if self.base.divisor > 1 else periods
        tried = some[-1:] if self.base.refresh.adaptive else some
        fitting = [one for one in tried if self.hasty_error_at(one) <= limit]
        return max(fitting, default=None)

    def learn_error(self, ages: Mapping[int, float], metric: Metric, straying: float = 0.0) -> None:
        """Fit the error to what payloads of some ages came to. ``straying``: of the full rate."""
        longest = max(ages) + 1
        # At the full rate what is recomputed is the original's.
        first = 1 if self.base.divisor > 1 else 2
        periods = [period for period in (*SHORT, longest) if first <= period <= longest]
        # In a smaller cache what moves leaves fewer blocks.
        slower = straying / self.base.divisor
        errors = [error_of_period(ages, period, metric, slower) for period in periods]
        self.error = fit_error(periods, errors)


@dataclass(frozen=True)
class Plan:
    """What is cached in a frame: at most one family of each group, with its period; some objects
    of these are drawn by their originals all the same (``without``)."""

    parts: tuple[tuple[Family, int], ...]
    without: tuple[str, ...] = ()

    @property
    def share(self) -> float:
        """The predicted time of a frame over the original's: groups save beside each other."""
        return 1.0 - sum(1.0 - family.share(period) for family, period in self.parts)

    @property
    def error(self) -> float:
        """The predicted error: errors of groups lie in different pixels, so squares add."""
        return _together(family.error_at(period) for family, period in self.parts)

    @property
    def hasty_error(self) -> float:
        """The same where the scene is played twice as fast."""
        return _together(family.hasty_error_at(period) for family, period in self.parts)

    @property
    def configurations(self) -> Iterator[tuple[ShaderGroup, Configuration]]:
        """What each group has."""
        return ((family.group, family.at(period)) for family, period in self.parts)

    @property
    def key(self) -> tuple[frozenset[Configuration], tuple[str, ...]]:
        """Equal for plans that draw the same."""
        return frozenset(chosen for _, chosen in self.configurations), self.without

    def assignment(self, scene: Scene) -> Assignment:
        """What draws each object."""
        return assignment_of(scene, dict(self.configurations)).with_originals(self.without)


def _together(errors: Iterable[float]) -> float:
    return float(sum(error**2 for error in errors) ** 0.5)

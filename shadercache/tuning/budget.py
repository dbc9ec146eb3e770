"""How long tuning may take, and what is likely to fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic

from shadercache.tuning.laboratory import Run

COMPILING = 0.4
"""Seconds that a variant's programs are thought to take before any was compiled."""


@dataclass
class Budget:
    """``seconds`` from ``begun`` on. Runs are timed, so that later ones can be foretold."""

    seconds: float
    now: Callable[[], float] = monotonic
    begun: float | None = None
    _per_draw: dict[bool, float] = field(default_factory=dict)
    _compiling: float = COMPILING

    def __post_init__(self) -> None:
        if self.begun is None:
            self.begun = self.now()

    @property
    def spent(self) -> float:
        """Seconds since the beginning."""
        assert self.begun is not None
        return self.now() - self.begun

    def left(self, share: float = 1.0) -> float:
        """Seconds until a share of the budget is spent; below 0 when it is."""
        return share * self.seconds - self.spent

    def note(self, run: Run, subjects: int, seconds: float, fresh: int) -> None:
        """A run of so many subjects, of which some were ``fresh`` (not compiled), has taken that
        long."""
        drawing = max(1e-4, seconds - fresh * self._compiling)
        per_draw = drawing / (run.frames * (subjects + 1))
        known = self._per_draw.get(run.small)
        # The slower of the two, half forgotten: a guess that is too low breaks the promise.
        self._per_draw[run.small] = (
            per_draw if known is None else max(per_draw, 0.5 * (known + per_draw))
        )

    def expected(self, run: Run, subjects: int, fresh: int) -> float:
        """The seconds that a run is likely to take; 0 where nothing is known of such runs."""
        per_draw = self._per_draw.get(run.small, 0.0)
        return run.frames * (subjects + 1) * per_draw + fresh * self._compiling

    def fits(self, share: float, *runs: tuple[Run, int, int]) -> bool:
        """Will such runs end before a share of the budget is spent? Each is a run with its numbers
        of subjects, and of those that are fresh."""
        return sum(self.expected(*run) for run in runs) <= self.left(share)

"""The proof: what was chosen is drawn on frames that the choice did not see, and holds there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from shadercache.measure.statistics import Ratio
from shadercache.scene.description import Scene
from shadercache.tuning.bound import Bound
from shadercache.tuning.families import Plan
from shadercache.tuning.laboratory import Drawn
from shadercache.tuning.search import Finalist, Search, whole_run

ROUNDS = 5
"""How often other plans are tried: safer ones, or bolder ones where there is room below a bound."""

FASTER = 0.99
"""Beside a plan that holds another is tried if it is expected to take less than this share of its
time."""


@dataclass(frozen=True, slots=True)
class Passage:
    """A part of the scene's path that no choice was made by: its first frame, and its speed."""

    name: str
    start: int
    step: int = 1


@dataclass(frozen=True)
class Proven:
    """A plan on each passage."""

    plan: Plan
    passages: tuple[tuple[Passage, Drawn], ...]

    @property
    def worst(self) -> float:
        """The largest error of any frame."""
        return max(drawn.worst for _, drawn in self.passages)

    @property
    def mean(self) -> float:
        """The mean error of the passage where it is larger."""
        return max(drawn.mean for _, drawn in self.passages)

    @property
    def speedup(self) -> Ratio:
        """Of the passage where it is less."""
        return min((drawn.speedup for _, drawn in self.passages), key=lambda ratio: ratio.median)

    def holds(self, bound: Bound) -> bool:
        """Is the bound kept in every frame, and is every passage faster than the original?"""
        faster = all(drawn.speedup.low > 1.0 for _, drawn in self.passages)
        return faster and self.worst <= bound.aim


def passages_of(scene: Scene, seen: int, frames: int) -> tuple[Passage, ...]:
    """The part of the path behind the frames that have been ``seen``, and one behind that at twice
    the speed. ``frames``: of a run."""
    keys = scene.view.camera_path.keys
    ends = [keys[-1].frame] if keys else []
    if scene.recording is not None:
        ends.append(scene.recording.frames)
    # What turns or drifts goes on; what is played along keys or a recording ends there.
    end = min(ends, default=seen + 3 * frames)
    later = max(0, min(seen, end - frames))
    faster = max(0, min(seen + frames, end - 2 * frames))
    return (Passage("another part of the path", later), Passage("twice as fast", faster, 2))


@dataclass
class Proof:
    """Draws plans on the passages until each bound has one that holds."""

    search: Search

    def __post_init__(self) -> None:
        self.proven: list[Proven] = []
        self.trials, self.bounds = self.search.trials, self.search.bounds
        self.seen = 0

    def run(self) -> dict[Bound, Proven | None]:
        """The fastest plan that holds for each bound; None where none does."""
        self.seen = self.trials.seen
        for _ in range(ROUNDS):
            # The tightest bound first: what holds for it holds for the others.
            tight = sorted(self.bounds, key=lambda bound: bound.aim)
            wanted = {plan.key: plan for bound in tight if (plan := self._next(bound))}
            plans = list(wanted.values())
            while len(plans) > (not self.proven) and not self._is_time(plans):
                plans.pop()
            if not plans:
                break
            self._draw(plans)
        return {bound: self._best(bound) for bound in self.bounds}

    def _is_time(self, plans: Sequence[Plan]) -> bool:
        run = whole_run(plans, self.trials.setting.metric)
        return self.trials.budget.fits(1.0, *[(run, len(plans), 0)] * 2)

    def _best(self, bound: Bound) -> Proven | None:
        holding = [one for one in self.proven if one.holds(bound)]
        return max(holding, key=lambda one: one.speedup.median, default=None)

    def _next(self, bound: Bound) -> Plan | None:
        """The fastest plan, as measured or as predicted, that may hold and was not tried yet; none
        that is hardly faster than one that holds."""
        tried = {one.plan.key for one in self.proven}
        shares = {one.plan.key: 1.0 / one.drawn.speedup.median for one in self.search.finalists}
        best = self._best(bound)
        least = 1.0 if best is None else FASTER / best.speedup.median
        measured = [
            one.plan
            for one in self.search.finalists
            if one.plan.without and self._hasty(one) <= bound.aim
        ]
        fitting = {
            plan: share
            for plan in (*self.search.plans(bound.aim), *measured)
            if plan.key not in tried and (share := shares.get(plan.key, plan.share)) < least
        }
        if fitting or self.proven:
            return min(fitting, key=lambda plan: fitting[plan], default=None)
        # Nothing is likely to hold. What holds at the usual speed is tried all the same: how much
        # more it errs in haste is only a guess so far.
        usual = [one for one in self.search.finalists if one.pays and one.drawn.worst <= bound.aim]
        nearest = min(usual, key=lambda one: one.drawn.worst, default=None)
        return None if nearest is None else nearest.plan

    def _hasty(self, finalist: Finalist) -> float:
        """What was measured, as it is thought to be at twice the speed."""
        plan = finalist.plan
        factor = plan.hasty_error / plan.error if plan.error > 0.0 else 1.0
        return factor * finalist.drawn.worst

    def _draw(self, plans: Sequence[Plan]) -> None:
        self.trials.tell(self.trials.budget.spent / self.trials.budget.seconds, "proof")
        setting = self.trials.setting
        run = whole_run(plans, setting.metric)
        passages = passages_of(setting.scene, self.seen, run.frames)
        each = [
            self.trials.draw(plans, replace(run, start=passage.start, step=passage.step))
            for passage in passages
        ]
        for plan, *drawn in zip(plans, *each, strict=True):
            pairs = tuple(zip(passages, drawn, strict=True))
            self.proven.append(Proven(plan, pairs))
            # What exceeded a bound would do so again, and what kept far from it need not.
            self.trials.correct_haste(plan, self.proven[-1].worst)

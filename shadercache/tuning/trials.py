"""Families drawn and fitted: what the search knows, and what it has drawn to know it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.diagnostics import DiagnosticError
from shadercache.measure.metrics.frame_errors import Metric
from shadercache.render.variant_runner import NEVER
from shadercache.scene.description import Scene
from shadercache.tuning.age_errors import straying_of
from shadercache.tuning.budget import Budget
from shadercache.tuning.families import Family, Plan
from shadercache.tuning.groups import ShaderGroup
from shadercache.tuning.laboratory import Drawn, Measures, Run
from shadercache.tuning.models import (
    HitModel,
    constant_time,
    fit_error,
    fit_hits,
    fit_time,
    time_of_hits,
    time_of_parts,
)
from shadercache.tuning.space import BASE_PERIOD, Space, of_one_image
from shadercache.tuning.static_times import StaticTimes, fit_static
from shadercache.tuning.time_lines import TimeLine
from shadercache.tuning.values import Value

AGES = (0, 1, 2, 3, 5, 8, 13)
"""Ages whose errors are looked at: those of one run that refreshes nothing."""

STRAYING = 6
"""The period at which it is looked how many payloads are refreshed by chance."""

OFTEN = 2
"""The period that is timed beside the one that refreshes nothing: misses in half of all pixels."""

FRAMES = 6
"""Of a run for times: hits and refreshes are spread evenly from the second frame on."""

IN_TURNS = 4
"""Families that take turns; more of them would drift apart in what they are compared with."""

USUAL_MU = 0.95
"""What is taken for mu where no hits could be counted."""

Point: TypeAlias = tuple[Family, int]
"""A family, and a period of it."""

Tell = Callable[[float, str], None]
"""Called with the share of the budget that is spent, and what is being done."""


@dataclass(frozen=True, slots=True)
class Failed:
    """What could not be drawn, and the diagnostic's words."""

    configuration: Configuration
    text: str
    why: str


@dataclass(frozen=True, slots=True)
class TrialSetting:
    """What all trials share. ``small``: is the small picture so much cheaper that errors are first
    looked at there?"""

    scene: Scene
    space: Space
    base: Configuration
    metric: Metric
    small: bool

    @property
    def look(self) -> Run:
        """A run for the errors of ages. Flicker follows from the RMSE of these."""
        metric: Metric = "flip" if self.metric == "flip" else "rmse"
        return Run(AGES[-1] + 1, AGES, metric, self.small)


@dataclass
class Trials:
    """The families of a scene. ``drawn``: every assignment there was; ``seen``: so many frames of
    the scene's path."""

    measures: Measures
    setting: TrialSetting
    budget: Budget
    tell: Tell
    families: list[Family] = field(default_factory=list)
    hits: dict[ShaderGroup, HitModel] = field(default_factory=dict)
    failed: list[Failed] = field(default_factory=list)
    drawn: set[Assignment] = field(default_factory=set)
    seen: int = 0
    _straying: dict[ShaderGroup, float] = field(default_factory=dict)
    _misses: dict[tuple[ShaderGroup, Configuration], TimeLine] = field(default_factory=dict)

    def first_of(self, group: ShaderGroup, value: Value) -> Family:
        """A family that a value is surveyed with; it is not drawn yet."""
        return Family(group, value, _with(self.setting.space.first(self.setting.base), value))

    def family(self, first: Family, kind: Configuration) -> Family:
        """A family of the same value with other choices; what is known of its error is taken on."""
        found = Family(first.group, first.value, _with(kind, first.value))
        found.haste, found.sure = first.haste, first.sure
        for known in self.families:
            same = known.group is first.group and known.value is first.value
            if same and known.error is not None and of_one_image(known.base, found.base):
                found.error, found.scale = known.error, known.scale
        return found

    def firsts(self, group: ShaderGroup) -> list[Family]:
        """One family of each value of a group that was drawn, by the first choices."""
        first = self.setting.space.first(self.setting.base)
        own = [family for family in self.families if family.group is group]
        return [family for family in own if family.kind == first]

    def static_times(self, group: ShaderGroup) -> StaticTimes | None:
        """What values of a group would take by the first choices that were not drawn."""
        firsts = [(one.value.share, one.time) for one in self.firsts(group) if one.time]
        return fit_static([share for share, _ in firsts], [time for _, time in firsts])

    def known(self, family: Family) -> bool:
        """Has the same been drawn, or tried?"""
        drawn = {(one.group, one.base) for one in self.families}
        failed = {one.configuration for one in self.failed}
        return (family.group, family.base) in drawn or family.base in failed

    def fit(self, families: Sequence[Family], until: float) -> bool:
        """Draw and fit families, if that is likely to end before a share of the budget is spent.

        False where it was not done. What the driver refuses or draws without numbers is kept among
        the ``failed``. ``families``: all at the full rate, or all at a fraction of it.
        """
        fresh = [family for family in families if family.error is None]
        time = self._timed(families, fresh)
        runs = [
            (self._look_run(families), len(fresh), len(fresh)),
            (Run(FRAMES), len(time), len(families) - len(fresh)),
        ]
        if not self.budget.fits(until, *(run for run in runs if run[1])):
            return False
        self.tell(self.budget.spent / self.budget.seconds, families[0].value.text)
        try:
            self._time(time, self._look(fresh))
        except DiagnosticError as error:
            if len(families) > 1:
                done = [self.fit([family], until) for family in families]
                return all(done)
            [family] = families
            self.failed.append(Failed(family.base, family.value.text, error.diagnostics[0].message))
            return True
        self.families += families
        return True

    def _look(self, families: Sequence[Family]) -> dict[Family, float]:
        """Errors by age, and hit rates. At full size these runs tell the time of hits as well,
        which is returned."""
        if not families:
            return {}
        # Hits are counted once for a group: they hardly depend on what is cached.
        run = replace(self._look_run(families), hits=families[0].group not in self.hits)
        results = self.draw([Plan(((family, NEVER),)) for family in families], run)
        for family, drawn in zip(families, results, strict=True):
            ages = dict(zip(AGES, drawn.errors, strict=True))
            family.learn_error(ages, self.setting.metric, self._straying_of(family, ages))
            if rates := drawn.hit_rates[1:]:
                self.hits[family.group] = fit_hits([NEVER] * len(rates), rates)
        shares = (drawn.share for drawn in results)
        return {} if run.small else dict(zip(families, shares, strict=True))

    def _straying_of(self, family: Family, ages: Mapping[int, float]) -> float:
        """How much is refreshed by chance, which goes by how fast the objects of a group move: one
        family is looked at."""
        if family.group not in self._straying:
            look = self._look_run([family])
            frames = 3 * STRAYING
            run = replace(look, frames=frames, compared=tuple(range(frames - STRAYING, frames)))
            [drawn] = self.draw([Plan(((family, STRAYING),))], run)
            found = straying_of(ages, STRAYING, drawn.worst, look.metric)
            self._straying[family.group] = found
        return self._straying[family.group]

    def _look_run(self, families: Sequence[Family]) -> Run:
        look = self.setting.look
        # A smaller picture is no measure of what fewer payloads do to this one.
        return replace(look, small=look.small and families[0].base.divisor == 1)

    def _timed(self, families: Sequence[Family], fresh: Sequence[Family]) -> list[Point]:
        """What is drawn for times alone: hits, where no look tells them, and misses, where they are
        not known of other values of the same kind. At a fraction of the rate misses depend on the
        value, and there are frames of nothing else."""
        looked = () if self._look_run(families).small else fresh
        hits = [(one, NEVER) for one in families if one not in looked]
        slow = [(one, 1) for one in families if one.base.divisor > 1]
        kinds: dict[Configuration, list[Family]] = {}
        for one in families:
            if one.base.divisor == 1 and self._misses_of(one).wants(one.value):
                kinds.setdefault(one.kind, []).append(one)
        # Those that save least and most tell how the time of misses goes with that of hits.
        ranked = (sorted(same, key=lambda one: one.value.share) for same in kinds.values())
        ends = (end for same in ranked for end in dict.fromkeys((same[0], same[-1])))
        return [*hits, *slow, *((one, OFTEN) for one in ends)]

    def _misses_of(self, family: Family) -> TimeLine:
        """The times of misses over those of hits, by the family's choices."""
        return self._misses.setdefault((family.group, family.kind), TimeLine(slope=0.0))

    def _time(self, points: Sequence[Point], hits: Mapping[Family, float]) -> None:
        """Times of hits and misses; ``hits``: those that are known."""
        plans = [Plan((point,)) for point in points]
        results = self.draw(plans, Run(FRAMES)) if plans else []
        shares: dict[Family, dict[int, float]] = {one: {NEVER: hits[one]} for one in hits}
        for (family, period), drawn in zip(points, results, strict=True):
            shares.setdefault(family, {})[period] = drawn.share
        # Those with two points first: the others take the time of misses from them.
        for family, own in sorted(shares.items(), key=lambda entry: -len(entry[1])):
            family.times |= own
            self._fit_time(family)

    def _fit_time(self, family: Family) -> None:
        mu, own, misses = self._mu(family.group), family.times, self._misses_of(family)
        if len(own) > 1:
            family.time = fit_time(list(own), list(own.values()), mu)
            misses.learn(family.value, family.time.hit.value, family.time.miss.value)
        else:
            # Nearly all is found where nothing is refreshed.
            hit = own[NEVER]
            family.time = time_of_hits(hit, NEVER, mu, misses.at(hit))

    def _mu(self, group: ShaderGroup) -> float:
        return self.hits[group].mu.value if group in self.hits else USUAL_MU

    def foretell(self, family: Family) -> bool:
        """Set the time of a family that was not drawn, from that of its value by the first choices
        and from what its own choices changed of other values; False where either is unknown."""
        firsts = {one.value: one.time.hit.value for one in self.firsts(family.group) if one.time}
        line = TimeLine(slope=1.0)
        for one in self.families:
            same = one.group is family.group and one.kind == family.kind
            if same and one.time is not None and one.value in firsts:
                line.learn(one.value, firsts[one.value], one.time.hit.value)
        if family.value not in firsts or not line.points:
            return False
        hit = line.at(firsts[family.value])
        family.time = time_of_parts(hit, self._misses_of(family).at(hit), self._mu(family.group))
        return True

    def correct(self, plan: Plan, drawn: Drawn) -> None:
        """Correct the errors of a plan's families, and the time of a single one, by what was found
        at full size."""
        if plan.without:
            return
        expected = plan.error  # of all parts together: each is scaled alike
        for family, period in plan.parts:
            if expected > 0.0:
                family.scale *= drawn.worst / expected
            elif drawn.worst > 0.0:
                # No age showed any error, so there is nothing to scale.
                family.error, family.scale = fit_error([period], [drawn.worst]), 1.0
            if family.base.refresh.adaptive:
                family.time = constant_time(drawn.share)
            elif len(plan.parts) == 1:
                family.times[period] = drawn.share
                self._fit_time(family)
            self._spread(family)

    def correct_haste(self, plan: Plan, worst: float) -> None:
        """The same by what was found at twice the speed."""
        if plan.without:
            return
        expected = plan.hasty_error
        for family, period in plan.parts:
            # Of several, each has its part in what was found.
            part = family.hasty_error_at(period) / expected if expected > 0.0 else 1.0
            family.correct_haste(period, part * worst)
            # How a value changes with speed is much the same however it is stored.
            for one in self.families:
                if one.group is family.group and one.value is family.value:
                    one.haste, one.sure = family.haste, True

    def _spread(self, known: Family) -> None:
        """What is known of a family's error is known of all that draw the same images."""
        for family in self.families:
            same = family.group is known.group and family.value is known.value
            if same and of_one_image(known.base, family.base):
                family.error, family.scale = known.error, known.scale

    def draw(self, plans: Sequence[Plan], run: Run) -> list[Drawn]:
        """Draw plans in turns; how long that takes is noted. Raises as ``Laboratory.draw``."""
        assignments = [plan.assignment(self.setting.scene) for plan in plans]
        seen = {_programs(one) for one in self.drawn}
        fresh = len({_programs(one) for one in assignments} - seen)
        began = self.budget.now()
        results = self.measures.draw(assignments, run)
        self.budget.note(run, len(plans), self.budget.now() - began, fresh)
        self.drawn |= set(assignments)
        self.seen = max(self.seen, run.start + run.step * run.frames)
        return results


def _programs(assignment: Assignment) -> frozenset[str]:
    """What names the programs of an assignment."""
    chosen = (one for _, one in assignment.objects if one is not None)
    return frozenset(one.program_key for one in chosen)


def _with(kind: Configuration, value: Value) -> Configuration:
    return replace(kind.with_refresh(BASE_PERIOD), nodes=value.ids)

"""The search: a survey of values, then of choices for the best, then a front at full size.

Successive halving: each stage draws fewer things more closely. What was drawn before tells what
comes next, by its models.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, islice, product

from shadercache.caching.configuration import Configuration
from shadercache.measure.metrics.frame_errors import Metric
from shadercache.tuning.bound import Bound
from shadercache.tuning.families import Family, Plan
from shadercache.tuning.groups import ShaderGroup
from shadercache.tuning.laboratory import Drawn, Run
from shadercache.tuning.trials import IN_TURNS, Trials
from shadercache.tuning.values import Pool, Value, sets_of

SURVEY, REFINE, FINAL = 0.25, 0.5, 0.72
"""Shares of the budget by which each stage ends; the rest is for the proof."""

PROMISING = 3
"""Values of a group that are tried with other choices, for each bound."""

HELPFUL = 4
"""Choices that are tried with more than one value."""

MOST_ALIKE = 6
"""Values that are tried since they are like the best."""

FORETOLD = 2
"""Values with choices that were tried with other values, for each bound."""

FINALISTS = 3
"""Plans that are drawn at full size, for each bound."""

LEAST_FRAMES = 24
COMPARED = 12
"""Of a run at full size the last frames are compared, when payloads are as old as they get."""

MOST_OBJECTS = 6
"""Of at most so many objects each is once left to its original."""

OPTIONS = 8
"""Of a group so many points of its front are combined with those of other groups."""


@dataclass(frozen=True)
class Finalist:
    """A plan that was drawn at full size."""

    plan: Plan
    drawn: Drawn

    @property
    def pays(self) -> bool:
        """Is it surely faster than the original?"""
        return self.drawn.speedup.low > 1.0


class Search:
    """Looks for the fastest plan within each bound."""

    def __init__(
        self, trials: Trials, pools: Mapping[ShaderGroup, Pool], bounds: Sequence[Bound]
    ) -> None:
        self.trials, self.pools, self.bounds = trials, pools, tuple(bounds)
        self.finalists: list[Finalist] = []
        self.untried = {group: list(pool.values) for group, pool in pools.items()}
        self._periods = trials.setting.space.periods

    def run(self) -> list[Finalist]:
        """All stages; what there is no time for is left out, and ``untried`` has the values."""
        self.survey()
        self.refine()
        # Twice: what the first round finds at full size corrects what the second one chooses.
        for _ in range(2):
            self.finish()
        return self.finalists

    def survey(self) -> None:
        """Every value with the first choices, until a share of the budget is spent."""
        left = self.untried
        while any(left.values()):
            # A batch of each group in turns, the best first.
            for group, values in left.items():
                # The first is drawn in any case: without it there is nothing to say.
                turns = IN_TURNS if self.trials.families else 1
                until = SURVEY if self.trials.families else 1.0
                batch = [self.trials.first_of(group, value) for value in values[:turns]]
                if batch and not self.trials.fit(batch, until):
                    return
                left[group] = self._worth(group, values[turns:])

    def _worth(self, group: ShaderGroup, values: Sequence[Value]) -> list[Value]:
        """Those that would be faster than the original, by what others took."""
        known = self.trials.static_times(group)
        longest = self._periods[-1]
        return [
            value
            for value in values
            if known is None or known.at(value.share, longest) < 1.0 + known.residual
        ]

    def refine(self) -> None:
        """Other choices, for the values that promise most; sets; what is like the best; and last
        what makes the best choice a little better."""
        for group, pool in self.pools.items():
            promising = self._promising(group)
            if not promising:
                continue
            best, *others = promising
            # What would save most may keep a bound at a fraction of the rate, and what errs least
            # may be faster by another algorithm.
            firsts = self.trials.firsts(group)
            dearest = min(firsts, key=lambda one: one.share(self._periods[-1]))
            for lead in dict.fromkeys((best, dearest, self._nearest(firsts))):
                self._fit(self._main(lead))
                self._fit(self._across(lead, self._helpful(lead)))
            kinds = self._helpful(best)
            self._fit(self.trials.family(other, kind) for kind in kinds for other in others)
            self._fit(self._foretold(group))
            self._fit(self._sets(group, pool))
            self._fit(self._like(group, pool))
            self._fit(self._minor(group))

    def finish(self) -> None:
        """Draw the plans that promise most at full size, and correct the models by that."""
        drawn = {one.plan.key for one in self.finalists}
        wanted: dict[object, Plan] = {}
        for bound in self.bounds:
            fresh = [one for one in self.plans(bound.aim) if one.key not in drawn][:FINALISTS]
            more = (*self._by_object(bound), *self._adapting(bound))
            wanted |= {plan.key: plan for plan in (*fresh, *more)}
        plans = list(wanted.values())
        while plans and not self.trials.budget.fits(FINAL, (self._whole(plans), len(plans), 0)):
            plans.pop()
        if not plans:
            return
        spent = self.trials.budget.spent / self.trials.budget.seconds
        self.trials.tell(spent, f"{len(plans)} at full size")
        for plan, result in zip(plans, self.trials.draw(plans, self._whole(plans)), strict=True):
            self.finalists.append(Finalist(plan, result))
            self.trials.correct(plan, result)

    def _fastest(self, bound: Bound) -> Plan | None:
        """What was fastest at full size, within a bound."""
        pays = [one for one in self.finalists if one.pays and one.drawn.worst <= bound.aim]
        best = max(pays, key=lambda one: one.drawn.speedup.median, default=None)
        return None if best is None else best.plan

    def _by_object(self, bound: Bound) -> Iterator[Plan]:
        """The fastest without one of its objects: some may cost more than they save."""
        best = self._fastest(bound)
        if best is None or best.without:
            return
        names = [name for family, _ in best.parts for name in family.group.objects]
        if 1 < len(names) <= MOST_OBJECTS:
            yield from (replace(best, without=(name,)) for name in names)

    def _adapting(self, bound: Bound) -> Iterator[Plan]:
        """What was fastest at full size, refreshed where it changes. No run that refreshes nothing
        tells the error of that, so it is drawn as it is."""
        best = self._fastest(bound)
        if best is None or len(best.parts) > 1:
            return
        [(family, _)] = best.parts
        if family.base.refresh.adaptive:
            return
        for kind in self.trials.setting.space.adapting(family.base):
            adaptive = self.trials.family(family, kind)
            if not self.trials.known(adaptive):
                adaptive.time, adaptive.error = family.time, family.error
                self.trials.families.append(adaptive)
                yield Plan(((adaptive, self._periods[-1]),))

    def _whole(self, plans: Sequence[Plan]) -> Run:
        return whole_run(plans, self.trials.setting.metric)

    def plans(self, limit: float) -> list[Plan]:
        """Those whose predicted error is within a limit at twice the speed too, the fastest
        first."""
        fronts = [[None, *self._front(group, limit)] for group in self.pools]
        plans = (Plan(tuple(part for part in parts if part)) for parts in product(*fronts))
        fitting = [
            plan for plan in plans if plan.parts and plan.hasty_error <= limit and _fits(plan)
        ]
        return sorted(fitting, key=lambda plan: plan.share)

    def _front(self, group: ShaderGroup, limit: float) -> list[tuple[Family, int]]:
        """The longest period of each family within the limit; for several groups shorter ones
        too, since they share it."""
        found: list[tuple[Family, int]] = []
        for part in (1.0, 0.6) if len(self.pools) > 1 else (1.0,):
            for family in self.trials.families:
                period = family.longest(part * limit, self._periods)
                if family.group is group and period is not None and family.share(period) < 1.0:
                    found.append((family, period))
        ranked = sorted(dict.fromkeys(found), key=lambda one: one[0].share(one[1]))
        return ranked[: OPTIONS if len(self.pools) > 1 else None]

    def _promising(self, group: ShaderGroup) -> list[Family]:
        """First families of the values that are fastest within any bound, the best first."""
        found: dict[Value, Family] = {}
        firsts = self.trials.firsts(group)
        for bound in self.bounds:
            ranked = sorted(firsts, key=lambda one: self._best_share(one, bound))
            # What is nearest to a bound that none reaches may reach it with other choices.
            near = [self._nearest(firsts)] if firsts else []
            for family in (*ranked[:PROMISING], *near):
                found.setdefault(family.value, family)
        return list(found.values())

    def _nearest(self, families: Sequence[Family]) -> Family:
        """What errs least."""
        return min(families, key=lambda one: one.error_at(self._periods[0]))

    def _best_share(self, family: Family, bound: Bound) -> float:
        period = family.longest(bound.aim, self._periods)
        return 1.0 if period is None else family.share(period)

    def _main(self, first: Family) -> Iterator[Family]:
        kinds = self.trials.setting.space.main(first.base, not first.value.changes)
        return (self.trials.family(first, kind) for kind in kinds)

    def _like(self, group: ShaderGroup, pool: Pool) -> Iterator[Family]:
        """Values that share most of the work of those that are best so far, by their choices: what
        saves a little less may err less, too."""
        found = (
            self.trials.family(self.trials.first_of(group, value), family.base)
            for family in self._leading(group)
            for value in pool.alike.get(family.value, ())[:IN_TURNS]
        )
        return islice(found, MOST_ALIKE)

    def _minor(self, group: ShaderGroup) -> Iterator[Family]:
        for family in self._leading(group):
            kinds = self.trials.setting.space.minor(family.base)
            yield from (self.trials.family(family, kind) for kind in kinds)

    def _leading(self, group: ShaderGroup) -> list[Family]:
        """The group's families of the plans that are fastest within each bound."""
        best = [plan for bound in self.bounds for plan in self.plans(bound.aim)[:1]]
        parts = (family for plan in best for family, _ in plan.parts)
        return list(dict.fromkeys(family for family in parts if family.group is group))

    def _helpful(self, best: Family) -> list[Configuration]:
        """The choices that make the best value faster within any bound, those that do so most
        first."""
        same = [one for one in self.trials.families if one.value is best.value]
        found: dict[Configuration, None] = {}
        for bound in self.bounds:
            least = self._best_share(best, bound)
            better = [one for one in same if self._best_share(one, bound) < least]
            for one in sorted(better, key=lambda one: self._best_share(one, bound)):
                found.setdefault(one.base)
        return list(found)[:HELPFUL]

    def _foretold(self, group: ShaderGroup) -> Iterator[Family]:
        """Values by choices that were tried with others, where that is likely to be faster within a
        bound than all that was drawn."""
        kinds = dict.fromkeys(one.kind for one in self.trials.families if one.group is group)
        options = [
            self.trials.family(first, kind) for first in self.trials.firsts(group) for kind in kinds
        ]
        options = [
            one for one in options if not self.trials.known(one) and self.trials.foretell(one)
        ]
        drawn = [one for one in self.trials.families if one.group is group]
        for bound in self.bounds:
            best = min(self._best_share(one, bound) for one in drawn)
            ranked = sorted(options, key=lambda one: self._best_share(one, bound))
            yield from (one for one in ranked[:FORETOLD] if self._best_share(one, bound) < best)

    def _across(self, best: Family, kinds: Sequence[Configuration]) -> Iterator[Family]:
        """Two helpful choices together: each of a slot with each algorithm."""
        algorithms = [kind.algorithm for kind in kinds if kind.algorithm != best.base.algorithm]
        slots = [kind for kind in kinds if kind.algorithm == best.base.algorithm]
        for kind in slots:
            for name in dict.fromkeys(algorithms):
                yield self.trials.family(best, replace(kind, algorithm=name))

    def _sets(self, group: ShaderGroup, pool: Pool) -> Iterator[Family]:
        values = sets_of(pool, group.analysis)
        return (self.trials.first_of(group, value) for value in values)

    def _fit(self, families: Iterable[Family]) -> None:
        fresh = [family for family in families if not self.trials.known(family)]
        for batch in _batches(fresh):
            if not self.trials.fit(batch, REFINE):
                return


def whole_run(plans: Sequence[Plan], metric: Metric) -> Run:
    """A run at full size that is longer than any payload gets old."""
    oldest = max(period for plan in plans for _, period in plan.parts)
    frames = max(LEAST_FRAMES, oldest + COMPARED // 2)
    return Run(frames, tuple(range(frames - COMPARED, frames)), metric)


def _batches(families: Sequence[Family]) -> Iterator[list[Family]]:
    """A few at a time, those at a fraction of the rate apart."""
    for _, same in groupby(families, key=lambda family: family.base.divisor > 1):
        several = list(same)
        for at in range(0, len(several), IN_TURNS):
            yield several[at : at + IN_TURNS]


def _fits(plan: Plan) -> bool:
    """Can its groups share a cache? They do where all but nodes and refresh is alike."""
    kinds = {(one.algorithm, one.look_up, one.storage.format) for _, one in plan.configurations}
    return len(kinds) < 2

"""What may be looked at of a tuning: what was drawn, and the front that its models foretell."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import log

from shadercache.caching.configuration import Assignment
from shadercache.scene.description import Scene
from shadercache.tuning.choose import Tuning
from shadercache.tuning.families import Family, Plan


def predicted_front(families: Iterable[Family], periods: Sequence[int]) -> list[Plan]:
    """The plans that no other is predicted to be as fast and as near as at twice the speed, by
    falling time, so with growing error; groups are combined where they can share a cache."""
    known = [family for family in families if family.time and family.error]
    found: list[Plan] = []
    for kind in dict.fromkeys(map(_kind, known)):
        same = [family for family in known if _kind(family) == kind]
        plans = [Plan(())]
        for group in dict.fromkeys(family.group for family in same):
            own = [
                Plan(((family, period),))
                for family in same
                if family.group is group
                for period in _tried(family, periods)
            ]
            added = [Plan(plan.parts + one.parts) for one in _best(own) for plan in plans]
            plans = _best([*plans, *added])
        found += plans
    return [plan for plan in _best(found) if plan.parts and plan.share < 1.0]


def worth_a_look(tuning: Tuning, scene: Scene) -> list[tuple[list[list[int]], Assignment]]:
    """Plans as numbers of families with periods, each with what draws it: what is proven, what was
    drawn at full length, then the predicted front: first what has other families than those before
    it, and of both what is nearest to a bound."""
    drawings, question = tuning.drawings, tuning.question
    trials = drawings.trials
    numbers = {id(family): number for number, family in enumerate(trials.families)}
    limits = [bound.error for bound in question.bounds]
    drawn = [*(one.plan for one in tuning.proven), *(one.plan for one in drawings.finalists)]
    front = sorted(
        predicted_front(trials.families, question.space.periods),
        key=lambda plan: min(_apart(plan.hasty_error, one) for one in limits),
    )
    # The same with another period looks much alike.
    kinds: dict[frozenset[int], Plan] = {}
    for plan in (*drawn, *front):
        kinds.setdefault(frozenset(id(family) for family, _ in plan.parts), plan)
    plans: dict[object, Plan] = {}
    for plan in (*drawn, *kinds.values(), *front):
        plans.setdefault(plan.key, plan)
    return [
        ([[numbers[id(family)], period] for family, period in plan.parts], plan.assignment(scene))
        for plan in plans.values()
    ]


def _apart(error: float, limit: float) -> float:
    """How many times one is the other, as a logarithm."""
    return abs(log(max(error, 1e-9) / limit))


def _tried(family: Family, periods: Sequence[int]) -> Sequence[int]:
    """The periods of which the models know something, as ``Family.longest`` has them."""
    some = (1, *periods) if family.base.divisor > 1 else periods
    return some[-1:] if family.base.refresh.adaptive else some


def _kind(family: Family) -> tuple[object, ...]:
    base = family.base
    return base.algorithm, base.look_up, base.storage.format


def _best(plans: Iterable[Plan]) -> list[Plan]:
    found: list[Plan] = []
    for plan in sorted(plans, key=lambda one: (one.hasty_error, one.share)):
        if not found or plan.share < found[-1].share:
            found.append(plan)
    return found

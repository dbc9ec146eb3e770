"""The search and its proof on a laboratory whose truth is known."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from shadercache.caching.configuration import Configuration
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import Budget
from shadercache.tuning.groups import ShaderGroup, groups_of
from shadercache.tuning.proof import Proof, Proven
from shadercache.tuning.search import Search
from shadercache.tuning.space import Space
from shadercache.tuning.trials import Trials, TrialSetting
from shadercache.tuning.values import Pool, pool_of
from tests.tuning.physics import Computed, Physics

SPACE = Space(
    algorithms=("2-pass", "parked", "3-pass"), filters=("bilateral", "carried"), blocks=(4,),
    formats=("rgba16f",), adaptive=(),
)  # fmt: skip
BOUNDS = (0.002, 0.006, 0.02)


@pytest.fixture(scope="module")
def linker() -> Linker:
    path = data_path("corpus", "dragon", "scene.toml")
    return Linker(*open_scene(Path(path)))


@pytest.fixture(scope="module")
def pools(linker: Linker) -> dict[ShaderGroup, Pool]:
    return {group: pool_of(group, linker.scene) for group in groups_of(linker)}


def truth(pools: dict[ShaderGroup, Pool]) -> dict[str, Physics]:
    """The static share is right but for a tenth; errors come in all sizes."""
    values = [one for pool in pools.values() for one in pool.values]
    alike = [one for pool in pools.values() for same in pool.alike.values() for one in same]
    return {
        value.ids[0]: Physics(
            value.share * (1.0 - 0.1 * (number % 2)),
            0.03 / (1 + number % 5),
            0.02 * (1 + number % 3),
        )
        for number, value in enumerate([*values, *alike])
    }


def searched(
    linker: Linker, pools: dict[ShaderGroup, Pool], world: Computed, seconds: float = 150.0
) -> Search:
    setting = TrialSetting(linker.scene, SPACE, Configuration(), "rmse", False)
    budget = Budget(seconds, world.clock)
    trials = Trials(world, setting, budget, lambda spent, what: None)
    return Search(trials, pools, [Bound("rmse", limit) for limit in BOUNDS])


def grid(pools: dict[ShaderGroup, Pool]) -> Iterator[Configuration]:
    for pool in pools.values():
        for value in pool.values:
            first = replace(SPACE.first(Configuration()), nodes=value.ids)
            for kind in (first, *SPACE.main(first, True)):
                for period in SPACE.periods:
                    yield kind.with_refresh(period)


@pytest.mark.parametrize("late", [(), ("2-pass",)])
def test_the_choice_is_near_the_best_of_all_and_holds(
    linker: Linker, pools: dict[ShaderGroup, Pool], late: tuple[str, ...]
) -> None:
    world = Computed(truth(pools), late=late)
    search = searched(linker, pools, world)
    search.run()
    chosen = Proof(search).run()
    every = list(grid(pools))
    for bound, proven in chosen.items():
        fitting = [one for one in every if world.error_of_period(one, 2) <= bound.aim]
        best = min(map(world.share, fitting))
        if best >= 1.0:
            assert proven is None
            continue
        assert proven is not None and proven.holds(bound)
        assert 1.0 / proven.speedup.median <= 1.05 * best
    assert len(search.trials.drawn) < 0.2 * len(every)
    assert world.now <= 1.1 * search.trials.budget.seconds


def test_the_error_decides_and_not_only_the_time(
    linker: Linker, pools: dict[ShaderGroup, Pool]
) -> None:
    """With every error ten times as large, what was chosen no longer is."""
    gains = []
    for factor in (1.0, 10.0):
        known = {k: replace(v, alpha=factor * v.alpha) for k, v in truth(pools).items()}
        search = searched(linker, pools, Computed(known))
        search.run()
        chosen = Proof(search).run()
        gains.append([one.speedup.median if one else 1.0 for one in chosen.values()])
    assert gains[1][0] < gains[0][0] and gains[1][1] < gains[0][1]


def test_noise_of_times_costs_little(linker: Linker, pools: dict[ShaderGroup, Pool]) -> None:
    world = Computed(truth(pools), noise=0.03)
    search = searched(linker, pools, world)
    search.run()
    every = list(grid(pools))
    for bound, proven in Proof(search).run().items():
        fitting = [one for one in every if world.error_of_period(one, 2) <= bound.aim]
        best = min(map(world.share, fitting))
        if proven is not None:
            [(family, period)] = proven.plan.parts
            assert world.share(family.at(period)) <= 1.12 * best


def test_nothing_slower_is_chosen(linker: Linker, pools: dict[ShaderGroup, Pool]) -> None:
    slow = {name: replace(one, saved=0.01) for name, one in truth(pools).items()}
    search = searched(linker, pools, Computed(slow))
    search.run()
    assert set(Proof(search).run().values()) == {None}


def test_what_fails_in_haste_is_not_chosen(linker: Linker, pools: dict[ShaderGroup, Pool]) -> None:
    """Twice as fast the error is five times as large, which nobody could foretell."""
    world = Computed(truth(pools), haste=5.0)
    search = searched(linker, pools, world, 300.0)
    search.run()
    chosen = Proof(search).run()
    held = [one for one in chosen.values() if one is not None]
    assert held
    for bound, proven in chosen.items():
        assert proven is None or proven.worst <= bound.aim < bound.error


def test_a_short_budget_still_ends_in_time(linker: Linker, pools: dict[ShaderGroup, Pool]) -> None:
    for seconds in (25.0, 40.0, 60.0):
        world = Computed(truth(pools))
        search = searched(linker, pools, world, seconds)
        search.run()
        Proof(search).run()
        assert world.now <= 1.1 * seconds


def test_what_the_driver_refuses_is_kept_and_the_rest_goes_on(
    linker: Linker, pools: dict[ShaderGroup, Pool]
) -> None:
    from shadercache.diagnostics import input_error

    class Refusing(Computed):
        def draw(self, assignments, run):  # type: ignore[no-untyped-def]
            for assignment in assignments:
                for _, one in assignment.objects:
                    if one is not None and one.nodes == refused:
                        raise input_error("SC602", "the driver says: no")
            return super().draw(assignments, run)

    [pool] = pools.values()
    refused = pool.values[0].ids
    search = searched(linker, pools, Refusing(truth(pools)))
    search.run()
    chosen = [one for one in Proof(search).run().values() if one is not None]
    assert [failed.why for failed in search.trials.failed][:1] == ["the driver says: no"]
    assert chosen and all(_nodes(one) != refused for one in chosen)


def _nodes(proven: Proven) -> tuple[str, ...]:
    [(family, _)] = proven.plan.parts
    return family.base.nodes


@pytest.mark.parametrize("late", [(), ("2-pass",)])
def test_misses_are_timed_as_they_depend_on_the_value(
    linker: Linker, pools: dict[ShaderGroup, Pool], late: tuple[str, ...]
) -> None:
    world = Computed(truth(pools), late=late)
    search = searched(linker, pools, world)
    search.survey()
    surveyed = search.trials.families
    assert len({family.value for family in surveyed}) > 3
    for family in surveyed:
        assert family.share(3) == pytest.approx(world.share(family.at(3)), rel=0.05)

"""The checks of ``tune`` on a grid whose truth is known."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bench.tuning import chosen, grid, held_out
from shadercache.measure.result_files import plain
from tests.tuning.physics import Computed, Physics


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The dragon's grid, as a laboratory without noise would draw it."""
    whole = grid.Grid.of("dragon")
    world = Computed(
        {
            value.ids[0]: Physics(value.share, 0.03 / (1 + number % 4), 0.03 * (1 + number % 3))
            for number, value in enumerate(whole.values)
        },
    )
    rows = [grid.draw(whole, world, family) for family in whole.families]  # type: ignore[arg-type]
    for row in rows:
        grid.hasten(whole, world, row)  # type: ignore[arg-type]
    rows[1] = {"configuration": rows[1]["configuration"], "why": "the driver says: no"}
    path = tmp_path_factory.mktemp("grid") / "grid-dragon.json"
    path.write_text(json.dumps(plain({"size": 8, "families": rows})), encoding="utf-8")
    return path


def test_a_grid_has_every_value_with_every_choice() -> None:
    whole = grid.Grid.of("dragon")
    families = list(whole.families)
    assert len(families) == len(set(families)) == 7 * len(whole.values)
    assert {one.nodes for one in families} == {value.ids for value in whole.values}
    assert sum(len(grid.periods_of(one)) for one in families) <= 2000


def test_choices_are_near_the_best_and_few_are_asked_for(report: Path) -> None:
    rows, failed = chosen._compared("dragon", report)
    assert [row[1] for row in rows] == ["0.0025", "0.005", "0.01", "0.02"]
    assert not failed, rows


def test_a_worse_choice_is_told(report: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chosen.Proof, "run", lambda self: dict.fromkeys(self.bounds))
    _, failed = chosen._compared("dragon", report)
    assert failed


def test_models_are_compared_with_periods_that_they_have_not_seen(report: Path) -> None:
    rows = list(held_out._rows("dragon", json.loads(report.read_text(encoding="utf-8"))))
    periods = {one.configuration.refresh.period for one in rows}
    assert 32 in periods and 3 in periods
    full = [one for one in rows if one.configuration.divisor == 1]
    assert not {2} & {one.configuration.refresh.period for one in full}
    assert held_out._quantile(full, "time", 1.0) < 0.02
    # Of exponential errors by age; those by period are no exponential, and are gone on with here.
    assert held_out._quantile(full, "error", 0.5) < 0.05

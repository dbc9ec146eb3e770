"""The search's choices beside the best of a whole grid that was drawn before (``grid``).

``python -m bench.tuning.chosen [SCENE...]`` needs no OpenGL: what the search asks to be drawn is
looked up in the grid's file. Exit status 1 where a choice takes over 5 % longer than the best, or
more than 5 % of the grid was asked for.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bench.tuning.grid import RESULTS, SCENES, SPACE, Grid
from shadercache.caching.configuration import Assignment, Configuration
from shadercache.cli.tables import format_table
from shadercache.diagnostics import input_error
from shadercache.measure.statistics import Ratio
from shadercache.render.variant_runner import NEVER
from shadercache.tuning.bound import Bound
from shadercache.tuning.budget import Budget
from shadercache.tuning.laboratory import Drawn, Run
from shadercache.tuning.proof import Proof
from shadercache.tuning.search import Search
from shadercache.tuning.trials import AGES, Trials, TrialSetting

BOUNDS = (0.0025, 0.005, 0.01, 0.02)
CLOSE, FEW = 1.05, 0.05
SECONDS = 1e6
"""A table takes no time, so the budget never ends the search; how much it asks for is counted."""


@dataclass
class Recorded:
    """Answers from a grid's file. ``asked``: the configurations that were looked up."""

    rows: dict[Configuration, dict[str, Any]]
    asked: set[Configuration] = field(default_factory=set)

    def draw(self, assignments: Sequence[Assignment], run: Run) -> list[Drawn]:
        """What was drawn of them, at the usual speed and at twice that."""
        return [self._drawn(_of(one), run) for one in assignments]

    def _drawn(self, chosen: Configuration, run: Run) -> Drawn:
        row = self.rows.get(chosen.with_refresh(1), {"why": "the grid has no such configuration"})
        self.asked.add(chosen)
        if "why" in row:
            raise input_error("SC602", row["why"])
        period = chosen.refresh.period
        if period == NEVER:
            errors = tuple(row["never"]["errors"]) if run.compared == AGES else ()
            hits = (1.0, *row["hits"][: len(AGES) - 1]) if run.hits else ()
            share = row["never"]["share"]
            return Drawn(_ratio(share, share, share), errors, hits, row["original"])
        one = row["periods"][str(period)]
        ratio = _ratio(one["share"], one["low"], one["high"])
        # What was not drawn at twice the speed is no choice at the usual one.
        error = one["worst"] if run.step == 1 else one.get("hasty", one["worst"])
        return Drawn(ratio, (error,) * len(run.compared), (), row["original"])


def _ratio(share: float, low: float, high: float) -> Ratio:
    return Ratio(1.0 / share, 1.0 / high, 1.0 / low, 1.0 / share)


def _of(assignment: Assignment) -> Configuration:
    [chosen] = {one for _, one in assignment.objects if one is not None}
    return chosen


def main() -> None:
    """Print a row for each scene and bound."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--machine", default="llvmpipe-2-cores")
    asked = parser.parse_args()
    rows, failed = [], False
    for name in asked.scenes:
        path = RESULTS / asked.machine / "tuning" / f"grid-{name}.json"
        if path.is_file():
            found, fails = _compared(name, path)
            rows += found
            failed |= fails
    print(format_table(("scene", "bound", "best", "chosen", "over", "asked", "of"), rows))
    raise SystemExit(1 if failed else 0)


def _compared(name: str, path: Path) -> tuple[list[tuple[str, ...]], bool]:
    report = json.loads(path.read_text(encoding="utf-8"))
    read = ((Configuration.from_json(row["configuration"]), row) for row in report["families"])
    recorded = Recorded({chosen.with_refresh(1): row for chosen, row in read})
    whole = {
        family.with_refresh(int(period)): one
        for family, row in recorded.rows.items()
        for period, one in row.get("periods", {}).items()
    }
    grid = Grid.of(name)
    setting = TrialSetting(grid.linker.scene, SPACE, grid.base, "rmse", False)
    trials = Trials(recorded, setting, Budget(SECONDS), lambda spent, what: None)
    search = Search(trials, {grid.group: grid.pool}, [Bound("rmse", limit) for limit in BOUNDS])
    search.run()
    rows: list[tuple[str, ...]] = []
    failed = False
    for bound, proven in Proof(search).run().items():
        fitting = [one["share"] for one in whole.values() if _largest(one) <= bound.aim]
        best = min([1.0, *fitting])
        got = 1.0 if proven is None else 1.0 / proven.speedup.median
        share = len(recorded.asked) / len(whole)
        failed |= got > CLOSE * best or share > FEW
        figures = (f"{best:.3f}", f"{got:.3f}", f"{got / best - 1.0:.1%}", f"{share:.1%}")
        rows.append((name, f"{bound.limit:g}", *figures, f"{len(whole):,}"))
    return rows, failed


def _largest(one: dict[str, float]) -> float:
    """The error at the usual speed or at twice that, where it is larger."""
    return max(one["worst"], one.get("hasty", 0.0))


if __name__ == "__main__":
    main()

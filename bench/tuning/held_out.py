"""The models of time and error at periods that they were not fitted to.

``python -m bench.tuning.held_out [SCENE...]`` reads the grids that ``bench.tuning.grid`` has drawn:
of each family the time is fitted to two periods and the error to ages of up to 13 frames, as
``tune`` does it, and both are compared with what was drawn at the other periods. It needs no
OpenGL.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from bench.tuning.grid import RESULTS, Grid
from shadercache.caching.configuration import Configuration
from shadercache.cli.tables import format_table, shorten
from shadercache.render.variant_runner import NEVER
from shadercache.tuning.age_errors import straying_of
from shadercache.tuning.families import Family
from shadercache.tuning.models import fit_hits, fit_time
from shadercache.tuning.result import told
from shadercache.tuning.trials import AGES, OFTEN, STRAYING

WHAT = ("time", "error")
WORST = 10
"""Rows that are listed."""


@dataclass(frozen=True, slots=True)
class Off:
    """How far a prediction was off, as a share of what was drawn."""

    scene: str
    value: str
    configuration: Configuration
    time: float
    error: float
    follows: bool


def main() -> None:
    """Print medians, and the predictions that are farthest off."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=["dragon", "trashcan"])
    parser.add_argument("--machine", default="llvmpipe-2-cores")
    asked = parser.parse_args()
    for name in asked.scenes:
        path = RESULTS / asked.machine / "tuning" / f"grid-{name}.json"
        rows = list(_rows(name, json.loads(path.read_text(encoding="utf-8"))))
        middle = [f"{_quantile(rows, what, 0.5):.1%} in {what}" for what in WHAT]
        high = [f"{_quantile(rows, what, 0.9):.1%} in {what}" for what in WHAT]
        print(f"{name}: {len(rows)} predictions; off in the median by {' and '.join(middle)}")
        print(f"one in ten is off by more than {' or '.join(high)}")
        families = {(one.value, one.configuration.with_refresh(1)): one.follows for one in rows}
        print(f"{sum(families.values())} of {len(families)} errors follow the model")
        for what in WHAT:
            ranked = sorted(rows, key=lambda one: -getattr(one, what))[:WORST]
            lines = [
                (f"{getattr(one, what):.0%}", told(one.configuration), one.value) for one in ranked
            ]
            print(format_table((f"{what} off by", "configuration", "value"), lines))


def _quantile(rows: list[Off], what: str, part: float) -> float:
    return float(np.quantile([getattr(one, what) for one in rows], part))


def _rows(name: str, report: dict[str, Any]) -> Iterator[Off]:
    grid = Grid.of(name)
    values = {value.ids: value for value in grid.values}
    straying: float | None = None
    for row in report["families"]:
        if "why" in row:
            continue
        base = Configuration.from_json(row["configuration"])
        ages = dict(zip(AGES, row["never"]["errors"], strict=True))
        # As in a search: of the first value for all.
        if straying is None:
            worst = row["periods"][str(STRAYING)]["worst"]
            straying = straying_of(ages, STRAYING, worst, "rmse")
        family = Family(grid.group, values[base.nodes], base)
        family.learn_error(ages, "rmse", straying)
        yield from _of_family(name, family, row)


def _of_family(name: str, family: Family, row: dict[str, Any]) -> Iterator[Off]:
    base, value = family.base, family.value
    hits = row["hits"] if base.divisor == 1 else [1.0]
    mu = fit_hits([NEVER] * len(hits), hits).mu.value
    first = 1 if base.divisor > 1 else OFTEN
    known = {first: row["periods"][str(first)]["share"], NEVER: row["never"]["share"]}
    time = fit_time(list(known), list(known.values()), mu)
    assert family.error is not None
    for text, drawn in row["periods"].items():
        period = int(text)
        if period in known:
            continue
        predicted = family.error_at(period)
        yield Off(
            name,
            shorten(value.text, 40),
            base.with_refresh(period),
            abs(time.at(period) / drawn["share"] - 1.0),
            abs(predicted / drawn["worst"] - 1.0) if drawn["worst"] > 0.0 else float(predicted > 0),
            family.error.follows,
        )


if __name__ == "__main__":
    main()

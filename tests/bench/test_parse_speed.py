"""``./dev bench-parse``: what it makes of the times it took."""

from __future__ import annotations

from typing import Any

import pytest

from bench.parse_speed import made_file, targets, time_in_turns
from bench.speed import targets_table


def _row(size: int, **seconds: float | None) -> dict[str, Any]:
    samples = {name: None if value is None else [value] for name, value in seconds.items()}
    return {"file": "x", "bytes": size, "seconds": samples}


@pytest.mark.parametrize(
    ("crosstl", "typed", "largest", "met"),
    [
        (0.25, 0.15, 15.0, [True, True, True, True]),
        (0.19, 0.15, 15.0, [False, True, True, True]),
        (0.25, 0.21, 15.0, [True, False, True, False]),
        (0.25, 0.15, 16.0, [True, True, False, True]),
        (None, 0.15, 15.0, [None, True, True, True]),
    ],
)
def test_targets(crosstl: float | None, typed: float, largest: float, met: list[bool]) -> None:
    compared = [
        _row(35_000, parse=0.1, typed=typed, crosstl=crosstl),
        _row(70_000, parse=0.1, typed=typed, crosstl=None),
    ]
    grown = [_row(10_000, typed=0.1), _row(1_000_000, typed=largest)]
    started = {"load the saved grammar": [0.01], "check tiny.frag": [0.5]}
    found = targets(compared, grown, started)
    assert [item["met"] for item in found] == [*met, True, False]
    assert targets_table(found).count("MISSED") == 1 + met.count(False)


def test_an_action_that_fails_has_no_times() -> None:
    done: list[int] = []
    times = time_in_turns({"good": lambda: done.append(1), "bad": lambda: [][0]}, 3)
    assert times["bad"] is None
    assert len(times["good"] or ()) == 3
    assert len(done) == 4


def test_made_files_have_the_size_that_is_asked_for() -> None:
    assert 30_000 <= len(made_file(30).text) < 33_000

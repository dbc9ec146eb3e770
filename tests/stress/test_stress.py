"""A part of ``./dev stress``: all written cases, each in a child process, and a few random ones."""

from __future__ import annotations

import gc
import os
import random

import pytest
from laws.slices import amount, seed

from . import suite, trial
from .cases import Case, written_cases
from .suite import random_case, real_shaders, run_apart

SLOW = 300_000
"""Characters above which a case is left to ``./dev stress``."""

PARTS = 4
"""Of the cases, so that several processes share the work."""

CASES = [case for case in written_cases() if len(case.text) < SLOW]


@pytest.mark.parametrize("part", range(PARTS))
def test_written_cases(part: int) -> None:
    results = run_apart(CASES[part::PARTS], "spawn")
    assert not {result.case.name: result.wrong for result in results if result.wrong}


def test_random_cases() -> None:
    pick = random.Random(seed())
    shaders = [path for path in real_shaders() if "public" not in path.parts]
    cases = [random_case(pick, shaders) for _ in range(amount(30, 150))]
    wrong = [
        f"{r.case.name}: {r.wrong}\n{r.case.text}" for r in run_apart(cases, "spawn") if r.wrong
    ]
    assert wrong == []


@pytest.mark.parametrize(
    ("case", "wrong"),
    [
        (Case("right, but not taken", "float x = nothing;\n", "accepted"), "though it is right"),
        (
            Case("wrong, but taken", "void main() {}", "rejected"),
            "though it is wrong",
        ),
    ],
    ids=lambda value: getattr(value, "name", None),
)
def test_the_trial_can_fail(case: Case, wrong: str) -> None:
    (result,) = run_apart([case], "spawn")
    assert wrong in result.wrong


def test_a_case_that_takes_too_long_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trial, "SECONDS", 0.01)
    monkeypatch.setattr(trial, "SECONDS_PER_MEGABYTE", 0.0)
    gc.disable()  # What hypothesis does when garbage is collected would swallow the exception.
    try:
        result = trial.try_case(Case("long", "float a;\n" * 100_000))
    finally:
        gc.enable()
    assert result.outcome == "late"


@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_a_child_that_dies_is_one_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    def die(case: Case) -> None:
        os._exit(7)

    monkeypatch.setattr(suite, "try_case", die)
    cases = [Case("one", ""), Case("two", "")]
    assert [result.wrong for result in run_apart(cases)] == ["the process died, status 7"] * 2

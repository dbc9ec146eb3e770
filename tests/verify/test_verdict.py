"""What a verdict says of a node, and how it is written down."""

from __future__ import annotations

import json

import numpy as np

from shadercache.verify.verdict import Difference, Verdict, worst_of


def test_a_difference_without_end_can_be_written_down() -> None:
    endless = Difference(np.inf, np.inf, 0.5)
    verdict = Verdict("a", "main", "x", True, laws={"always": {"1-pass": endless}})
    written = json.loads(json.dumps(verdict.to_json(), allow_nan=False))
    assert written["always"]["1-pass"] == {"maximum": None, "p999": None, "changed": 0.5}
    assert written["broken"] == ["law 2 (1-pass)"]
    assert "some of which are not finite" in written["reasons"][0]


def test_a_fault_breaks_a_law_whose_pictures_are_exact() -> None:
    laws = {"resting": {"2-pass": Difference()}, "agreeing": {"2-pass": Difference()}}
    verdict = Verdict("a", "main", "x", True, laws=laws, faults={"law 4 (2-pass)": "no hits"})
    assert verdict.broken == ["law 4 (2-pass)"]
    assert verdict.reasons == ["law 4 (2-pass): no hits"]
    assert verdict.inexact == {}


def test_a_payload_that_is_too_old_breaks_law_7() -> None:
    verdict = Verdict("a", "main", "x", True, ages={"1-pass": 5.0, "2-pass": 4.0})
    assert verdict.broken == ["law 7 (1-pass)"]


def test_the_worst_of_differences_has_the_largest_of_each_figure() -> None:
    found = worst_of([Difference(0.5, 0.1, 0.2), Difference(0.25, 0.2, 0.1)])
    assert found == Difference(0.5, 0.2, 0.2)
    assert worst_of([]).exact

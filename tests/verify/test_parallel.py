"""Verifying in several processes outlives a driver that crashes."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from shadercache.diagnostics import GraphicsError
from shadercache.verify import parallel
from shadercache.verify.parallel import VerifiedScene
from shadercache.verify.verdict import Verdict

NODES = tuple("abcdefgh")
POISON = "d"


def always_dies(node: str, plain: bool) -> Verdict:
    """In place of what a process does with a node: one node crashes whoever takes it."""
    if node == POISON:
        os.abort()
    return Verdict(node, "main", "x", plain)


def dies_once(node: str, plain: bool) -> Verdict:
    """The same, but the second try goes well; a file remembers the first."""
    trace = Path(os.environ["TRACE"])
    if node == POISON and not trace.exists():
        trace.touch()
        os.abort()
    return Verdict(node, "main", "x", plain)


def all_die(node: str, plain: bool) -> Verdict:
    """A driver that draws nothing."""
    os.abort()


def starts(*_: object) -> None:
    """No verifier is wanted."""


@pytest.mark.parametrize(("work", "lost"), [(always_dies, {POISON}), (dies_once, set())])
def test_what_a_crash_left_is_done(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, work: object, lost: set[str]
) -> None:
    monkeypatch.setenv("TRACE", str(tmp_path / "trace"))
    monkeypatch.setattr(parallel, "_work", work)
    monkeypatch.setattr(parallel, "_start", starts)
    told: list[str] = []
    verdicts = parallel.verify_in_parallel(
        VerifiedScene(tmp_path), NODES, 2, heard=lambda verdict: told.append(verdict.node)
    )
    assert [verdict.node for verdict in verdicts] == list(NODES)
    assert sorted(told) == list(NODES), "each is told once"
    assert {verdict.node for verdict in verdicts if verdict.failure} == lost
    assert all(verdict.broken == ["cannot be drawn"] for verdict in verdicts if verdict.failure)


def test_a_driver_that_always_crashes_is_given_up(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(parallel, "_work", all_die)
    monkeypatch.setattr(parallel, "_start", starts)
    with pytest.raises(GraphicsError, match="SC606"):
        parallel.verify_in_parallel(VerifiedScene(tmp_path), NODES, 2)

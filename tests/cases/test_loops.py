"""Loops that wait for a payload: what a miss finds in the cache must not keep them going."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest

from shadercache.analysis.candidates import Candidate
from shadercache.emit import builder
from shadercache.gpu.context import Gpu
from shadercache.verify.verdict import Verdict
from shadercache.verify.verifier import Verifier

from .cases import analysed
from .scenery import scene_of

NAME = "loop_by_payload"
DECIDING = ("pace", "2 + int(", "1.5 + sin(")
"""How nodes begin that decide on a loop: by a step, by a count, by where it starts."""

pytestmark = pytest.mark.xdist_group("gl")


def nodes(*begins: str) -> list[Candidate]:
    main = [node for node in analysed(NAME).nodes if node.path == "main" and node.offered]
    return [next(node for node in main if node.text.startswith(text)) for text in begins]


def verdicts(gpu: Gpu, folder: Path, *begins: str) -> list[Verdict]:
    with closing(Verifier(gpu, (scene_of(NAME, folder), analysed(NAME)), (40, 40))) as verifier:
        return [verifier.check(node, plain=False) for node in nodes(*begins)]


def test_what_decides_on_loops_is_exact_and_not_cached_in_three_passes(
    gpu: Gpu, cases_folder: Path
) -> None:
    for verdict in verdicts(gpu, cases_folder, *DECIDING):
        assert not verdict.broken, verdict.text
        assert "how long a loop runs" in verdict.refused["3-pass"]
        assert verdict.algorithms == {"1-pass", "2-pass"}


def test_what_decides_on_no_loop_is_cached_by_all(gpu: Gpu, cases_folder: Path) -> None:
    (verdict,) = verdicts(gpu, cases_folder, "march(pace)")
    assert not verdict.broken
    assert not verdict.refused


def test_without_the_guard_the_laws_break(
    gpu: Gpu, cases_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(builder, "decided_loops", lambda *_: frozenset())
    (verdict,) = verdicts(gpu, cases_folder, "pace")
    if not verdict.broken and "Mesa 22" not in gpu.version:
        pytest.skip("here what is discarded leaves a loop by itself (Mesa 25 does, 22 does not)")
    assert {"law 3 (2-pass)", "law 2 (3-pass)"} <= set(verdict.broken)

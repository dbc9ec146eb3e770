"""``shadercache run --view``: debug views in false colours."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli.conftest import Shell

from shadercache.paths import data_path

pytestmark = pytest.mark.xdist_group("gl")

RUN = (
    *("run", data_path("corpus", "trashcan"), "--node", "24 of 25 samples"),
    *("--size", 48, "--frame", 3, "--period", 4),
)


def kinds(folder: Path) -> set[str]:
    return {path.stem.rpartition("-2-pass-")[2] for path in folder.glob("*.png")}


def test_every_view_on_request(shell: Shell, tmp_path: Path) -> None:
    outcome = shell(*RUN, "--view", "all", "--cache", "age=on", "-o", tmp_path)
    assert outcome.status == 0, outcome.err
    pictures = {"original", "cached", "difference", "signed"}
    assert kinds(tmp_path) == pictures | {
        *("hits", "hit", "refresh", "outside", "depth", "poison", "old", "age")
    }


def test_some_views(shell: Shell, tmp_path: Path) -> None:
    outcome = shell(*RUN, "--view", "clip", "--view", "hits", "-o", tmp_path)
    assert outcome.status == 0, outcome.err
    assert kinds(tmp_path) >= {"outside", "hits"}
    assert "note:" not in outcome.out, "nothing here looks like a cut"


def test_a_view_that_there_is_not(shell: Shell, tmp_path: Path) -> None:
    outcome = shell(*RUN, "--view", "age", "-o", tmp_path)
    assert outcome.status == 2
    assert "SC442" in outcome.err and "age=on" in outcome.err


def test_ages_in_half_floats_count_no_further(shell: Shell, tmp_path: Path) -> None:
    outcome = shell(*RUN[:-1], 2000, "--cache", "age=on", "-o", tmp_path)
    assert outcome.status == 2
    assert "SC441" in outcome.err and "rgba32f" in outcome.err


def test_ages_beside_tucked_offsets_count_no_further(shell: Shell, tmp_path: Path) -> None:
    # A number and its age: the offsets lie in their lowest bits.
    run = ("run", data_path("corpus", "chess"), "--node", "static share", "--size", 32)
    run = (*run, "--frame", 2, "--cache", "filter=carried,age=on", "-o", tmp_path)
    outcome = shell(*run, "--period", 20_000)
    assert outcome.status == 2
    assert "SC441" in outcome.err and "beside tucked offsets" in outcome.err
    assert shell(*run, "--period", 20_000, "--format", "rgba32f").status == 0

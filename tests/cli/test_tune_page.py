"""``shadercache tune --page``: the page of a small tuning."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from shadercache.paths import data_path
from shadercache.report.parts import page_parts
from tests.cli.conftest import Shell

SMALL = ("--mesh", str(data_path("corpus", "dragon", "dragon-small.npz")), "--size", "64")


@pytest.mark.slow
def test_a_tuning_is_told_and_drawn(shell: Shell, tmp_path: Path) -> None:
    page = tmp_path / "made" / "page.html"
    outcome = shell(
        *("tune", "dragon", "--max-error", "0.004,0.3", "--budget", "8s", *SMALL),
        *("--page", page, "--json"),
    )
    assert outcome.status == 0, outcome.err
    text = page.read_text(encoding="utf-8")
    match = re.search(r'id="data">(.*?)</script>', text, re.S)
    assert match is not None
    data = json.loads(match[1])
    found = outcome.json
    assert data["tuning"] == found
    plans = [one["plan"] for one in (*found["proven"], *found["finalists"])]
    drawn = [shot["plan"] for shot in data["shots"]]
    assert all(plan in drawn for plan in plans[:12])
    assert {f"{one['group']}-{one['value']}" for one in found["families"]} == set(data["payloads"])
    assert [len(one["files"]) > 1 for one in data["families"]] == [True] * len(found["families"])


def test_without_plotly_nothing_is_tuned(
    shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page_parts, "find_spec", lambda name: None)
    outcome = shell("tune", "dragon", "--max-error", "0.01", "--page", tmp_path / "page.html")
    assert outcome.status == 2 and "SC031" in outcome.err
    assert not list(tmp_path.iterdir())

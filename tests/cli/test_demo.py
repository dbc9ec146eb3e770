"""``shadercache demo``: both scenes, small and short."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli.conftest import Shell

pytestmark = pytest.mark.xdist_group("gl")


def test_the_demo_runs_through(shell: Shell, tmp_path: Path) -> None:
    outcome = shell("demo", "--size", 32, "--frames", 2, "-o", tmp_path)
    assert outcome.status == 0, outcome.err
    assert all(f"{number}-pass" in outcome.out for number in (1, 2, 3))
    assert {"dragon.json", "dragon.png", "trashcan.json"} <= {p.name for p in tmp_path.iterdir()}

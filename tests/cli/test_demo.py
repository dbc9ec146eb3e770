"""``shadercache demo``: both scenes, small and short."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from cli.conftest import Shell

from shadercache.cli.demo import SCENES

pytestmark = pytest.mark.xdist_group("gl")


def test_the_demo_runs_through(shell: Shell, tmp_path: Path) -> None:
    outcome = shell("demo", "--full", "--size", 32, "--frames", 2, "-o", tmp_path)
    assert outcome.status == 0, outcome.err
    assert outcome.out.count("-pass ") == 2 * 3 * 3
    assert {"dragon.json", "dragon.png", "trashcan.json"} <= {p.name for p in tmp_path.iterdir()}
    assert list((tmp_path / "dragon").glob("*-difference.png"))


def test_the_short_demo_names_its_picture_first(shell: Shell, tmp_path: Path) -> None:
    outcome = shell("demo", "--size", 32, "-o", tmp_path)
    assert outcome.status == 0, outcome.err
    scenes = [text.splitlines() for text in outcome.out.split("the picture: ")[1:]]
    assert [scene[0] for scene in scenes] == [f"{tmp_path / name}.png" for name in SCENES]
    assert all(Path(scene[0]).is_file() for scene in scenes)
    assert outcome.out.count("-pass ") == 2 * 3
    assert all(len(line) <= 100 for line in outcome.out.splitlines() if "-pass " in line)
    assert re.findall(r"32x32, (\d+) frames", outcome.out) == ["40", "40"]
    timed = re.findall(r"every ratio to within [\d.]+%.* from (\d+) timed frames", outcome.out)
    assert all(int(frames) >= 39 for frames in timed) and len(timed) == 2
    assert not (tmp_path / "dragon").exists()

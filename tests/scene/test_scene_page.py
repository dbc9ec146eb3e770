"""docs/SCENES.md: its example is a scene, and names every key that is read."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from shadercache.scene.description import Scene, load_scene
from shadercache.scene.object_inputs import SEMANTICS
from shadercache.scene.recording import read_recording
from shadercache.scene.toml_reader import Table

PAGE = Path(__file__).parents[2] / "docs" / "SCENES.md"


def _block(language: str, at: int = 0) -> str:
    """A block of code of the page."""
    text = PAGE.read_text(encoding="utf-8")
    found: list[str] = re.findall(rf"^```{language}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    return found[at]


@pytest.fixture
def example(tmp_path: Path) -> Path:
    block = _block("toml")
    (tmp_path / "frames.csv").write_text(_block("csv"))
    for name in re.findall(r'"([\w-]+\.(?:frag|vert|glb|npz|png))"', block):
        (tmp_path / name).touch()
    (tmp_path / "scene.toml").write_text(block)
    return tmp_path


def test_the_example_is_a_scene(example: Path) -> None:
    scene: Scene = load_scene(example)
    assert [part.name for part in scene.parts] == ["ground", "lamp 1", "lamp 2"]
    assert scene.parts[1].part == "Lamp"
    assert scene.common.motion.pose is not None
    assert scene.common.motion.pose.animation == "Walk"


def test_both_examples_of_a_recording_say_the_same(tmp_path: Path) -> None:
    (tmp_path / "r.csv").write_text(_block("csv"))
    (tmp_path / "r.toml").write_text(_block("toml", 1))
    one, other = (read_recording(tmp_path / name) for name in ("r.csv", "r.toml"))
    assert one.cuts == other.cuts == {2} and one.frames == 3
    assert {name: track.rows.tolist() for name, track in one.tracks.items()} == {
        name: track.rows.tolist() for name, track in other.tracks.items()
    }


def test_what_the_dump_writes_is_a_recording(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    given: dict[str, Any] = {}
    exec(_block("python"), given)
    matrix = np.arange(16.0).reshape(4, 4)
    for frame in range(3):
        given["dump"]({"u_view": matrix + frame, "u_time": 0.5}, cut=frame == 2)
    found = read_recording(tmp_path / "frames.csv")
    assert found.cuts == {2} and found.frames == 3
    assert found.of(None)["u_view"].at(1)[:5].tolist() == [1, 5, 9, 13, 2]
    assert found.of(None)["u_time"].at(0) == 0.5


def test_it_names_every_key(example: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    known: set[str] = set()
    refuse = Table._refuse_unknown

    def noted(self: Table) -> None:
        known.update(self._known)
        refuse(self)

    monkeypatch.setattr(Table, "_refuse_unknown", noted)
    load_scene(example)
    text = PAGE.read_text(encoding="utf-8")
    missing = {key for key in known if re.search(rf"\b{re.escape(key)}\b", text) is None}
    assert missing == set()
    words = {word for word in SEMANTICS if not word.startswith("inverse-")}
    assert {word for word in words if f"`{word}`" not in text} == set()

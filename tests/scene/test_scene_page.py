"""docs/SCENES.md: its example is a scene, and names every key that is read."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from shadercache.scene.description import Scene, load_scene
from shadercache.scene.object_inputs import SEMANTICS
from shadercache.scene.toml_reader import Table

PAGE = Path(__file__).parents[2] / "docs" / "SCENES.md"


@pytest.fixture
def example(tmp_path: Path) -> Path:
    text = PAGE.read_text(encoding="utf-8")
    [block] = re.findall(r"^```toml\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
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

"""A scene in which nothing moves does without reprojection."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path

MOVES = "degrees_per_frame = 1.0"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "can"
    shutil.copytree(data_path("corpus", "trashcan"), made)
    return made


def changed(folder: Path, old: str, new: str) -> Path:
    path = folder / "scene.toml"
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")
    return path


def test_what_moves_is_reprojected(folder: Path) -> None:
    assert open_scene(folder / "scene.toml")[1].mapping == "surface"


def test_what_rests_is_found_at_its_own_pixel(folder: Path) -> None:
    path = changed(folder, MOVES, "degrees_per_frame = 0.0")
    assert open_scene(path)[1].mapping == "screen"
    assert open_scene(path, mapping="surface")[1].mapping == "surface"


def test_a_camera_that_moves_late_is_enough(folder: Path) -> None:
    changed(folder, MOVES, "degrees_per_frame = 0.0")
    path = changed(
        folder,
        "[motion]",
        "[camera.path]\nkeys = [{ frame = 0, eye = [0.0, 0.0, 3.0], target = [0.0, 0.0, 0.0] }, "
        "{ frame = 50, eye = [0.0, 0.0, 3.0], target = [0.0, 0.0, 0.0] }, "
        "{ frame = 60, eye = [0.0, 0.1, 3.0], target = [0.0, 0.0, 0.0] }]\n\n[motion]",
    )
    assert open_scene(path)[1].mapping == "surface"

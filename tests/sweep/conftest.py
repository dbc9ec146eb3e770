"""A torus with a shader of which a handful of values can be cached."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from shadercache.front.read_options import ReadOptions
from shadercache.sweep.plan import SceneFile

SHADERS = Path(__file__).parent / "shaders"


@pytest.fixture
def torus(scene_folder: Path, tmp_path: Path) -> Path:
    """The scene's file, in a folder that a test may change."""
    folder = tmp_path / "rings"
    shutil.copytree(scene_folder, folder)
    shutil.copytree(SHADERS, folder, dirs_exist_ok=True)
    file = folder / "scene.toml"
    text = file.read_text()
    text = text.replace("emission/original", "rings").replace('"torus"', '"rings"')
    file.write_text(text.partition("[nodes]")[0])
    return file


@pytest.fixture
def rings(torus: Path) -> SceneFile:
    """The same as a sweep has it."""
    return SceneFile(torus, ReadOptions())

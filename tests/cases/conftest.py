"""The scene that all cases are drawn in."""

from __future__ import annotations

from pathlib import Path

import pytest

from .scenery import make_scene


@pytest.fixture(scope="session")
def scene_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the cases with the mesh and the textures made."""
    return make_scene(tmp_path_factory.mktemp("cases") / "scene")

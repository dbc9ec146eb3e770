"""Shaders of reports, analysed and verified in the scene of the cases."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from shadercache.compiler import Analysis, analyse
from shadercache.linking.scene_shaders import with_new_names
from shadercache.scene.description import Scene, load_scene
from shadercache.source import Source
from tests.altered import altered
from tests.cases.cases import FOLDER as CASES
from tests.cases.cases import vertex_for


@cache
def analysed(path: Path) -> Analysis:
    """What the compiler makes of a shader with the cases' vertex shader of its version."""
    files = (path, vertex_for(path))
    return analyse(*(Source(file.name, file.read_text(encoding="utf-8")) for file in files))


def scene_of(path: Path, folder: Path) -> Scene:
    """The scene with that shader, in a folder that ``tests.cases.scenery.make_scene`` made."""
    files = {"fragment": path, "vertex": CASES / vertex_for(path).name}
    return with_new_names(altered(load_scene(folder), **files), analysed(path).renamed)

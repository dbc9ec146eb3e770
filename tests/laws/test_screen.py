"""Laws 2 to 4 for values of the screen, which ``--approximate`` offers: exact at rest."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from laws.slices import amount, day_slice, seed

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import NAMES
from shadercache.compiler import Analysis
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.scene.description import Scene, load_scene
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.cases.scenery import ring

pytestmark = pytest.mark.xdist_group("screen")

FOLDER = Path(__file__).with_name("screen")
SHADERS = sorted(path.stem for path in FOLDER.glob("*.glsl") if path.stem != "head")
SIZE = (48, 48)
NODES = amount(3, 12)
"""Of each shader; the slices of successive seeds cover all of them."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The scene with its mesh, its texture and its shaders made."""
    made = tmp_path_factory.mktemp("screen") / "screen"
    shutil.copytree(FOLDER, made)
    np.savez(made / "ring.npz", **ring())
    pixels = np.random.default_rng(4).random((16, 16, 4), np.float32)
    np.savez(made / "map.npz", pixels=pixels)
    head = (FOLDER / "head.glsl").read_text("utf-8")
    for name in SHADERS:
        text = (FOLDER / f"{name}.glsl").read_text("utf-8")
        (made / f"{name}.frag").write_text(head + text, encoding="utf-8")
    return made


def opened(folder: Path, name: str, approximate: bool = True) -> tuple[Scene, Analysis]:
    scene = altered(load_scene(folder), fragment=folder / f"{name}.frag")
    return analyse_scene(scene, ReadOptions(approximate=approximate))


def approximate(analysis: Analysis) -> list[Candidate]:
    return [node for node in analysis.nodes if node.approximate]

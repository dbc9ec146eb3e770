"""The scenes of the corpus, their meshes and their generators."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest

from shadercache.scene.mesh import Mesh, load_mesh

CORPUS = Path(__file__).resolve().parent.parent.parent / "corpus"


def imported(scene: str) -> ModuleType:
    """``generate`` of a scene's folder; ``sys.modules`` forgets it again, for names recur."""
    folder = str(CORPUS / scene)
    before = set(sys.modules)
    sys.path.insert(0, folder)
    try:
        return importlib.import_module("generate")
    finally:
        sys.path.remove(folder)
        for name in set(sys.modules) - before:
            if (getattr(sys.modules[name], "__file__", None) or "").startswith(folder):
                del sys.modules[name]


@pytest.fixture(scope="session")
def dragon_generator() -> ModuleType:
    """corpus/dragon/generate.py."""
    return imported("dragon")


@pytest.fixture(scope="session")
def trashcan_generator() -> ModuleType:
    """corpus/trashcan/generate.py."""
    return imported("trashcan")


@pytest.fixture(scope="session", params=["dragon.npz", "dragon-small.npz"])
def dragon(request: pytest.FixtureRequest) -> Mesh:
    """The dragon at both resolutions."""
    return load_mesh(CORPUS / "dragon" / request.param)


@pytest.fixture(scope="session")
def can() -> Mesh:
    """The trash can."""
    return load_mesh(CORPUS / "trashcan" / "can.npz")

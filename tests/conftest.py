"""Fixtures for all tests: expected files, one OpenGL context, the torus and a variant of it."""

from __future__ import annotations

import difflib
import os
import random
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.crashes import pytest_xdist_make_scheduler  # noqa: F401 # a hook of pytest-xdist

if TYPE_CHECKING:
    from shadercache.gpu.context import Gpu
    from shadercache.render.bundle import Bundle
    from shadercache.render.render_scene import RenderScene
    from shadercache.scene.description import Scene

ROOT = Path(__file__).resolve().parent.parent
UPDATE, SHUFFLE = "--update-goldens", "--shuffle"
SEED, FIXED = "SHADERCACHE_SEED", "739949"

Golden = Callable[[str | Path, str], None]


def pytest_configure(config: pytest.Config) -> None:
    """The same seed everywhere: ``./dev nightly`` gives another one each day."""
    os.environ.setdefault(SEED, FIXED)


def pytest_report_header(config: pytest.Config) -> str:
    """The seed that picks nodes, sets and random shaders."""
    return f"seed: {SEED}={os.environ[SEED]}"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--update-goldens`` and ``--shuffle``."""
    help_text = "write the expected files anew instead of comparing with them"
    parser.addoption(UPDATE, action="store_true", help=help_text)
    help_text = "files, and tests in files, in an order drawn by this number"
    parser.addoption(SHUFFLE, type=int, metavar="N", help=help_text)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """With ``--update-goldens`` run only the tests that have an expected file; ``--shuffle``."""
    if (number := config.getoption(SHUFFLE)) is not None:
        _shuffle(items, random.Random(number))
    if config.getoption(UPDATE):
        chosen = [item for item in items if "golden" in getattr(item, "fixturenames", ())]
        config.hook.pytest_deselected(items=[item for item in items if item not in chosen])
        items[:] = chosen


def _shuffle(items: list[pytest.Item], by: random.Random) -> None:
    """Tests of a file stay together: fixtures of a module are made once."""
    by.shuffle(items)
    files = list(dict.fromkeys(item.path for item in items))
    items.sort(key=lambda item: files.index(item.path))


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Golden:
    """``golden("tests/goldens/x.frag", text)``: the file holds exactly this text."""

    def check(path: str | Path, text: str) -> None:
        file = ROOT / path
        name = file.relative_to(ROOT)
        if request.config.getoption(UPDATE):
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8", newline="")
        elif not file.exists():
            pytest.fail(f"{name} does not exist; ./dev goldens writes it", pytrace=False)
        elif (expected := file.read_bytes().decode()) != text:
            pytest.fail(_difference(str(name), expected, text), pytrace=False)

    return check


def _difference(name: str, expected: str, text: str) -> str:
    lines = difflib.unified_diff(
        expected.splitlines(),
        text.splitlines(),
        f"{name} (expected)",
        "what the code wrote",
        n=2,
        lineterm="",
    )
    advice = "If the new text is right, ./dev goldens writes it; read the diff before you commit."
    body = "\n".join(lines) or "only the line ends differ"
    return f"{name} is not what the code writes now.\n{body}\n\n{advice}"


_open: list[Gpu] = []


@pytest.fixture(scope="session")
def gpu() -> Iterator[Gpu]:
    """The OpenGL context of this process; every test that draws shares it."""
    from shadercache.gpu.context import open_context

    with open_context() as context:
        _open.append(context)
        yield context
        _open.clear()


@pytest.fixture(autouse=True)
def shared_context_is_current() -> Iterator[None]:
    """A command that ran in this process had a context of its own, and left none current."""
    _make_current()
    yield
    _make_current()


def _make_current() -> None:
    for context in _open:
        context.ctx.mglo._context.__enter__()


@pytest.fixture(scope="session")
def scene_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of ``tests/torus`` with the mesh made."""
    from tests.torus.mesh import FOLDER, write_arrays

    folder = tmp_path_factory.mktemp("torus")
    shutil.copytree(FOLDER, folder, dirs_exist_ok=True)
    write_arrays(folder)
    return folder


@pytest.fixture(scope="session")
def cases_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of ``tests/cases`` with the mesh and the textures made."""
    from tests.cases.scenery import make_scene

    return make_scene(tmp_path_factory.mktemp("cases") / "scene")


@pytest.fixture(scope="session")
def scene(scene_folder: Path) -> Scene:
    """The torus."""
    from shadercache.scene.description import load_scene

    return load_scene(scene_folder)


@pytest.fixture(scope="session")
def bundle() -> Bundle:
    """The variant of the torus's shader that is written by hand."""
    from shadercache.render.bundle import load_bundle
    from tests.torus.mesh import EMISSION

    return load_bundle(EMISSION)


@pytest.fixture(scope="session")
def world(gpu: Gpu, scene: Scene) -> Iterator[RenderScene]:
    """The torus at 96 x 64 with float colours, as proofs want it."""
    from shadercache.render.render_scene import RenderScene

    with RenderScene(gpu, scene, (96, 64), "rgba32f") as opened:
        yield opened

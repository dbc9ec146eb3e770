"""A wheel built from the tree works elsewhere: nothing of the tree is needed at run time."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGE_DATA = (".glsl", ".vert", ".json", ".txt", ".typed", ".html", ".css", ".js")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built wheel. hatchling is called directly, so that no network is needed."""
    folder = tmp_path_factory.mktemp("wheel")
    line = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(line, cwd=ROOT, check=True, capture_output=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The ``bin`` folder of an empty environment with the wheel; it borrows the dependencies."""
    home = tmp_path_factory.mktemp("environment")
    venv.create(home, symlinks=True)
    line = [sys.executable, "-m", "pip", "--python", str(home / "bin" / "python"), "install"]
    line += ["--quiet", "--no-deps", "--no-index", "--disable-pip-version-check", str(wheel)]
    subprocess.run(line, check=True, capture_output=True)
    (site,) = home.glob("lib/python3*/site-packages")
    # A line in a .pth file adds the folder but not the .pth files in it, which would add this tree.
    (site / "borrowed.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return home / "bin"


def tracked(*folders: str) -> list[str]:
    """Files under ``folders`` that belong to the project, without what git ignores."""
    line = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *folders]
    done = subprocess.run(line, cwd=ROOT, check=True, capture_output=True, text=True)
    return [name for name in done.stdout.splitlines() if (ROOT / name).exists()]


def test_everything_is_in_the_wheel(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    code = {n for n in tracked("shadercache") if n.endswith((".py", *PACKAGE_DATA))}
    data = {f"shadercache/_data/{n}" for n in tracked("grammars", "corpus")}
    assert any(n.endswith(".glsl") for n in code) and any(n.endswith(".lark") for n in data)
    assert any(n.endswith(".frag") for n in data)
    assert code | data <= names
    assert not [n for n in names if n.startswith(("tests", "bench"))]


def run(installed: Path, folder: Path, *arguments: str) -> str:
    line = [str(installed / "shadercache"), *arguments]
    env = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "VIRTUAL_ENV")}
    env["XDG_CACHE_HOME"] = str(folder / "cache")
    done = subprocess.run(line, cwd=folder, env=env, capture_output=True, text=True, check=False)
    # What takes long tells how far it is.
    told = [line for line in done.stderr.splitlines() if not line.startswith("measuring ")]
    assert (done.returncode, told) == (0, [])
    return done.stdout


def test_it_is_the_wheel_that_runs(installed: Path, tmp_path: Path) -> None:
    code = "import shadercache; print(shadercache.__file__)"
    line = [str(installed / "python"), "-c", code]
    done = subprocess.run(line, cwd=tmp_path, check=True, capture_output=True, text=True)
    assert Path(done.stdout.strip()).is_relative_to(installed.parent)


def test_version(installed: Path, tmp_path: Path) -> None:
    assert run(installed, tmp_path, "--version").startswith("shadercache ")


def test_the_demo(installed: Path, tmp_path: Path) -> None:
    folder = tmp_path / "leerer Ordner ü"
    folder.mkdir()
    table = run(installed, folder, "demo", "--full", "--frames", "2", "--size", "32x32")
    assert "2-pass" in table
    for scene in ("dragon", "trashcan"):
        assert (folder / "out" / "demo" / f"{scene}.png").stat().st_size > 1000


def test_nodes_and_rewrite_of_the_packed_corpus(installed: Path, tmp_path: Path) -> None:
    code = "from shadercache.paths import data_path; print(data_path('corpus', 'dragon'))"
    line = [str(installed / "python"), "-c", code]
    done = subprocess.run(line, cwd=tmp_path, check=True, capture_output=True, text=True)
    dragon = Path(done.stdout.strip())
    assert dragon.is_relative_to(installed.parent)
    table = run(installed, tmp_path, "nodes", str(dragon / "dragon.frag"), "--offered")
    node = table.splitlines()[1].split()[0]
    run(installed, tmp_path, "rewrite", str(dragon / "dragon.frag"), "--node", node, "-o", "out")
    assert (tmp_path / "out" / "manifest.json").exists()

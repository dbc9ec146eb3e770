"""Results appear whole or not at all."""

from __future__ import annotations

import errno
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from shadercache.cli.io import atomic_folder
from shadercache.diagnostics import UsageError

CLI = (sys.executable, "-m", "shadercache")


def tree(folder: Path) -> dict[str, str]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_text() for path in files}


def test_a_new_folder_with_its_parents(tmp_path: Path) -> None:
    out = tmp_path / "a" / "b"
    with atomic_folder(out) as folder:
        (folder / "sub").mkdir()
        (folder / "sub" / "x.txt").write_text("x")
        assert not out.exists()
    assert tree(tmp_path) == {"a/b/sub/x.txt": "x"}
    mask = os.umask(0)
    os.umask(mask)
    assert out.stat().st_mode & 0o777 == 0o777 & ~mask


def test_a_folder_that_exists_keeps_other_files(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("mine")
    (tmp_path / "x.txt").write_text("old")
    with atomic_folder(tmp_path) as folder:
        (folder / "x.txt").write_text("new")
        (folder / "deep" / "er").mkdir(parents=True)
        (folder / "deep" / "er" / "y").write_text("y")
    assert tree(tmp_path) == {"mine": "mine", "x.txt": "new", "deep/er/y": "y"}


def test_a_link_to_a_folder_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real")
    with atomic_folder(tmp_path / "link") as folder:
        (folder / "x").write_text("x")
    assert (tmp_path / "link").is_symlink()
    assert tree(tmp_path / "real") == {"x": "x"}


@pytest.mark.parametrize("exists", [False, True])
@pytest.mark.parametrize("failure", [OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)), KeyError()])
def test_a_failure_leaves_nothing(tmp_path: Path, exists: bool, failure: Exception) -> None:
    out = tmp_path / "a" / "b"
    if exists:
        out.mkdir(parents=True)
        (out / "manifest.json").write_text("old")
    before = tree(tmp_path)
    with pytest.raises((UsageError, KeyError)), atomic_folder(out) as folder:
        (folder / "manifest.json").write_text("new")
        raise failure
    assert tree(tmp_path) == before
    assert list(tmp_path.iterdir()) == ([tmp_path / "a"] if exists else [])


def test_a_full_disk_names_the_folder(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught, atomic_folder(tmp_path / "out"):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    assert (
        str(caught.value) == f"error: cannot write {tmp_path}/out: No space left on device [SC002]"
    )


def test_an_error_names_the_file_as_it_would_be_called(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught, atomic_folder(tmp_path / "out") as folder:
        (folder / "no" / "x.frag").write_text("x")
    assert f"cannot write {tmp_path}/out/no/x.frag: No such file" in str(caught.value)


def test_an_error_about_another_file_is_left_alone(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), atomic_folder(tmp_path / "out"):
        Path("/nowhere/x").read_text()


def test_a_folder_where_a_file_must_go_changes_nothing(tmp_path: Path) -> None:
    (tmp_path / "b.frag").mkdir()
    (tmp_path / "manifest.json").write_text("old")
    with (
        pytest.raises(UsageError, match=r"b\.frag: it is a folder"),
        atomic_folder(tmp_path) as folder,
    ):
        for name in ("a.frag", "b.frag", "manifest.json"):
            (folder / name).write_text("new")
    assert tree(tmp_path) == {"manifest.json": "old"}


def test_the_manifest_comes_last(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "manifest.json").write_text("old")
    moved: list[tuple[str, bool]] = []
    replace = Path.replace

    def spy(self: Path, target: Path) -> Path:
        moved.append((target.name, (tmp_path / "manifest.json").exists()))
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", spy)
    with atomic_folder(tmp_path) as folder:
        for name in ("a.frag", "manifest.json", "z.frag"):
            (folder / name).write_text("new")
    assert moved == [("a.frag", False), ("z.frag", False), ("manifest.json", False)]


def test_a_limit_of_the_system_leaves_nothing(fragment: Path, rings: str, tmp_path: Path) -> None:
    """A real failure in the middle of writing: no file may be longer than 2 kB."""
    done = subprocess.run(
        [*CLI, "rewrite", fragment, "--node", rings, "-o", tmp_path / "out"],
        stderr=subprocess.PIPE,
        text=True,
        check=False,
        env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1", "XDG_CACHE_HOME": "/dev/null"},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048)),
    )
    assert done.returncode == 2
    assert done.stderr == f"error: cannot write {tmp_path}/out: File too large [SC002]\n"
    assert list(tmp_path.iterdir()) == []

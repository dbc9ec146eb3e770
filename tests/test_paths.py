"""The user's cache folder as each system has it; what cannot run here is its answers only."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from shadercache.paths import user_cache_folder


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's home, with a space and letters that are not ASCII in its name."""
    folder = tmp_path / "Jörg Ł"
    folder.mkdir()
    monkeypatch.setattr(Path, "home", lambda: folder)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.delenv("LOCALAPPDATA", raising=False)
    return folder


@pytest.mark.parametrize(
    ("system", "place"),
    [
        ("linux", ".cache"),
        ("freebsd14", ".cache"),
        ("darwin", "Library/Caches"),
        ("win32", "AppData/Local"),
    ],
)
def test_where_it_lies(
    home: Path, monkeypatch: pytest.MonkeyPatch, system: str, place: str
) -> None:
    monkeypatch.setattr(sys, "platform", system)
    assert user_cache_folder() == home / place / "shadercache"


def test_windows_says_where_it_lies(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setenv("LOCALAPPDATA", str(home / "Local"))
    assert user_cache_folder() == home / "Local" / "shadercache"
    monkeypatch.setenv("LOCALAPPDATA", "Local")
    assert user_cache_folder() == home / "AppData" / "Local" / "shadercache"


@pytest.mark.parametrize("system", ["darwin", "win32"])
def test_a_variable_is_heard_on_every_system(
    home: Path, monkeypatch: pytest.MonkeyPatch, system: str
) -> None:
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setenv("LOCALAPPDATA", str(home / "Local"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(home / "mine"))
    assert user_cache_folder() == home / "mine" / "shadercache"


def test_no_owners_and_modes(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr("os.getuid")
    folder = user_cache_folder()
    assert folder is not None
    folder.chmod(0o777)
    assert user_cache_folder() == folder

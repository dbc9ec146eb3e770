"""The saved parser and the folders it is kept in; what importing the front end loads."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from shadercache import paths
from shadercache.front import grammar
from shadercache.front.parse import parse
from shadercache.lang import words
from shadercache.paths import data_path, user_cache_folder
from shadercache.source import Source

SHADER = Source("test", "#version 330\nvoid main() { }")


@pytest.fixture
def cache_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty cache home and a parser that is not loaded yet."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    grammar.load_parser.cache_clear()
    yield tmp_path
    grammar.load_parser.cache_clear()


def saved(home: Path) -> list[Path]:
    return sorted((home / "shadercache").glob("*"))


def test_the_parser_is_saved_in_a_private_folder_and_loaded(cache_home: Path) -> None:
    parse(SHADER)
    (path,) = saved(cache_home)
    assert path.parent.stat().st_mode & 0o777 == 0o700
    assert path.stat().st_mode & 0o077 == 0
    before = path.stat().st_mtime_ns
    grammar.load_parser.cache_clear()
    parse(SHADER)
    assert saved(cache_home) == [path]
    assert path.stat().st_mtime_ns == before


@pytest.mark.parametrize("damage", [b"", b"garbage", b"\x80\x05N.", "half"])
def test_a_damaged_file_is_made_anew(cache_home: Path, damage: bytes | str) -> None:
    parse(SHADER)
    (path,) = saved(cache_home)
    good = path.read_bytes()
    path.write_bytes(good[: len(good) // 2] if isinstance(damage, str) else damage)
    grammar.load_parser.cache_clear()
    parse(SHADER)
    assert saved(cache_home) == [path]
    assert len(path.read_bytes()) > len(good) // 2


def test_no_cache_folder_is_needed(cache_home: Path) -> None:
    (cache_home / "shadercache").write_text("not a folder")
    assert user_cache_folder() is None
    assert parse(SHADER).version == 330


def test_a_full_disk_is_no_error(cache_home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*args: object) -> None:
        raise OSError("no space")

    monkeypatch.setattr(os, "replace", full)
    assert parse(SHADER).version == 330
    assert saved(cache_home) == []


def test_a_folder_that_others_may_write_in_is_not_trusted(cache_home: Path) -> None:
    folder = cache_home / "shadercache"
    folder.mkdir()
    folder.chmod(0o777)
    assert user_cache_folder() is None
    folder.chmod(0o755)
    assert user_cache_folder() == folder
    assert folder.stat().st_mode & 0o777 == 0o700


def test_a_link_is_not_trusted(cache_home: Path) -> None:
    (cache_home / "elsewhere").mkdir()
    (cache_home / "shadercache").symlink_to(cache_home / "elsewhere")
    assert user_cache_folder() is None


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="no user ids here")
def test_a_folder_of_somebody_else_is_not_trusted(
    cache_home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert user_cache_folder() is not None
    owner = os.getuid()
    monkeypatch.setattr(os, "getuid", lambda: owner + 1)
    assert user_cache_folder() is None


def test_without_xdg_the_folder_is_in_the_home(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", "relative/paths/are/ignored")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert user_cache_folder() == tmp_path / ".cache" / "shadercache"


def test_a_wheel_holds_its_data_in_the_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert data_path("grammars", "glsl.lark").is_file()
    monkeypatch.setattr(paths, "_PACKAGE", tmp_path)
    assert data_path("grammars") == tmp_path.parent / "grammars"
    (tmp_path / "_data").mkdir()
    assert data_path("grammars") == tmp_path / "_data" / "grammars"


def test_importing_the_front_end_loads_no_parser_generator() -> None:
    program = (
        "import sys, shadercache, shadercache.front.parse, shadercache.emit.printer\n"
        "assert not {'lark', 'numpy', 'moderngl', 'typer'} & set(sys.modules)\n"
        "from shadercache.source import Source\n"
        "shadercache.front.parse.parse(Source('a', '#version 330\\n'))\n"
        "assert not {'numpy', 'moderngl', 'typer'} & set(sys.modules)\n"
    )
    root = Path(paths.__file__).parent.parent
    subprocess.run([sys.executable, "-c", program], check=True, cwd=root)


def test_every_qualifier_has_its_place_in_the_order() -> None:
    extensions = frozenset(
        f"GL_{name}"
        for name in (
            "AMD_shader_explicit_vertex_parameter",
            "EXT_fragment_shader_barycentric",
            "EXT_nonuniform_qualifier",
            "NV_fragment_shader_barycentric",
        )
    )
    assert set(words.QUALIFIER_ORDER) == words.qualifier_words(460, False, extensions)


def test_no_word_is_a_keyword_and_reserved() -> None:
    for version in (330, 400, 420, 430, 460):
        assert not words.keywords(version) & words.reserved_words(version)
    assert "double" in words.reserved_words(330)
    assert "double" in words.keywords(400)

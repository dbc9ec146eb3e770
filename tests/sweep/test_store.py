"""The result store: whole trials or none, other people's files left alone."""

from __future__ import annotations

import resource
import signal
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from msgspec import structs

from shadercache.diagnostics import InputError, UsageError
from shadercache.sweep import store as store_module
from shadercache.sweep.row import (
    Failure,
    Machine,
    PayloadEntry,
    Row,
    SceneEntry,
    Written,
)
from shadercache.sweep.store import Store, hash_of

HERE = Machine("llvmpipe", "4.5", "wall clock", "a processor", 2, "Debian")


def row(key: str, identity: str, **changed: object) -> Row:
    made = Row(
        key=key,
        identity=identity,
        kind="variant",
        scene=SceneEntry("torus", "torus/scene.toml", (64, 64), 8, "surface"),
        payload=PayloadEntry("albedo", ("main.1-abc",), "main", "f(x)", "vec3", (), 0.5),
        label="albedo",
        configuration=None,
        machine=HERE,
        outcome=Failure("hung", "SC606", "too slow"),
        texts={},
        pictures={},
        written=Written("2026-01-01T00:00:00+00:00", "0.1.0"),
    )
    return structs.replace(made, **changed)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "new" / "sweep.db"


def test_rows_and_blobs_come_back(path: Path) -> None:
    data = b"void main() {}"
    kept = row("a", "A", texts={"source.frag": hash_of(data)})
    with Store(path, create=True) as store:
        store.keep([kept, row("b", "B")], {hash_of(data): data})
    with Store(path) as store:
        assert store.rows() == [kept, row("b", "B")]
        assert store.keys() == {"a", "b"}
        assert store.blob(hash_of(data)) == data
        with pytest.raises(KeyError):
            store.blob("none")


def test_a_row_takes_the_place_of_its_identity(path: Path) -> None:
    with Store(path, create=True) as store:
        store.keep([row("old", "A"), row("other", "B")], {})
        store.keep([row("new", "A")], {})
        assert [one.key for one in store.rows()] == ["other", "new"]


def test_a_row_of_other_sources_is_stale_and_kept(path: Path) -> None:
    with Store(path, create=True) as store:
        store.keep([row("a", "A"), row("b", "B"), row("c", "C")], {})
        assert store.mark_stale({"A": "changed", "B": "b"}) == 1
        assert [one.key for one in store.rows()] == ["b", "c"]
        assert [one.key for one in store.rows(stale=True)] == ["a", "b", "c"]
        assert store.stale_identities() == {"A"}
        assert store.mark_stale({"A": "a"}) == 0  # the file is as it was before
        assert len(store.rows()) == 3


def test_a_transaction_that_fails_leaves_nothing(path: Path) -> None:
    with Store(path, create=True) as store:
        store.keep([row("a", "A")], {})
        with pytest.raises(InputError, match="SC033"):
            store.keep([row("b", "B"), row("a", "C")], {"blob": b"data"})  # the key is taken
        assert store.keys() == {"a"}
        with pytest.raises(KeyError):
            store.blob("blob")


def test_what_no_row_names_is_dropped(path: Path) -> None:
    with Store(path, create=True) as store:
        store.keep([row("a", "A", pictures={"cached": "used"})], {"used": b"1", "unused": b"2"})
        store.drop_unused()
        assert store.blob("used") == b"1"
        with pytest.raises(KeyError):
            store.blob("unused")


def test_there_is_no_store(path: Path) -> None:
    with pytest.raises(InputError, match="SC033"):
        Store(path)
    assert not path.exists()


@pytest.mark.parametrize("create", (False, True))
def test_a_database_of_another_program_is_left_alone(tmp_path: Path, create: bool) -> None:
    path = tmp_path / "theirs.db"
    with sqlite3.connect(path) as theirs:
        theirs.execute("CREATE TABLE trial (name TEXT)")
    theirs.close()
    before = path.read_bytes()
    with pytest.raises(InputError, match="another program"):
        Store(path, create=create)
    assert path.read_bytes() == before


@pytest.mark.parametrize("create", (False, True))
@pytest.mark.parametrize("text", (b"not a database at all, but text" * 50, b"short"))
def test_a_file_that_is_no_database(tmp_path: Path, create: bool, text: bytes) -> None:
    path = tmp_path / "text.db"
    path.write_bytes(text)
    with pytest.raises(InputError, match="SC033"):
        Store(path, create=create)
    assert path.read_bytes() == text


def test_a_store_of_a_later_version(path: Path) -> None:
    Store(path, create=True).release()
    with sqlite3.connect(path) as base:
        base.execute("PRAGMA user_version = 9")
    base.close()
    with pytest.raises(InputError, match="version 9, not 1"):
        Store(path)


def test_a_damaged_row_is_told(path: Path) -> None:
    with Store(path, create=True) as store:
        store.keep([row("a", "A")], {})
    with sqlite3.connect(path) as base:
        base.execute("UPDATE trial SET row = x'7b7d'")
    base.close()
    with Store(path) as store, pytest.raises(InputError, match="damaged"):
        store.rows()


def test_a_locked_store_is_told(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store_module, "LOCK_SECONDS", 0.05)
    Store(path, create=True).release()
    other = sqlite3.connect(path, isolation_level=None)
    other.execute("BEGIN IMMEDIATE")
    with Store(path) as store, pytest.raises(UsageError, match="locked"):
        store.keep([row("a", "A")], {})
    other.close()


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UsageError, match="SC034"):
        Store(tmp_path / "file" / "sweep.db", create=True)


def test_a_full_disk_is_told_and_nothing_is_lost(path: Path) -> None:
    with Store(path, create=True) as store:
        store.keep([row("a", "A")], {})
    limit = 256 << 10

    def small_disk() -> None:
        # A write past the limit of a file's size fails, as one on a full disk does.
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    code = f"""
from pathlib import Path
from shadercache.diagnostics import DiagnosticError
from shadercache.sweep.store import Store
with Store(Path({str(path)!r})) as store:
    try:
        store.keep([], {{"large": bytes({4 * limit})}})
    except DiagnosticError as error:
        print(error)
    print(sorted(store.keys()))
"""
    done = subprocess.run(
        [sys.executable, "-c", code], preexec_fn=small_disk, capture_output=True, text=True
    )
    assert "the disk is full [SC034]" in done.stdout, done
    assert "['a']" in done.stdout
    with Store(path) as store:
        assert [one.key for one in store.rows()] == ["a"]

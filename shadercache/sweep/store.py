"""The result store: an SQLite file with a row for each finished trial.

Rows, shaders and pictures of a trial are written in one transaction (write-ahead log), so that a
process that is killed at any moment leaves whole trials only.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path

import msgspec

from shadercache.diagnostics import InputError, UsageError, input_error, usage_error
from shadercache.gpu.resource import Resource
from shadercache.sweep.row import Row

APPLICATION = 0x53435253
"""What SQLite's ``application_id`` says of a store: "SCRS"."""

SCHEMA_VERSION = 1

LOCK_SECONDS = 10.0
"""How long another process may hold the lock before that is told."""

_SCHEMA = f"""
CREATE TABLE trial (
    key TEXT PRIMARY KEY,
    identity TEXT NOT NULL,
    stale INTEGER NOT NULL DEFAULT 0,
    row BLOB NOT NULL
) STRICT;
CREATE INDEX trial_identity ON trial (identity);
CREATE TABLE blob (
    hash TEXT PRIMARY KEY,
    data BLOB NOT NULL
) STRICT;
PRAGMA application_id = {APPLICATION};
PRAGMA user_version = {SCHEMA_VERSION};
"""

_FULL = sqlite3.SQLITE_FULL, sqlite3.SQLITE_IOERR
_BUSY = sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED


class Store(Resource):
    """An open store. Every method raises as :func:`_told` where the file gives trouble."""

    def __init__(self, path: Path, create: bool = False) -> None:
        """Open a store, or make an empty one.

        Raises:
            InputError: SC033, there is no such file, or it is no store of this version.
            UsageError: SC034, it is locked, cannot be written, or the disk is full.
        """
        self.path = path
        if not create and not path.is_file():
            raise input_error("SC033", f"there is no result store {path}")
        with _told(path):
            if create:
                path.parent.mkdir(parents=True, exist_ok=True)
            # No isolation level: transactions are opened by hand, since Python's would be deferred
            # and meet a lock only at their first write.
            self._base = sqlite3.connect(path, timeout=LOCK_SECONDS, isolation_level=None)
            try:
                self._prepare(create)
            except BaseException:
                self._base.close()
                raise

    def _prepare(self, create: bool) -> None:
        base = self._base
        query = "SELECT count(*) FROM sqlite_master"
        # Without a table it may still be another program's: that has left its mark.
        if create and not (base.execute(query).fetchone()[0] or _number(base, "application_id")):
            base.execute("PRAGMA journal_mode = WAL")
            # The two marks are in the same transaction: whoever is killed here leaves an empty
            # database. Only the journal mode cannot be: SQLite does not change it within one.
            base.executescript(f"BEGIN IMMEDIATE;{_SCHEMA}COMMIT;")
        application = _number(base, "application_id")
        version = _number(base, "user_version")
        if application != APPLICATION:
            raise input_error("SC033", f"{self.path} is a database of another program")
        if version != SCHEMA_VERSION:
            message = f"{self.path} is a store of version {version}, not {SCHEMA_VERSION}"
            raise input_error("SC033", message)

    def keep(self, rows: Iterable[Row], blobs: Mapping[str, bytes]) -> None:
        """Write finished trials, all or none. A row takes the place of those of its identity."""
        with self._changes() as base:
            # Named by content: what is there already is the same.
            base.executemany("INSERT OR IGNORE INTO blob VALUES (?, ?)", blobs.items())
            for row in rows:
                base.execute("DELETE FROM trial WHERE identity = ?", (row.identity,))
                data = msgspec.json.encode(row)
                base.execute("INSERT INTO trial VALUES (?, ?, 0, ?)", (row.key, row.identity, data))

    def mark_stale(self, wanted: Mapping[str, str]) -> int:
        """Mark the rows whose identity is wanted under another key; returns how many.

        Args:
            wanted: identity -> the key that it has now.
        """
        with self._changes() as base:
            # A table, since SQLite limits the parameters of a query, and a plan may have more rows.
            base.execute("CREATE TEMP TABLE wanted (identity TEXT PRIMARY KEY, key TEXT)")
            base.executemany("INSERT INTO wanted VALUES (?, ?)", wanted.items())
            same = "FROM wanted WHERE wanted.identity = trial.identity"
            # Set in both directions: where a file is changed back, its rows are good again.
            base.execute(
                f"UPDATE trial SET stale = (SELECT wanted.key != trial.key {same}) "
                f"WHERE EXISTS (SELECT 1 {same})"
            )
            query = "SELECT count(*) FROM trial JOIN wanted USING (identity) WHERE stale"
            count: int = base.execute(query).fetchone()[0]
            base.execute("DROP TABLE wanted")
        return count

    def keys(self) -> frozenset[str]:
        """The keys of all rows."""
        with _told(self.path):
            return frozenset(key for (key,) in self._base.execute("SELECT key FROM trial"))

    def stale_identities(self) -> frozenset[str]:
        """The identities of rows whose sources have changed since."""
        with _told(self.path):
            query = "SELECT identity FROM trial WHERE stale"
            return frozenset(identity for (identity,) in self._base.execute(query))

    def rows(self, stale: bool = False) -> list[Row]:
        """All rows in the order they were written; with ``stale`` also those."""
        with _told(self.path):
            # The mark is 0 or 1, so 0 asks for fresh rows alone and 1 for all.
            query = "SELECT row FROM trial WHERE stale <= ? ORDER BY rowid"
            found = self._base.execute(query, (int(stale),)).fetchall()
        try:
            return [msgspec.json.decode(data, type=Row) for (data,) in found]
        except msgspec.DecodeError as error:
            raise input_error(
                "SC033", f"{self.path} holds a row that is damaged: {error}"
            ) from None

    def blob(self, hashed: str) -> bytes:
        """A shader or a picture. Raises :class:`KeyError` where the store lacks it."""
        with _told(self.path):
            query = "SELECT data FROM blob WHERE hash = ?"
            found = self._base.execute(query, (hashed,)).fetchone()
        if found is None:
            raise KeyError(hashed)
        return bytes(found[0])

    def drop_unused(self) -> None:
        """Forget the shaders and pictures that no row names."""
        used = {
            name
            for row in self.rows(True)
            for kind in (row.texts, row.pictures)
            for name in kind.values()
        }
        with self._changes() as base:
            kept = {name for (name,) in base.execute("SELECT hash FROM blob")}
            unused = [(name,) for name in kept - used]
            base.executemany("DELETE FROM blob WHERE hash = ?", unused)

    @contextmanager
    def _changes(self) -> Iterator[sqlite3.Connection]:
        """A transaction: committed whole, or not at all."""
        with _told(self.path):
            self._base.execute("BEGIN IMMEDIATE")
            try:
                yield self._base
            except BaseException:
                if self._base.in_transaction:  # SQLite has undone it where the disk is full
                    self._base.execute("ROLLBACK")
                raise
            self._base.execute("COMMIT")

    def release(self) -> None:
        """Close the file."""
        self._base.close()


def _number(base: sqlite3.Connection, pragma: str) -> int:
    number: int = base.execute(f"PRAGMA {pragma}").fetchone()[0]
    return number


def hash_of(data: bytes) -> str:
    """The name under which a store keeps a shader or a picture."""
    return sha256(data).hexdigest()[:32]


@contextmanager
def _told(path: Path) -> Iterator[None]:
    """What SQLite complains of, as a diagnostic."""
    try:
        yield
    except sqlite3.Error as error:
        raise _trouble(path, error) from None
    except OSError as error:
        raise usage_error("SC034", f"cannot write {path}: {error.strerror or error}") from None


def _trouble(path: Path, error: sqlite3.Error) -> InputError | UsageError:
    # Extended codes of SQLite hold the primary one in their lowest byte.
    code = getattr(error, "sqlite_errorcode", 0) & 0xFF
    if code in _BUSY:
        hint = "another sweep or program writes to it; wait for its end, or take another file"
        return usage_error("SC034", f"the store {path} is locked", hint)
    if code in _FULL:
        hint = "what was finished is kept; make room, and the same command goes on"
        return usage_error("SC034", f"the store {path} cannot grow: the disk is full", hint)
    if code in (sqlite3.SQLITE_READONLY, sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_PERM):
        return usage_error("SC034", f"the store {path} cannot be written: {error}")
    return input_error("SC033", f"{path} is no result store: {error}")

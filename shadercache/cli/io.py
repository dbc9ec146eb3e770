"""Read sources and write results: whole or not at all."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from errno import EISDIR, ENOTDIR
from pathlib import Path

from shadercache.diagnostics import Diagnostic, InputError, UsageError, input_error, usage_error
from shadercache.foreign_files import MAX_SHADER, read_bytes, read_stream
from shadercache.source import Source, Span

MANIFEST = "manifest.json"


def folder(text: str | Path) -> Path:
    """The folder that an option names. An empty name would quietly mean the current one.

    Raises :class:`UsageError` SC002: the name is empty.
    """
    if not str(text):
        raise usage_error("SC002", "cannot write: the name of the folder is empty")
    return Path(text)


def read_source(path: str) -> Source:
    """The text of a shader file, or of stdin for ``-``, named as the user named it.

    A byte order mark is dropped; line ends stay as they are.

    Raises :class:`InputError` SC001: the file cannot be read or is not UTF-8 text.
    """
    name = "<stdin>" if path == "-" else path
    try:
        if path == "-":
            data = read_stream(sys.stdin.buffer, MAX_SHADER)
        else:
            data = read_bytes(Path(path), MAX_SHADER)
    except OSError as error:
        raise input_error("SC001", f"cannot read {name}: {error.strerror or error}") from None
    try:
        return Source(name, data.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        # Positions in a source count characters, without a byte order mark; the error counts bytes.
        start = len(data[: error.start].decode("utf-8-sig"))
        source = Source(name, data.decode("utf-8-sig", errors="replace"))
        message = f"not UTF-8 text: {error.reason} (byte 0x{data[error.start]:02x})"
        place = Span(start, start + 1)
        raise InputError(Diagnostic("SC001", message, source, place)) from None


def read_pair(fragment: str, vertex: str | None) -> tuple[Source, Source | None]:
    """A fragment shader and its vertex shader, by default the ``.vert`` file beside it, if any.

    Raises:
        InputError: SC001, a file cannot be read.
        UsageError: SC005, both are stdin.
    """
    if vertex is None:
        beside = Path(fragment).with_suffix(".vert") if fragment not in ("-", "") else None
        if beside is None or not beside.is_file():
            return read_source(fragment), None
        vertex = str(beside)
    if fragment == vertex == "-":
        raise usage_error("SC005", "only one of the two shaders can come from stdin")
    return read_source(fragment), read_source(vertex)


@contextmanager
def atomic_folder(out: Path) -> Iterator[Path]:
    """An empty folder to write results into; they appear in ``out`` only if the block succeeds.

    A new ``out`` is made by one rename. Into a folder that exists the files are moved one by one
    (files with other names stay); its old manifest goes first and the new one comes last, so that
    a folder with a manifest is always complete.

    Raises :class:`UsageError` SC002: the folder cannot be written or the disk is full.
    """
    # Followed, so that a link to a folder stays a link.
    out = Path(os.path.realpath(out))
    home = out if out.is_dir() else out.parent
    # What is made on the way is taken away again if the block fails.
    missing = [folder for folder in (*home.parents[::-1], home) if not folder.exists()]
    staged: Path | None = None
    try:
        standing = next(folder for folder in (out, *out.parents) if folder.exists())
        if not standing.is_dir():
            raise NotADirectoryError(ENOTDIR, "it is a file, not a folder", str(standing))
        home.mkdir(parents=True, exist_ok=True)
        # Beside its goal: renames are atomic only within one file system.
        staged = Path(tempfile.mkdtemp(prefix=f".{out.name}-", suffix=".tmp", dir=home))
        yield staged
        _publish(staged, out)
        missing = []
    except OSError as error:
        raise _cannot_write(out, staged, error) from None
    finally:
        if staged is not None:
            shutil.rmtree(staged, ignore_errors=True)
        for folder in reversed(missing):
            with suppress(OSError):
                folder.rmdir()


def _publish(staged: Path, out: Path) -> None:
    if not out.exists():
        mask = os.umask(0)  # There is no way to read it without setting it.
        os.umask(mask)
        staged.chmod(0o777 & ~mask)  # mkdtemp makes it private
        staged.rename(out)
        return
    files = sorted(path.relative_to(staged) for path in staged.rglob("*") if path.is_file())
    # All of them before the first is moved: afterwards it would be too late to refuse.
    for path in files:
        if (out / path).is_dir():
            reason = "it is a folder, but a file must go there"
            raise IsADirectoryError(EISDIR, reason, str(out / path))
    # Without a manifest a folder is no result, so nobody takes a half of it for one.
    files.sort(key=lambda path: path == Path(MANIFEST))
    if Path(MANIFEST) in files:
        (out / MANIFEST).unlink(missing_ok=True)
    for path in files:
        (out / path).parent.mkdir(parents=True, exist_ok=True)
        (staged / path).replace(out / path)


def _cannot_write(out: Path, staged: Path | None, error: OSError) -> OSError | UsageError:
    """Names the file as ``out`` would hold it; leaves an error about another file alone."""
    place = str(error.filename or out)
    if staged is not None:
        place = place.replace(str(staged), str(out))
        if not place.startswith(str(out)):
            return error
    return usage_error("SC002", f"cannot write {place}: {error.strerror or error}")

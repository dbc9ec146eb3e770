"""Write files whole or not at all."""

from __future__ import annotations

import os
import re
import tempfile
from pathlib import Path

from shadercache.diagnostics import UsageError, usage_error

MAX_STEM = 120
"""Bytes that a text gives to the name of a file; file systems take 255."""

# Windows takes these for devices, whatever stands behind the first dot.
_DEVICE = re.compile(
    r"(?:con|prn|aux|nul|conin\$|conout\$|(?:com|lpt)[0-9¹²³])(?:\.|$)", re.IGNORECASE
)


def file_stem(text: str) -> str:
    """How the name of a file begins that is called after a text, which may be anybody's.

    Every system takes it, and it is no path: ``a < b`` becomes ``a-b``, and ``aux.1`` ``_aux.1``.
    """
    stem = re.sub(r"[^\w.-]+", "-", text).encode(errors="ignore")[:MAX_STEM].decode(errors="ignore")
    stem = stem.lstrip(".")
    return f"_{stem}" if not stem or _DEVICE.match(stem) else stem


def write_bytes(path: Path, data: bytes) -> None:
    """Write ``data`` beside ``path`` and rename it there, so that nobody sees half a file.

    Missing folders are made.

    Raises :class:`UsageError` SC025: the path cannot be written or the disk is full.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        # In the same folder, for a rename is atomic only inside one file system.
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    except OSError as error:
        raise _unwritable(path, error) from None
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        temporary.chmod(0o644)  # mkstemp's 0600 is not what a result file should have
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise _unwritable(path, error) from None


def _unwritable(path: Path, error: OSError) -> UsageError:
    return usage_error("SC025", f"cannot write {path}: {error.strerror or error}")

"""Read files that others wrote: no more than a limit, and nothing that nests without end."""

from __future__ import annotations

import errno
import json
import re
from pathlib import Path
from typing import IO, Any

MAX_NESTING = 100
"""Brackets that may be open at one place of a TOML or JSON file."""

MAX_JSON = 256 << 20
"""Bytes of a JSON file."""

MAX_SHADER = 64 << 20
"""Bytes of a shader."""

_STRING = r'"(?:[^"\\\n]|\\.)*"'
# Strings and comments are matched to be passed over: brackets in them nest nothing. The long
# forms come first, or `"""` would be an empty string and the beginning of another.
_TOML = re.compile(
    r'"""(?:[^\\]|\\.)*?"""' + rf"|'''.*?'''|{_STRING}|'[^'\n]*'|#[^\n]*|[\[\]{{}}]", re.DOTALL
)
_JSON = re.compile(rf"{_STRING}|[\[\]{{}}]", re.DOTALL)


def read_bytes(path: Path, most: int) -> bytes:
    """What is in a file. Raises :class:`OSError` also for one with more than ``most`` bytes, and
    for a path that no file can have."""
    try:
        with path.open("rb") as stream:
            return read_stream(stream, most)
    except ValueError as error:  # a null character in the path
        raise OSError(errno.EINVAL, str(error)) from None


def read_stream(stream: IO[bytes], most: int) -> bytes:
    """What is left of a stream. Raises :class:`OSError` where that has more than ``most`` bytes."""
    # One byte too many tells what is too long; a pipe has no size that could be asked for.
    data = stream.read(most + 1)
    if len(data) > most:
        raise OSError(errno.EFBIG, f"it has more than {most:,} bytes")
    return data


def read_text(path: Path) -> str:
    """The text of a shader. Raises as :func:`read_bytes`, and :class:`ValueError` for no UTF-8."""
    return read_bytes(path, MAX_SHADER).decode("utf-8-sig")


def is_file(path: Path) -> bool:
    """Is it a file? No path is too long to ask."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def toml_nesting(text: str) -> int | None:
    """Where more brackets are open than may be."""
    return _too_deep(text, _TOML)


def read_json(path: Path) -> Any:
    """What a JSON file holds. Raises :class:`OSError` where it cannot be read, :class:`ValueError`
    where it is not JSON or nests too deep."""
    text = read_bytes(path, MAX_JSON).decode("utf-8")
    at = _too_deep(text, _JSON)
    if at is not None:
        line = text.count("\n", 0, at) + 1
        raise ValueError(f"more than {MAX_NESTING} brackets are open in line {line}")
    return json.loads(text)


def _too_deep(text: str, tokens: re.Pattern[str]) -> int | None:
    # Python's readers of JSON and TOML recurse at each bracket, so brackets are counted before.
    depth = 0
    for match in tokens.finditer(text):
        sign = match[0]
        if sign in ("[", "{"):
            depth += 1
            if depth > MAX_NESTING:
                return match.start()
        elif sign in ("]", "}"):
            depth -= 1
    return None

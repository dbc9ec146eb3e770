"""Read typed values out of a TOML table; every mistake becomes a diagnostic at its line.

All mistakes of a file are collected, so that the user mends them in one go.
"""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from shadercache.diagnostics import Diagnostic, InputError, shortened
from shadercache.foreign_files import MAX_NESTING, is_file, read_bytes, toml_nesting
from shadercache.source import Source, Span

_AT = re.compile(r"\(at line (\d+), column (\d+)\)")
_NUMBER = re.compile(r"\[\d+\]")
_HEADER = re.compile(r"^[ \t]*\[+([^\[\]\n]*)\]+", re.MULTILINE)


MAX_SCENE = 1 << 20
"""Bytes of a scene file."""

_MOST_PARTS = 20
"""Parts of the name of a table; those behind are taken for one."""


def read_toml(path: Path) -> tuple[Source, dict[str, Any]]:
    """The text and the tables of a TOML file.

    Raises:
        InputError: SC501 unreadable file, SC502 not TOML.
    """
    try:
        source = Source(str(path), read_bytes(path, MAX_SCENE).decode("utf-8"))
    except OSError as error:
        message = f"cannot read the scene {path}: {error.strerror}"
        raise InputError(Diagnostic("SC501", message)) from None
    except UnicodeDecodeError:
        message = f"the scene {path} is not UTF-8 text"
        raise InputError(Diagnostic("SC501", message)) from None
    at = toml_nesting(source.text)
    if at is not None:
        message = f"more than {MAX_NESTING} brackets are open here"
        raise InputError(Diagnostic("SC502", message, source, Span(at, at + 1)))
    try:
        return source, tomllib.loads(source.text)
    except ValueError as error:  # of TOML, or a number of thousands of digits
        raise InputError(_syntax_error(source, str(error))) from None


def _syntax_error(source: Source, message: str) -> Diagnostic:
    at = _AT.search(message)
    lines = source.text.splitlines(keepends=True)
    if at is None:
        offset = len(source.text)
    else:
        offset = sum(map(len, lines[: int(at[1]) - 1])) + int(at[2]) - 1
    sentence = _AT.sub("", message).strip()
    return Diagnostic("SC502", f"not TOML: {sentence}", source, Span(offset, offset + 1))


def locate(source: Source, table: str, key: str) -> Span | None:
    """Where ``key`` of ``table`` ("" is the top level) stands in the text, as far as can be seen.

    Only the plain spelling is found (``[table]`` and below it ``key =``); tomllib keeps no places.
    Tables of an array are called ``name[0]``, ``name[1]``, ...
    """
    headers = list(_HEADER.finditer(source.text))
    starts = [("", 0), *zip(_full_names(headers), (m.end() for m in headers), strict=True)]
    ends = [start for _, start in starts[1:]] + [len(source.text)]
    for (name, start), end in zip(starts, ends, strict=True):
        if name != table:
            continue
        found = re.search(rf"^[ \t]*{re.escape(key)}[ \t]*=", source.text[start:end], re.MULTILINE)
        if found:
            at = start + found.end() - len(found[0].lstrip())
            return Span(at, at + len(key))
        if table:
            written = len(_NUMBER.sub("", name))
            return Span(start - 1 - written, start - 1)
    return None


def _full_names(headers: list[re.Match[str]]) -> list[str]:
    """The names of tables, those of arrays with their number: ``objects[1].motion``."""
    counts: dict[str, int] = {}
    names: list[str] = []
    for header in headers:
        name = header[1].strip()
        if "[[" in header[0]:
            counts[name] = counts.get(name, -1) + 1
        parts = name.split(".", _MOST_PARTS)
        stems = [".".join(parts[: end + 1]) for end in range(len(parts))]
        marks = [f"[{counts[stem]}]" if stem in counts else "" for stem in stems]
        names.append(".".join(map("".join, zip(parts, marks, strict=True))))
    return names


class Table:
    """One table of a TOML file that notes what was asked for and what was wrong.

    Wrong values yield a harmless stand-in; :meth:`InputError` comes from ``raise_problems``.
    """

    def __init__(
        self,
        source: Source,
        values: Mapping[str, Any],
        name: str = "",
        problems: list[Diagnostic] | None = None,
    ) -> None:
        self.source = source
        self.values = values
        self.name = name
        self.problems: list[Diagnostic] = [] if problems is None else problems
        self._known: set[str] = set()

    def problem(self, code: str, key: str, message: str, hint: str | None = None) -> None:
        """Note a mistake at ``key``."""
        place = locate(self.source, self.name, key)
        self.problems.append(Diagnostic(code, message, self.source, place, hint))

    def full(self, key: str) -> str:
        """The dotted name of a key, as messages print it."""
        return f"{self.name}.{key}" if self.name else key

    def has(self, key: str) -> bool:
        """Whether the table holds the key (marks it as known)."""
        self._known.add(key)
        return key in self.values

    def table(self, key: str) -> Table:
        """A table inside this one; an empty one if it is not there."""
        value = self.values[key] if self.has(key) else {}
        if not isinstance(value, dict):
            self._wrong(key, "a table")
            value = {}
        return Table(self.source, value, self.full(key), self.problems)

    def tables(self, key: str) -> list[Table]:
        """The tables of an array; none if it is not there."""
        value = self.values[key] if self.has(key) else []
        if not (isinstance(value, list) and all(isinstance(item, dict) for item in value)):
            self._wrong(key, "an array of tables")
            value = []
        return [
            Table(self.source, item, f"{self.full(key)}[{number}]", self.problems)
            for number, item in enumerate(value)
        ]

    def text(self, key: str, default: str | None = None, choices: tuple[str, ...] = ()) -> str:
        """A string, one of ``choices`` if given."""
        value = self._get(key, default)
        if isinstance(value, str) and value and (not choices or value in choices):
            return value
        if value is not None:
            self._wrong(key, f"one of {', '.join(choices)}" if choices else "a string")
        return choices[0] if choices else "?"

    def boolean(self, key: str, default: bool) -> bool:
        """True or false."""
        value = self._get(key, default)
        if isinstance(value, bool):
            return value
        self._wrong(key, "true or false")
        return default

    def number(self, key: str, default: float | None = None) -> float:
        """A finite number."""
        value = self._get(key, default)
        if is_number(value):
            return float(value)
        if value is not None:
            self._wrong(key, "a finite number")
        return 1.0

    def whole(self, key: str, default: int | None, least: int) -> int:
        """A whole number not below ``least``."""
        value = self._get(key, default)
        if isinstance(value, int) and not isinstance(value, bool) and value >= least:
            return value
        if value is not None:
            self._wrong(key, f"a whole number from {least} up")
        return least

    def vector(
        self, key: str, default: tuple[float, float, float] | None = None
    ) -> tuple[float, float, float]:
        """Three finite numbers."""
        value = self._get(key, default)
        if isinstance(value, list | tuple) and len(value) == 3 and all(map(is_number, value)):
            return (float(value[0]), float(value[1]), float(value[2]))
        if value is not None:
            self._wrong(key, "three finite numbers")
        return (0.0, 0.0, 1.0)

    def file(self, key: str) -> Path:
        """A path relative to the scene file, which must exist."""
        path = Path(self.source.name).parent / self.text(key)
        if key in self.values and not is_file(path):
            self.problem("SC507", key, f"{self.full(key)}: there is no file {path}")
        return path

    def refuse_unknown(self) -> None:
        """Note every key that nobody asked for: it is most likely misspelt."""
        for key in self.values:
            if key not in self._known:
                known = ", ".join(sorted(self._known))
                message = f"unknown key {self.full(key)}"
                self.problem("SC504", key, message, hint=f"known here: {known}")

    def raise_problems(self) -> None:
        """Raise what was noted, if anything was."""
        if self.problems:
            raise InputError(self.problems)

    def _get(self, key: str, default: Any) -> Any:
        if self.has(key):
            return self.values[key]
        if default is None:
            self.problem("SC503", key, f"{self.full(key)} is missing")
        return default

    def _wrong(self, key: str, wanted: str) -> None:
        got = self.values.get(key)
        self.problem("SC505", key, f"{self.full(key)} must be {wanted}, not {shortened(repr(got))}")


def is_number(value: Any) -> bool:
    """Whether a TOML value is a finite number (a boolean is not)."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return -sys.float_info.max <= value <= sys.float_info.max

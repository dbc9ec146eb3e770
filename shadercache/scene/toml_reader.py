"""Typed values of a TOML file; its mistakes are collected, each a diagnostic at its line."""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from shadercache.diagnostics import Diagnostic, InputError, input_error, shortened
from shadercache.foreign_files import MAX_NESTING, is_file, read_bytes, toml_nesting
from shadercache.source import Source, Span

_AT = re.compile(r"\(at line (\d+), column (\d+)\)")
_NUMBER = re.compile(r"\[\d+\]")
_HEADER = re.compile(r"^[ \t]*\[+([^\[\]\n]*)\]+", re.MULTILINE)

MAX_SCENE = 1 << 20
"""Bytes of a scene file."""

# The stems of a name are quadratic in its parts, and a file may hold a million dots.
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
        raise input_error("SC501", f"cannot read the scene {path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise input_error("SC501", f"the scene {path} is not UTF-8 text") from None
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
    # tomllib gives no place where a text ends too early.
    offset = len(source.text)
    if at is not None:
        lines = source.text.splitlines(keepends=True)
        offset = sum(map(len, lines[: int(at[1]) - 1])) + int(at[2]) - 1
    sentence = _AT.sub("", message).strip()
    return Diagnostic("SC502", f"not TOML: {sentence}", source, Span(offset, offset + 1))


def locate(source: Source, table: str, key: str) -> Span | None:
    """Where ``key`` of ``table`` ("" is the top level) stands in the text, as far as can be seen.

    Tables of an array are called ``name[0]``, ``name[1]``, ...
    """
    # tomllib keeps no places. Only the plain spelling is found: [table], and below it key = ...
    headers = list(_HEADER.finditer(source.text))
    starts = [("", 0), *zip(_full_names(headers), (m.end() for m in headers), strict=True)]
    ends = [start for _, start in starts[1:]] + [len(source.text)]
    for (name, start), end in zip(starts, ends, strict=True):
        if name != table:
            continue
        match = re.search(rf"^[ \t]*{re.escape(key)}[ \t]*=", source.text[start:end], re.MULTILINE)
        if match:
            at = start + match.end() - len(match[0].lstrip())
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
    """One table of a TOML file, which notes what it is asked for and what is wrong.

    What is wrong or missing has a harmless stand-in, so that reading goes on.
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
        self._inner: list[Table] = []

    def problem(self, code: str, key: str, message: str, hint: str | None = None) -> None:
        """Note a mistake at ``key``."""
        place = locate(self.source, self.name, key)
        self.problems.append(Diagnostic(code, message, self.source, place, hint))

    def require(self, holds: bool, key: str, message: str) -> None:
        """Note SC505 at ``key`` unless a rule between values holds."""
        if not holds:
            self.problem("SC505", key, message)

    def finish(self) -> None:
        """Raise InputError with all that is wrong here and in the tables inside, if anything is."""
        self._refuse_unknown()
        if self.problems:
            raise InputError(self.problems)

    def full(self, key: str) -> str:
        """The dotted name of a key, as messages print it."""
        return f"{self.name}.{key}" if self.name else key

    def has(self, key: str) -> bool:
        """Whether the table holds the key; from now on it is a known one."""
        self._known.add(key)
        return key in self.values

    def items(self) -> Iterator[tuple[str, Any]]:
        """Keys and values of a table whose keys are the user's own names."""
        self._known.update(self.values)
        yield from self.values.items()

    def table(self, key: str) -> Table:
        """A table inside this one; an empty one if it is not there."""
        value = self.checked(key, "a table", lambda value: isinstance(value, dict), {})
        return self._open(value, self.full(key))

    def tables(self, key: str) -> list[Table]:
        """The tables of an array; none if it is not there."""
        value = self.checked(key, "an array of tables", _list_of(lambda v: isinstance(v, dict)), [])
        return [self._open(entry, f"{self.full(key)}[{at}]") for at, entry in enumerate(value)]

    def text(self, key: str, default: str | None = None, choices: tuple[str, ...] = ()) -> str:
        """A string, one of ``choices`` if given."""
        wanted = f"one of {', '.join(choices)}" if choices else "a string"

        def is_right(value: Any) -> bool:
            return isinstance(value, str) and bool(value) and (not choices or value in choices)

        return str(self.checked(key, wanted, is_right, default, choices[0] if choices else "?"))

    def texts(self, key: str) -> tuple[str, ...]:
        """An array of strings; an empty one if it is not there."""
        right = _list_of(lambda value: isinstance(value, str))
        return tuple(self.checked(key, "an array of strings", right, ()))

    def boolean(self, key: str, default: bool) -> bool:
        """True or false."""
        right = self.checked(key, "true or false", lambda value: isinstance(value, bool), default)
        return bool(right)

    def number(self, key: str, default: float | None = None) -> float:
        """A finite number."""
        return float(self.checked(key, "a finite number", is_number, default, 1.0))

    def whole(self, key: str, default: int | None, least: int) -> int:
        """A whole number not below ``least``."""
        wanted = f"a whole number from {least} up"
        return int(
            # For isinstance true and false are integers.
            self.checked(key, wanted, lambda v: type(v) is int and v >= least, default, least)
        )

    def vector(
        self, key: str, default: tuple[float, float, float] | None = None
    ) -> tuple[float, float, float]:
        """Three finite numbers."""
        wanted = "three finite numbers"
        x, y, z = self.checked(key, wanted, lambda v: is_numbers(v, 3), default, (0.0, 0.0, 1.0))
        return float(x), float(y), float(z)

    def rows(
        self, key: str, wanted: str, is_row: Callable[[Any], bool], least: int = 0
    ) -> list[tuple[Any, ...]]:
        """An array of arrays that are right each, at ``least`` so many; none if it is not there."""
        right = _list_of(is_row)
        value = self.checked(key, wanted, lambda v: right(v) and len(v) >= least, [])
        return [tuple(row) for row in value]

    def file(self, key: str, default: Path | None = None) -> Path:
        """A path relative to the scene file, which must exist; or ``default``."""
        if default is not None and not self.has(key):
            return default
        path = Path(self.source.name).parent / self.text(key)
        if key in self.values and not is_file(path):
            self.problem("SC507", key, f"{self.full(key)}: there is no file {path}")
        return path

    def optional_file(self, key: str) -> Path | None:
        """The same, or None where the key is not there."""
        return self.file(key) if self.has(key) else None

    def checked(
        self,
        key: str,
        wanted: str,
        is_right: Callable[[Any], bool],
        default: Any = None,
        stand_in: Any = None,
    ) -> Any:
        """What stands at ``key``, or ``default`` where nothing does (None: something must).

        In place of what is wrong or missing comes ``stand_in``, or ``default``.
        """
        harmless = default if stand_in is None else stand_in
        if not self.has(key):
            if default is not None:
                return default
            self.problem("SC503", key, f"{self.full(key)} is missing")
            return harmless
        value = self.values[key]
        if is_right(value):
            return value
        message = f"{self.full(key)} must be {wanted}, not {shortened(repr(value))}"
        self.problem("SC505", key, message)
        return harmless

    def _open(self, values: Mapping[str, Any], name: str) -> Table:
        inner = Table(self.source, values, name, self.problems)
        self._inner.append(inner)
        return inner

    def _refuse_unknown(self) -> None:
        """Note every key that nobody asked for: it is most likely misspelt."""
        for key in self.values:
            if key not in self._known:
                hint = f"known here: {', '.join(sorted(self._known))}"
                self.problem("SC504", key, f"unknown key {self.full(key)}", hint)
        for table in self._inner:
            table._refuse_unknown()


def is_number(value: Any) -> bool:
    """Whether a TOML value is a finite number (a boolean is not)."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    # NaN fails this, and so do integers that no float can hold.
    return -sys.float_info.max <= value <= sys.float_info.max


def is_numbers(value: Any, count: int) -> bool:
    """Whether it is an array of so many finite numbers."""
    return isinstance(value, list) and len(value) == count and all(map(is_number, value))


def _list_of(is_right: Callable[[Any], bool]) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, list) and all(map(is_right, value))

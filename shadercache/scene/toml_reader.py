"""Typed values of a TOML file; its mistakes are collected, each a diagnostic at its line."""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Callable, Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from shadercache.diagnostics import Diagnostic, InputError, input_error, shortened
from shadercache.foreign_files import MAX_NESTING, is_file, read_bytes, toml_nesting
from shadercache.scene.toml_places import locate
from shadercache.source import Source, Span

_AT = re.compile(r"\(at line (\d+), column (\d+)\)")
# What looks like a value, but is no TOML.
_BARE_WORD = re.compile(r"=\s*([A-Za-z_./\\][\w./\\-]*)\s*(?:#.*)?$")
_BARE_KEY = re.compile(r"\s*([A-Za-z_][\w.\[\]]*[\[\]][\w.\[\]]*)\s*=")

MAX_SCENE = 1 << 20
"""Bytes of a scene file."""


def read_toml(path: Path) -> tuple[Source, dict[str, Any]]:
    """The text and the tables of a scene file.

    Raises:
        InputError: SC501 unreadable file, SC502 not TOML.
    """
    source = read_described(path, "scene", MAX_SCENE)
    return source, parsed(source)


def read_described(path: Path, what: str, most: int) -> Source:
    """The text of a file; ``what`` it is for the message, ``most`` bytes it may have.

    Raises:
        InputError: SC501, it cannot be read.
    """
    try:
        return Source(str(path), read_bytes(path, most).decode("utf-8-sig"))
    except OSError as error:
        raise input_error("SC501", f"cannot read the {what} {path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise input_error("SC501", f"the {what} {path} is not UTF-8 text") from None


def parsed(source: Source) -> dict[str, Any]:
    """The tables of a TOML text. Raises :class:`InputError` SC502 for what is none."""
    at = toml_nesting(source.text)
    if at is not None:
        message = f"more than {MAX_NESTING} brackets are open here"
        raise InputError(Diagnostic("SC502", message, source, Span(at, at + 1)))
    try:
        return tomllib.loads(source.text)
    except ValueError as error:  # of TOML, or a number of thousands of digits
        raise InputError(_syntax_error(source, str(error))) from None


def _syntax_error(source: Source, message: str) -> Diagnostic:
    at = _AT.search(message)
    # tomllib gives no place where a text ends too early.
    offset, line = len(source.text), ""
    if at is not None:
        lines = source.text.splitlines(keepends=True)
        offset = sum(map(len, lines[: int(at[1]) - 1])) + int(at[2]) - 1
        # An error at the end of a line may be told of the next one.
        line = lines[int(at[1]) - 1] if int(at[1]) <= len(lines) else ""
    sentence = _AT.sub("", message).strip()
    return Diagnostic(
        "SC502", f"not TOML: {sentence}", source, Span(offset, offset + 1), _meant(line, sentence)
    )


def _meant(line: str, sentence: str) -> str | None:
    """What should stand in a line that is not TOML."""
    key, value = _BARE_KEY.match(line), _BARE_WORD.search(line)
    if key is not None:
        return f'a name with brackets stands in quotes: "{key[1]}" = ...'
    if value is not None and value[1] in ("True", "False"):
        return f"write {value[1].lower()}"
    if value is not None:
        return f'a text stands in quotes: "{value[1]}"'
    if "overwrite" in sentence or "mutate" in sentence or "twice" in sentence:
        return 'each key stands once; the name of a member has a dot in quotes: "camera.view" = ...'
    return None


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
        text = self.text(key)
        path = Path(self.source.name).parent / text
        if key in self.values and not is_file(path):
            hint = "write / between folders: every system takes that"
            message = f"{self.full(key)}: there is no file {path}"
            self.problem("SC507", key, message, hint if "\\" in text else None)
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
        message = f"{self.full(key)} must be {wanted}, not {shortened(_as_toml(value))}"
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
                near = get_close_matches(key, self._known, 1)
                meant = f"did you mean {near[0]}? " if near else ""
                hint = f"{meant}known here: {', '.join(sorted(self._known))}"
                self.problem("SC504", key, f"unknown key {self.full(key)}", hint)
        for table in self._inner:
            table._refuse_unknown()


def _as_toml(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else repr(value)


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

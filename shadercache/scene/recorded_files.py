"""Files of what an engine had for uniforms, frame by frame: CSV and TOML (docs/SCENES.md)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, NoReturn, TypeAlias

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.scene.object_inputs import constant_of
from shadercache.scene.toml_places import locate
from shadercache.scene.toml_reader import Table, parsed
from shadercache.source import Source, Span

CUT = "cut"
"""The column, or the key, that says whether the camera jumps."""

_MOST_TOLD = 20
"""Mistakes of a header that are told."""

_NUMBER = re.compile(r"\[(\d+)\]$")
_FRAME = re.compile(r"^[ \t]*\[\[[ \t]*frames[ \t]*\]\]", re.MULTILINE)
# The numbers of a header are few; more digits are no place among them.
_MOST_DIGITS = 9


class RecordedName(NamedTuple):
    """A uniform that was recorded; of one object, or of all that have it."""

    object: str | None
    name: str

    def __str__(self) -> str:
        """As a file's header names it."""
        return self.name if self.object is None else f"{self.object}/{self.name}"


@dataclass(frozen=True, eq=False)
class RecordedFile:
    """The numbers of each uniform (frames, numbers), where its name stands, and the cuts."""

    source: Source
    values: Mapping[RecordedName, NDArray[np.float64]]
    places: Mapping[RecordedName, Span | None]
    cuts: frozenset[int]

    def problem(self, code: str, key: RecordedName, message: str, hint: str | None) -> Diagnostic:
        """Something that is wrong with a uniform, at its name."""
        return Diagnostic(code, message, self.source, self.places.get(key), hint)


def from_csv(source: Source) -> RecordedFile:
    """A row of names, then a row of numbers for each frame.

    Raises:
        InputError: SC550 for what is missing, no number, or has no place.
    """
    head, *lines = source.text.rstrip().split("\n")
    if not head:
        raise _too_few(source, 0)
    cells = list(_cells(head, 0))
    columns, cut = _columns(source, cells)
    rows = np.array(list(_rows(source, len(head) + 1, lines, cells)), np.float64)
    if len(rows) < 2:
        raise _too_few(source, len(rows))
    cuts = frozenset[int]()
    if cut is not None:
        cuts = frozenset(np.flatnonzero(rows[:, cut]).tolist())
    values = {key: rows[:, places] for key, places in columns.items()}
    named = {key: cells[places[0]].span for key, places in columns.items()}
    # Places are in the first line alone, so the rest of a long text can go.
    return RecordedFile(Source(source.name, head), values, named, cuts)


def from_toml(source: Source) -> RecordedFile:
    """A table for each frame: ``[[frames]]`` with numbers by name, ``[frames.objects.NAME]``.

    Raises:
        InputError: SC502, SC504, SC505 as for scenes; SC550 for frames that differ in what they
            have.
    """
    top = Table(source, parsed(source))
    read: dict[RecordedName, list[tuple[float, ...]]] = {}
    cuts: list[int] = []
    tables = top.tables("frames")
    for number, table in enumerate(tables):
        if table.boolean(CUT, False):
            cuts.append(number)
        frame = dict(_numbers(table))
        if number == 0:
            read = {key: [] for key in frame}
        _compare(table, frame, {key: rows[0] for key, rows in read.items() if rows})
        # Of many frames the first that is wrong tells enough.
        if top.problems:
            raise InputError(top.problems)
        for key, values in frame.items():
            read[key].append(values)
    top.finish()
    if len(tables) < 2:
        raise _too_few(source, len(tables))
    first = _first_frame(source)
    return RecordedFile(
        first,
        {key: np.array(rows, np.float64) for key, rows in read.items()},
        {key: locate(first, _table("frames[0]", key), key.name) for key in read},
        frozenset(cuts),
    )


class _Cell(NamedTuple):
    text: str
    span: Span


def _cells(line: str, start: int) -> Iterator[_Cell]:
    """What stands between the commas of a line, without spaces and quotes around it."""
    at = start
    for part in line.split(","):
        text = part.strip().strip('"').strip()
        begin = at + (part.find(text) if text else 0)
        yield _Cell(text, Span(begin, begin + len(text)))
        at += len(part) + 1


def _columns(
    source: Source, header: Sequence[_Cell]
) -> tuple[dict[RecordedName, list[int]], int | None]:
    """The columns of each uniform in the order of its numbers, and that of cuts."""
    found: dict[RecordedName, dict[int, int]] = {}
    cut: int | None = None
    problems: list[Diagnostic] = []

    def problem(span: Span, message: str) -> None:
        problems.append(Diagnostic("SC550", message, source, span))

    if len(header) == 1 and re.search(r"[;\t]", header[0].text):
        problem(header[0].span, "columns are parted by commas")
    for column, (text, span) in enumerate(header):
        number = _NUMBER.search(text)
        owner, slash, name = text[: number.start() if number else None].rpartition("/")
        place = int(number[1][:_MOST_DIGITS]) if number else 0
        numbers = found.setdefault(RecordedName(owner if slash else None, name), {})
        if not name:
            problem(span, f"column {column + 1} has no name")
        elif place in numbers or (text == CUT and cut is not None):
            problem(span, f"the column {text} is there twice")
        elif text == CUT:
            cut = column
        else:
            numbers[place] = column
    known = {key: numbers for key, numbers in found.items() if numbers}
    for key, numbers in known.items():
        gap = next(place for place in range(len(numbers) + 1) if place not in numbers)
        if gap < len(numbers):
            column = min(numbers.values())
            problem(header[column].span, f"{key} has {len(numbers)} columns, but no {key}[{gap}]")
    if not known and not problems:
        problem(Span(0, 1), "no column is a uniform")
    if problems:
        raise InputError(problems[:_MOST_TOLD])
    return {key: [numbers[at] for at in range(len(numbers))] for key, numbers in known.items()}, cut


def _rows(
    source: Source, start: int, lines: Sequence[str], header: Sequence[_Cell]
) -> Iterator[NDArray[np.float64]]:
    """The numbers of each line; the first line begins at ``start``."""
    cut = next((column for column, cell in enumerate(header) if cell.text == CUT), None)
    for line in lines:
        try:
            row = np.array(list(map(float, line.split(","))))
        except ValueError:  # a mistake, or numbers in quotes
            row = np.array([])
        flags = cut is None or cut >= len(row) or row[cut] in (0.0, 1.0)
        if len(row) != len(header) or not np.isfinite(row).all() or not flags:
            row = np.array(list(_one_by_one(source, list(_cells(line, start)), header)))
        yield row
        start += len(line) + 1


def _one_by_one(source: Source, cells: Sequence[_Cell], header: Sequence[_Cell]) -> Iterator[float]:
    """The numbers of a line. Raises :class:`InputError` SC550 at the first that is none."""

    def refuse(span: Span, message: str) -> NoReturn:
        raise InputError(Diagnostic("SC550", message, source, span))

    for cell, name in zip(cells, header, strict=False):
        if not cell.text:
            refuse(cell.span, f"{name.text} is blank")
        try:
            number = float(cell.text)
        except ValueError:
            refuse(cell.span, f"{name.text} must be a number, not {cell.text!r}")
        if not np.isfinite(number):
            refuse(cell.span, f"{name.text} must be a finite number, not {cell.text}")
        if name.text == CUT and number not in (0.0, 1.0):
            refuse(cell.span, f"{CUT} must be 0 or 1, not {cell.text}")
        yield number
    if len(cells) != len(header):
        extra = cells[len(header)].span if len(cells) > len(header) else cells[-1].span
        refuse(extra, f"cells: {len(cells)} in this line, {len(header)} in the first")


_Frame: TypeAlias = Mapping[RecordedName, tuple[float, ...]]


def _numbers(table: Table) -> Iterator[tuple[RecordedName, tuple[float, ...]]]:
    """What the table of a frame has for uniforms."""
    wanted = "a finite number, or an array of them"

    def read(inner: Table, name: str) -> tuple[float, ...]:
        value = inner.checked(name, wanted, lambda v: bool(constant_of(v)), stand_in=0.0)
        return constant_of(value)

    for name, _ in table.items():
        if name not in (CUT, "objects"):
            yield RecordedName(None, name), read(table, name)
    objects = table.table("objects")
    for owner, _ in objects.items():
        inner = objects.table(owner)
        for name, _ in inner.items():
            yield RecordedName(owner, name), read(inner, name)


def _compare(
    table: Table,
    frame: Mapping[RecordedName, tuple[float, ...]],
    first: Mapping[RecordedName, tuple[float, ...]],
) -> None:
    """Note what a frame has more, less, or in another number than the first."""
    if not frame:
        table.problem("SC550", "", f"{table.name} has no uniform")
    if not first or table.problems:
        return
    for key in first.keys() - frame.keys():
        table.problem("SC550", "", f"{table.name} has no {key}, which frames[0] has")
    for key, numbers in frame.items():
        wanted = len(first.get(key, ()))
        if len(numbers) != wanted:
            message = f"numbers of {key}: {len(numbers)} here, {wanted or 'none'} in frames[0]"
            place = locate(table.source, _table(table.name, key), key.name)
            table.problems.append(Diagnostic("SC550", message, table.source, place))


def _first_frame(source: Source) -> Source:
    """The text up to the second frame: names are looked for there, and a recording may be long."""
    headers = list(_FRAME.finditer(source.text))
    return Source(source.name, source.text[: headers[1].start()]) if headers[1:] else source


def _table(frame: str, key: RecordedName) -> str:
    return frame if key.object is None else f"{frame}.objects.{key.object}"


def _too_few(source: Source, count: int) -> InputError:
    message = f"a recording has two frames at least, and this has {count or 'none'}"
    return InputError(Diagnostic("SC550", message, source))

"""Source text and places in it.

Spans are pairs of character offsets into one text and the files that it includes; lines and
columns are computed only when a diagnostic is printed.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

_LINE_END = re.compile(r"\r\n?|\n")
_LONE = re.compile("[\ud800-\udc7f\udd00-\udfff]")


class Span(NamedTuple):
    """Half-open range ``[start, end)`` of character offsets into a source text."""

    start: int
    end: int

    def to(self, other: Span) -> Span:
        """The smallest span that holds both."""
        return Span(min(self.start, other.start), max(self.end, other.end))


NOWHERE = Span(-1, -1)
"""Span of a node that no source text holds (made by a rewrite)."""


class Position(NamedTuple):
    """A place as people count it: line and column start at 1, columns count characters."""

    line: int
    column: int


def as_text(name: str) -> str:
    """A file's name for what is written as UTF-8, which not every name can be.

    Bytes that the locale cannot read are escaped in it; here they are read as UTF-8.
    """
    data = _LONE.sub("\ufffd", name).encode(errors="surrogateescape")
    return data.decode(errors="replace")


@dataclass(frozen=True, eq=False)
class Source:
    """A named text, as the user wrote it (``name`` is what diagnostics print).

    A text may include other files. Each becomes a part of this source: its offsets continue behind
    those of the parts before it, so that any place is one number. ``base`` is the offset where a
    part begins, ``origin`` the place of the ``#include`` that first asked for it.
    """

    name: str
    text: str
    base: int = 0
    origin: int | None = None
    _parts: list[Source] = field(default_factory=list, repr=False)

    def include(self, name: str, text: str, origin: int) -> Source:
        """The part for an included file; the same part for the same file."""
        # The same part: `#pragma once` knows it by identity, and each of its mistakes is told once.
        for part in self._parts:
            if part.name == name and part.text == text:
                return part
        last = self._parts[-1] if self._parts else self
        # One more than the text has: the end of a file is a place, too.
        part = Source(name, text, last.base + len(last.text) + 1, origin)
        self._parts.append(part)
        return part

    def part(self, offset: int) -> Source:
        """The file that holds a place: this one, or an included one."""
        if not self._parts or offset < self._parts[0].base:
            return self
        # Parts are appended in the order of their bases.
        return self._parts[bisect_right(self._parts, offset, key=lambda part: part.base) - 1]

    def position(self, offset: int) -> Position:
        """Line and column of a place in its file (clamped to the text)."""
        part = self.part(offset)
        offset = max(0, min(offset - part.base, len(part.text)))
        line = bisect_right(part._line_starts, offset)
        return Position(line, offset - part._line_starts[line - 1] + 1)

    def line(self, number: int) -> str:
        """The text of line ``number`` (from 1) of this file, without its line ending."""
        start = self._line_starts[number - 1]
        end = self._line_starts[number] if number < len(self._line_starts) else len(self.text)
        return self.text[start:end].rstrip("\r\n")

    def excerpt(self, span: Span) -> str:
        """The text of a span. One that runs on into another file is cut at the end of its line."""
        part = self.part(span.start)
        start = span.start - part.base
        if span.end <= part.base + len(part.text):
            return part.text[start : span.end - part.base]
        return part.line(self.position(span.start).line)[self.position(span.start).column - 1 :]

    @cached_property
    def _line_starts(self) -> list[int]:
        if "\r" in self.text:
            return [0, *(match.end() for match in _LINE_END.finditer(self.text))]
        # Nearly all files, and no carriage return: a search for one character beats the pattern.
        starts = [0]
        find = self.text.find
        at = find("\n")
        while at >= 0:
            starts.append(at + 1)
            at = find("\n", at + 1)
        return starts

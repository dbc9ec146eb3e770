"""What the user is told, and the exceptions that carry it.

A mistake of the user becomes a :class:`Diagnostic`; internal errors stay plain exceptions. Each
exception class below stands for one exit code of the command line.

Code ranges: SC0xx files and arguments, SC1xx syntax, SC2xx names and types, SC3xx refused nodes,
SC4xx shaders that cannot be cached, SC5xx scenes, SC6xx OpenGL and rendering.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from shadercache.source import Source, Span

MAX_SHOWN = 200
"""Characters of a source line that a diagnostic shows."""

MAX_QUOTED = 60
"""Characters of a name or text that a message quotes."""

MAX_MESSAGE = 500
"""Characters of a message or hint."""

# A little longer than what is left of one, so that a checksum in the name of a file stays whole.
_LONG_WORD = re.compile(r"\w{73,}")


class Severity(StrEnum):
    """How bad it is. Only an error rejects the input."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One message for the user, with its place in the source where there is one."""

    code: str
    message: str
    source: Source | None = None
    span: Span | None = None
    hint: str | None = None
    severity: Severity = Severity.ERROR

    def __post_init__(self) -> None:
        """Shorten what is said: the names and numbers that it quotes may be of any length."""
        object.__setattr__(self, "message", _readable(self.message))
        object.__setattr__(self, "hint", self.hint and _readable(self.hint))

    def render(self) -> str:
        """``file:line:col: error: message [SCnnn]``, the source line and a caret, the hint."""
        place = "" if self.source is None else f"{self.source.name}: "
        if self.source is not None and self.span is not None:
            place = f"{_place(self.source, self.span.start)}: "
        lines = [f"{place}{self.severity}: {self.message} [{self.code}]"]
        if self.source is not None and self.span is not None:
            lines += snippet(self.source, self.span)
            lines += _included(self.source, self.span)
        if self.hint:
            lines.append(f"  hint: {self.hint}")
        return "\n".join(lines)

    def to_json(self) -> dict[str, Any]:
        """A plain dictionary: file, line, column, severity, message, code, hint."""
        place: dict[str, Any] = {"file": self.source.name if self.source else None}
        if self.source is not None and self.span is not None:
            part = self.source.part(self.span.start)
            place["file"] = part.name
            line, column = self.source.position(self.span.start)
            # A span that runs on into another file ends with its own.
            end = min(self.span.end, part.base + len(part.text))
            end_line, end_column = self.source.position(end)
            place |= {"line": line, "column": column}
            place |= {"end_line": end_line, "end_column": end_column}
        return place | {
            "severity": str(self.severity),
            "message": self.message,
            "code": self.code,
            "hint": self.hint,
        }


def snippet(source: Source, span: Span) -> list[str]:
    """The line of source in which a span begins, and one that underlines it."""
    line, column = source.position(span.start)
    text, column = _window(source.part(span.start).line(line), column)
    # An empty span, where something is missing, has a caret too; one of several lines ends with the
    # first.
    width = max(1, min(span.end - span.start, len(text) - column + 1))
    # Tabs are kept in the padding, so that the caret stands right at any tab width.
    pad = "".join("\t" if char == "\t" else " " for char in text[: column - 1])
    gutter = f"{line:5d} | "
    return [gutter + text, " " * (len(gutter) - 2) + "| " + pad + "^" + "~" * (width - 1)]


def _included(source: Source, span: Span) -> list[str]:
    """Where the file was included, if it was."""
    lines = []
    origin = source.part(span.start).origin
    while origin is not None:
        lines.append(f"  included at {_place(source, origin)}")
        origin = source.part(origin).origin
    return lines


def shortened(text: str, limit: int = MAX_QUOTED) -> str:
    """``text``, or its beginning and ``…`` where it has more than ``limit`` characters."""
    return text if len(text) <= limit else f"{text[: limit - 1]}…"


def _readable(message: str) -> str:
    return shortened(_LONG_WORD.sub(lambda word: shortened(word[0]), message), MAX_MESSAGE)


def _window(text: str, column: int) -> tuple[str, int]:
    """A line and a column in it; of a very long line only what stands around the column."""
    if len(text) <= MAX_SHOWN:
        return text, column
    start = max(0, min(column - 1, len(text)) - MAX_SHOWN // 2)
    before = "..." if start else ""
    after = "..." if start + MAX_SHOWN < len(text) else ""
    return f"{before}{text[start : start + MAX_SHOWN]}{after}", column - start + len(before)


def _place(source: Source, offset: int) -> str:
    line, column = source.position(offset)
    return f"{source.part(offset).name}:{line}:{column}"


class DiagnosticError(Exception):
    """Base of every error that the user is told about, with the exit code it leads to."""

    exit_code = 1

    def __init__(self, diagnostics: Diagnostic | Iterable[Diagnostic]) -> None:
        if isinstance(diagnostics, Diagnostic):
            diagnostics = (diagnostics,)
        self.diagnostics = tuple(diagnostics)
        super().__init__(*self.diagnostics[:1])

    def __str__(self) -> str:
        """All that is told, one below the other."""
        return "\n".join(diagnostic.render() for diagnostic in self.diagnostics)

    def __reduce__(self) -> tuple[type[DiagnosticError], tuple[tuple[Diagnostic, ...]]]:
        """What another process needs to raise it again: the diagnostics, not their text."""
        return type(self), (self.diagnostics,)


class InputError(DiagnosticError):
    """The input is rejected or a law is broken (exit code 1)."""


class UsageError(DiagnosticError):
    """The command cannot be carried out as asked (exit code 2)."""

    exit_code = 2


class GraphicsError(DiagnosticError):
    """There is no usable OpenGL (exit code 3)."""

    exit_code = 3


def input_error(code: str, message: str, hint: str | None = None) -> InputError:
    """An :class:`InputError` with one message that has no place in a source."""
    return InputError(Diagnostic(code, message, hint=hint))


def usage_error(code: str, message: str, hint: str | None = None) -> UsageError:
    """A :class:`UsageError` with one message."""
    return UsageError(Diagnostic(code, message, hint=hint))

"""The preprocessor: ``#version``, conditions, macros, included files and kept directives.

Before::

    #version 330
    #define TAU (2.0 * PI)
    #ifdef SLOW
    float turn = 0.0;
    #else
    float turn = TAU;
    #endif

After: version 330 and the lexemes ``float turn = ( 2.0 * PI ) ;`` where the five of the macro all
have the place of its use. A directive is handled by the entry of :data:`_HANDLERS` with its name;
one without an entry is refused.

Source: The OpenGL Shading Language 4.60, section 3.3; GLSL ES 3.20, section 3.4.
"""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from shadercache.ast.nodes import Directive
from shadercache.diagnostics import Diagnostic, InputError, shortened
from shadercache.foreign_files import is_file
from shadercache.front.preprocess import include
from shadercache.front.preprocess.directive_errors import (
    LIMIT_HINT,
    DirectiveError,
    RunawayError,
    StopReading,
)
from shadercache.front.preprocess.directives import CONDITIONALS, HANDLERS, Line
from shadercache.front.preprocess.macros import define
from shadercache.front.preprocess.reading_state import OpenFile, ReadingState
from shadercache.front.preprocess.scanner import Lexemes, clean
from shadercache.front.preprocess.version import (
    NO_VERSION,
    Version,
    check_place,
    joins_comments,
    read_version,
    version_line,
)
from shadercache.front.read_options import DEFAULTS, ReadOptions
from shadercache.source import Source, Span

MAX_ERRORS = 100
"""Mistakes that are told; after that many no one reads on."""

_DIRECTIVE = re.compile(r"^[ \t\v\f\r]*#[^\n]*", re.MULTILINE)
_PARTS = re.compile(r"\s*#\s*(\w*)\s*(.*)", re.DOTALL | re.ASCII)
_ANY_CHARACTER = frozenset(("define", "error", "include", "pragma"))


@dataclass(frozen=True, slots=True)
class Preprocessed:
    """What the preprocessor makes of a file."""

    version: int
    profile: str | None
    directives: tuple[Directive, ...]
    lexemes: Lexemes


def preprocess(
    source: Source, options: ReadOptions = DEFAULTS, default: Version = NO_VERSION
) -> Preprocessed:
    """Read the directives of a file, take the groups that hold, and expand the macros.

    ``default`` is the version of a file that names none. Raises :class:`InputError` with every
    error it finds.
    """
    prepared, errors = preprocess_broken(source, options, default)
    if errors:
        raise InputError(errors)
    return prepared


def preprocess_broken(
    source: Source, options: ReadOptions, default: Version
) -> tuple[Preprocessed, list[Diagnostic]]:
    """:func:`preprocess` for a file that may be broken: what can be made of it, and its errors."""
    reader = _Reader(source, options, default)
    with suppress(StopReading):
        reader.read_source()
    # A file that is included twice has each mistake once.
    errors = {(error.span, error.message): error for error in reader.errors}.values()
    version = reader.state.version
    directives = tuple(reader.state.directives)
    prepared = Preprocessed(version.number, version.profile, directives, reader.lexemes)
    return prepared, sorted(errors, key=lambda error: error.span or Span(-1, -1))


class _Reader:
    """Reads the files from top to bottom."""

    def __init__(self, source: Source, options: ReadOptions, default: Version) -> None:
        self.source = source
        self.options = options
        self.state = ReadingState(source, options, default)
        self.expander, self.macros = self.state.expander, self.state.macros
        self.errors: list[Diagnostic] = []
        self.lexemes = Lexemes()
        self._joined = joins_comments(source.text)
        self._room = include.MAX_TEXT

    def tell(self, mistake: DirectiveError, span: Span) -> None:
        """Note a mistake, and go on if that makes sense."""
        error = Diagnostic(mistake.code, mistake.message, self.source, span, mistake.hint)
        self.errors.append(error)
        if isinstance(mistake, RunawayError) or len(self.errors) >= MAX_ERRORS:
            raise StopReading

    # --- files

    def read_source(self) -> None:
        """Read the user's own file."""
        text = clean(self.source, self._joined, self.errors, self.source)
        path = Path(self.source.name)
        folder = path.parent if is_file(path) else None
        self.state.files.append(OpenFile(self.source, text, folder))
        begin = 0
        if place := version_line(text.text):
            begin = place[1]
            line = text.text[slice(*place)].rstrip()
            span = text.span(place[0], place[0] + len(line))
            try:
                self.state.version = read_version(line.partition("version")[2].strip())
                check_place(self.state.version, self.source.text[: span.start])
            except DirectiveError as mistake:
                self.tell(mistake, span)
        self.state.define_first_macros()
        self.define_macros()
        self.expander.allow(len(self.source.text))
        self.read_file(begin)

    def read_included(self, path: Path) -> None:
        """Read a file that an ``#include`` names, unless it is to be read once only."""
        state, text = self.state, include.read(path, self._room)
        self._room -= max(len(text), include.MIN_TEXT)
        part = self.source.include(str(path), text, state.place.start)
        if part not in state.once:
            cleaned = clean(part, self._joined, self.errors, self.source)
            state.files.append(OpenFile(part, cleaned, path.parent))
            state.set_file_number("0")
            self.expander.allow(len(text))
            self.read_file(0)
            state.files.pop()
            state.set_file_number(state.file.number)

    def define_macros(self) -> None:
        """Define the macros that the user's options ask for."""
        for name, value in self.options.defines:
            try:
                macro = define(f"{name} {value}")
            except DirectiveError as mistake:
                message = f"cannot define '{name}': {mistake.message}"
                self.errors.append(Diagnostic(mistake.code, message, hint=mistake.hint))
            else:
                self.macros[macro.name] = macro

    def read_file(self, at: int) -> None:
        """Read the innermost open file from an offset on."""
        text, groups = self.state.file.text.text, self.state.file.groups
        for match in _DIRECTIVE.finditer(text, at):
            if groups.live:
                self.read_code(at, match.start())
            self.read_directive(match)
            at = match.end()
        if groups.live:
            self.read_code(at, len(text))
        if groups:
            hint = f"nor have the {len(groups) - 1} around it" if groups[1:] else None
            mistake = DirectiveError("SC121", "this condition has no #endif", hint)
            self.tell(mistake, groups[-1].span)

    # --- code

    def read_code(self, start: int, end: int) -> None:
        """Add the lexemes between two directives, macros expanded."""
        lexemes, limit = self.lexemes, self.options.max_tokens
        first = len(lexemes.texts)
        lexemes.scan(self.state.file.text, start, end, limit)
        if not self.macros.keys().isdisjoint(set(lexemes.texts[first:])):
            self.expand(lexemes.cut(first))
        if len(lexemes.texts) > limit:
            span = Span(lexemes.starts[limit], lexemes.ends[limit])
            message = f"the shader has more than {limit} tokens"
            self.tell(RunawayError("SC120", message, LIMIT_HINT), span)

    def expand(self, lexemes: Lexemes) -> None:
        """Add lexemes; those of a macro get the place of its use."""
        at = 0
        for index, text in enumerate(lexemes.texts):
            if index < at or text not in self.macros:
                continue
            self.lexemes.add(lexemes, at, index)
            self.state.place = Span(lexemes.starts[index], lexemes.ends[index])
            expansion = []
            try:
                expansion = self.expander.expand(lexemes.texts, index)
            except DirectiveError as mistake:
                self.tell(mistake, self.state.place)
            at = self.expander.behind
            self.lexemes.repeat(expansion, self.state.place.start, lexemes.ends[at - 1])
        self.lexemes.add(lexemes, at, len(lexemes.texts))

    # --- directives

    def read_directive(self, match: re.Match[str]) -> None:
        """Obey a directive, or skip it."""
        raw = match[0].rstrip()
        start = match.start() + raw.index("#")
        span = self.state.place = self.state.file.text.span(start, match.start() + len(raw))
        parts = _PARTS.match(raw)
        assert parts is not None
        line = Line(parts[1], parts[2], span)
        try:
            if line.name in CONDITIONALS:
                CONDITIONALS[line.name](self.state, line)
            elif self.state.file.groups.live:
                self.obey(line)
        except DirectiveError as mistake:
            self.tell(mistake, span)

    def obey(self, line: Line) -> None:
        """Carry out a directive that is no condition."""
        handler = HANDLERS.get(line.name)
        if line.rest.endswith("\\"):
            hint = "the line break must follow the '\\' at once"
            raise DirectiveError("SC104", "this '\\' continues no line", hint)
        if handler is None and (line.name or line.rest):
            name = shortened(line.name or line.rest)
            raise DirectiveError("SC108", f"there is no directive #{name}")
        if not line.rest.isascii() and line.name not in _ANY_CHARACTER:
            raise DirectiveError("SC101", "a directive holds a character that is not ASCII")
        included = None if handler is None else handler(self.state, line)
        if included is not None:
            self.read_included(included)

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
have the place of its use.

Source: The OpenGL Shading Language 4.60, section 3.3; GLSL ES 3.20, section 3.4.
"""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass
from os.path import samefile
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
from shadercache.front.preprocess.reading_state import ReadingState
from shadercache.front.preprocess.scanner import Lexemes
from shadercache.front.preprocess.version import (
    NO_VERSION,
    VULKAN_LINE,
    Version,
    check_dialect,
    check_place,
    read_version,
    version_line,
)
from shadercache.front.read_options import DEFAULTS, ReadOptions
from shadercache.source import Source, Span

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

    ``default`` is the version of a file that names none. Raises :class:`InputError` with all
    errors.
    """
    prepared, errors = preprocess_broken(source, options, default)
    if errors:
        raise InputError(errors)
    return prepared


def preprocess_broken(
    source: Source, options: ReadOptions, default: Version
) -> tuple[Preprocessed, list[Diagnostic]]:
    """:func:`preprocess` for a file that may be broken: what can be made of it, and its errors."""
    state = ReadingState(source, options, default)
    with suppress(StopReading):
        _read_source(state)
    # A file that is included twice has each mistake once.
    errors = {(error.span, error.message): error for error in state.errors}.values()
    version, directives = state.version, tuple(state.directives)
    if options.dialect == "vulkan":
        directives = (*directives, VULKAN_LINE)
    prepared = Preprocessed(version.number, version.profile, directives, state.lexemes)
    return prepared, sorted(errors, key=lambda error: error.span or Span(-1, -1))


# --- files ----------------------------------------------------------------------------------------


def _read_source(state: ReadingState) -> None:
    """Read the user's own file."""
    source = state.source
    path = Path(source.name)
    state.open(source, path.parent if is_file(path) else None)
    text, begin = state.file.text, 0
    if place := version_line(text.text):
        begin = place[1]
        line = text.text[slice(*place)].rstrip()
        span = text.span(place[0], place[0] + len(line))
        try:
            state.version = read_version(line.partition("version")[2].strip())
            check_dialect(state.version, state.options.dialect)
            # The text as it was written, for a comment must not stand there either.
            check_place(state.version, source.text[: span.start])
        except DirectiveError as mistake:
            state.tell(mistake, span)
    else:
        try:
            check_dialect(state.version, state.options.dialect)
        except DirectiveError as mistake:
            state.tell(mistake, Span(0, 0))
    # Behind the #version, which decides which macros are predefined.
    state.define_first_macros()
    _read_file(state, begin)


def _read_included(state: ReadingState, path: Path) -> None:
    """Read a file that an ``#include`` names, unless it is to be read once only."""
    text = include.read(path, state.room)
    state.room -= max(len(text), include.MIN_TEXT)
    part = state.source.include(str(path), text, state.place.start)
    if not any(_is_same(part, one) for one in state.once):
        state.open(part, path.parent)
        state.set_file_number("0")
        _read_file(state, 0)
        state.files.pop()
        state.set_file_number(state.file.number)


def _is_same(part: Source, other: Source) -> bool:
    """Whether both are one file, which paths may name in many ways: ``a/../b``, links, capitals."""
    if part is other or part.text != other.text:
        return part is other
    with suppress(OSError, ValueError):
        return samefile(part.name, other.name)
    return False


def _read_file(state: ReadingState, at: int) -> None:
    """Read the innermost open file from an offset on."""
    text, groups = state.file.text.text, state.file.groups
    state.expander.allow(len(state.file.part.text))
    for match in _DIRECTIVE.finditer(text, at):
        if groups.live:
            _read_code(state, at, match.start())
        _read_directive(state, match)
        at = match.end()
    if groups.live:
        _read_code(state, at, len(text))
    if groups:
        hint = f"nor have the {len(groups) - 1} around it" if groups[1:] else None
        mistake = DirectiveError("SC121", "this condition has no #endif", hint)
        state.tell(mistake, groups[-1].span)


# --- code -----------------------------------------------------------------------------------------


def _read_code(state: ReadingState, start: int, end: int) -> None:
    """Add the lexemes between two directives, macros expanded."""
    lexemes, limit = state.lexemes, state.options.max_tokens
    # Most stretches of code use no macro and are scanned straight into the result.
    first = len(lexemes.texts)
    lexemes.scan(state.file.text, start, end, limit)
    if not state.macros.keys().isdisjoint(set(lexemes.texts[first:])):
        _expand(state, lexemes.cut(first))
    if len(lexemes.texts) > limit:
        span = Span(lexemes.starts[limit], lexemes.ends[limit])
        message = f"the shader has more than {limit} tokens"
        state.tell(RunawayError("SC120", message, LIMIT_HINT), span)


def _expand(state: ReadingState, lexemes: Lexemes) -> None:
    """Add lexemes; those of a macro get the place of its use."""
    at = 0
    for index, text in enumerate(lexemes.texts):
        # What stands before `at` went into a macro as arguments.
        if index < at or text not in state.macros:
            continue
        state.lexemes.add(lexemes, at, index)
        state.place = Span(lexemes.starts[index], lexemes.ends[index])
        expansion = []
        try:
            expansion = state.expander.expand(lexemes.texts, index)
        except DirectiveError as mistake:
            state.tell(mistake, state.place)
        at = state.expander.behind
        state.lexemes.repeat(expansion, state.place.start, lexemes.ends[at - 1])
    state.lexemes.add(lexemes, at, len(lexemes.texts))


# --- directives -----------------------------------------------------------------------------------


def _read_directive(state: ReadingState, match: re.Match[str]) -> None:
    """Obey a directive, or skip it."""
    raw = match[0].rstrip()
    start = match.start() + raw.index("#")
    span = state.place = state.file.text.span(start, match.start() + len(raw))
    parts = _PARTS.match(raw)
    assert parts is not None
    line = Line(parts[1], parts[2], span)
    try:
        if line.name in CONDITIONALS:
            CONDITIONALS[line.name](state, line)
        elif state.file.groups.live:
            _obey(state, line)
    except DirectiveError as mistake:
        state.tell(mistake, span)


def _obey(state: ReadingState, line: Line) -> None:
    """Carry out a directive that is no condition."""
    handler = HANDLERS.get(line.name)
    if line.rest.endswith("\\"):
        hint = "the line break must follow the '\\' at once"
        raise DirectiveError("SC104", "this '\\' continues no line", hint)
    # A '#' alone on its line is ignored (section 3.3).
    if handler is None and (line.name or line.rest):
        name = shortened(line.name or line.rest)
        raise DirectiveError("SC108", f"there is no directive #{name}")
    if not line.rest.isascii() and line.name not in _ANY_CHARACTER:
        raise DirectiveError("SC101", "a directive holds a character that is not ASCII")
    included = None if handler is None else handler(state, line)
    if included is not None:
        _read_included(state, included)

"""What stands before a mistake of syntax, as a module of its own.

A file with such a mistake has no tree, but the statements before it have one, and the mistakes in
them are worth telling at the same time.

Before, with a mistake at its end::

    float f(float x) { float y = x; if (x > 0.0) { y = 1.0; return y +

After: ``float f(float x) { float y = x; if (x > 0.0) { y = 1.0; } }``.
"""

from __future__ import annotations

from contextlib import suppress

from shadercache.ast.nodes import Module
from shadercache.diagnostics import InputError
from shadercache.front.dialects import host_of
from shadercache.front.lexis import Lexemes
from shadercache.front.mistakes import StopReading
from shadercache.front.options import DEFAULTS, ReadOptions
from shadercache.front.parse import build
from shadercache.front.preprocess import Preprocessed, Reader
from shadercache.front.version import NO_VERSION
from shadercache.source import Source


def parse_before(source: Source, place: int, options: ReadOptions = DEFAULTS) -> Module | None:
    """The module of the whole statements before a place; ``None`` where they make none.

    Raises :class:`InputError` with the first mistake of syntax that stands there itself.
    """
    host = host_of(source, options.dialect)
    reader = Reader(source, options, host.version if host else NO_VERSION)
    with suppress(StopReading):
        reader.read_source()
    version, directives = reader.version, tuple(reader.directives)
    for end, open_braces in _ends(source, reader.lexemes, place):
        lexemes = Lexemes()
        lexemes.add(reader.lexemes, 0, end)
        lexemes.repeat(["}"] * open_braces, place, place)
        if host is not None:
            lexemes = host.surround(lexemes, len(source.text))
        prepared = Preprocessed(version.number, version.profile, directives, lexemes)
        try:
            return build(source, prepared, lexemes)
        except InputError as error:
            # At the end it is the cut that makes the mistake: a struct needs its semicolon.
            if _start(error) < reader.lexemes.starts[end - 1]:
                raise
    return None


def _start(error: InputError) -> int:
    return min(item.span.start for item in error.diagnostics if item.span is not None)


def _ends(source: Source, lexemes: Lexemes, place: int) -> list[tuple[int, int]]:
    """Where statements end before a place, and how many braces are open there: the last of all
    statements, and the last of those outside of all braces."""
    last, outside = (0, 0), (0, 0)
    brackets = braces = 0
    for index, text in enumerate(lexemes.texts):
        # Included files lie behind the user's own, whatever their place in it.
        if place <= lexemes.starts[index] < len(source.text):
            break
        if text in "([":
            brackets += 1
        elif text in ")]":
            brackets -= 1
        elif text in "{}":
            braces += 1 if text == "{" else -1
        if text in "{};" and brackets == 0 and braces >= 0:
            last = (index + 1, braces)
            if braces == 0:
                outside = last
    return [end for end in (last, outside) if end[0]]

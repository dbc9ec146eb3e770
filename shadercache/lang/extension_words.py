"""Words that only extensions have (``extension_words.txt``): what is told where none is on."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

from shadercache.lang.availability import data_lines

_ARITHMETIC = "GL_EXT_shader_explicit_arithmetic_types"


class _ExtensionWords(NamedTuple):
    """An extension, a pattern for its words, and the first version in which it is supported."""

    extension: str
    pattern: str
    since: int | None = None


@cache
def _rows() -> tuple[_ExtensionWords, ...]:
    lines = data_lines(Path(__file__).with_name("extension_words.txt"))
    rows = (text.split() for _, text, _ in lines)
    return tuple(_ExtensionWords(name, pattern, *map(int, since)) for name, pattern, *since in rows)


@cache
def _row_of(word: str) -> _ExtensionWords | None:
    return next((row for row in _rows() if re.fullmatch(row.pattern, word)), None)


def explained(word: str) -> tuple[str, str | None] | None:
    """Message and hint for a word that only an extension has; ``None`` for any other."""
    row = _row_of(word)
    return None if row is None else _told(word, row.extension, row.since)


def _told(word: str, extension: str, since: int | None) -> tuple[str, str | None]:
    if since is None:
        return f"'{word}' is of the extension {extension}, which is not supported", None
    hint = f"write '#extension {extension} : enable', and #version {since} or later"
    return f"'{word}' is of the extension {extension}, which is not turned on", hint


class Suffix(NamedTuple):
    """The end of a number that only extensions have: the first of them is what is told."""

    pattern: re.Pattern[str]
    extensions: tuple[str, ...]


_SUFFIXES = (
    Suffix(
        re.compile(r"[\d.]+(?:[eE][+-]?\d+)?(?:hf|HF)", re.ASCII),
        (f"{_ARITHMETIC}_float16", _ARITHMETIC, "GL_AMD_gpu_shader_half_float"),
    ),
    Suffix(
        re.compile(r"(?:0[xX][\da-fA-F]+|\d+)[uU]?[sS]", re.ASCII),
        (f"{_ARITHMETIC}_int16", _ARITHMETIC, "GL_AMD_gpu_shader_int16"),
    ),
)


def suffix_problem(number: str, extensions: frozenset[str]) -> tuple[str, str | None] | None:
    """Message and hint for a number that ends as only an extension which is off has it."""
    for suffix in _SUFFIXES:
        if suffix.pattern.fullmatch(number):
            missing = extensions.isdisjoint(suffix.extensions)
            return _told(number, suffix.extensions[0], 310) if missing else None
    return None

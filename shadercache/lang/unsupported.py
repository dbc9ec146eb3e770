"""Words of extensions that are known by name and not supported (``unsupported.txt``)."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from shadercache.lang.availability import data_lines

_ARITHMETIC = "GL_EXT_shader_explicit_arithmetic_types"
_INT64 = "GL_ARB_gpu_shader_int64"
"""The one among them that is supported, where it is turned on."""


@cache
def _words() -> tuple[tuple[str, str], ...]:
    """The extensions, and a pattern for words of each."""
    lines = data_lines(Path(__file__).with_name("unsupported.txt"))
    rows = (text.split() for _, text, _ in lines)
    return tuple((extension, pattern) for extension, pattern in rows)


@cache
def unsupported_extension(word: str) -> str | None:
    """The extension that gives ``word`` a meaning, where the word has none here."""
    fitting = (extension for extension, pattern in _words() if re.fullmatch(pattern, word))
    return next(fitting, None)


def explained(word: str) -> tuple[str, str | None] | None:
    """Message and hint for a word that only an extension has; ``None`` for any other."""
    extension = unsupported_extension(word)
    if extension is None:
        return None
    if extension == _INT64:
        hint = f"write '#extension {_INT64} : enable', and #version 400 or later"
        return f"'{word}' is of the extension {_INT64}, which is not turned on", hint
    message = f"'{word}' is of the extension {extension}, which is not supported"
    return message, "write a type of 32 bits" if extension.startswith(_ARITHMETIC) else None


_SUFFIXES = (
    (re.compile(r"[\d.]+(?:[eE][+-]?\d+)?(?:hf|HF)", re.ASCII), f"{_ARITHMETIC}_float16"),
    (re.compile(r"(?:0[xX][\da-fA-F]+|\d+)[uU]?[sS]", re.ASCII), f"{_ARITHMETIC}_int16"),
)


def extension_of_number(text: str) -> str | None:
    """The extension that has numbers which end like this one."""
    fitting = (extension for pattern, extension in _SUFFIXES if pattern.fullmatch(text))
    return next(fitting, None)

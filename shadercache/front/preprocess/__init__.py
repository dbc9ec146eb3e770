"""The preprocessor, from characters to lexemes. Others import it from here."""

from shadercache.front.preprocess.reader import Preprocessed, preprocess, preprocess_broken
from shadercache.front.preprocess.scanner import (
    MAX_WORD,
    Lexemes,
    clean,
    is_number,
    is_word,
    joins_comments,
    spellings,
)
from shadercache.front.preprocess.version import (
    DESKTOP,
    ES,
    NO_VERSION,
    Version,
    read_version,
    version_line,
)

__all__ = [
    "DESKTOP",
    "ES",
    "MAX_WORD",
    "NO_VERSION",
    "Lexemes",
    "Preprocessed",
    "Version",
    "clean",
    "is_number",
    "is_word",
    "joins_comments",
    "preprocess",
    "preprocess_broken",
    "read_version",
    "spellings",
    "version_line",
]

"""Numbers and choices as sentences of a page say them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from shadercache.caching.algorithms import algorithm
from shadercache.caching.configuration import Configuration
from shadercache.caching.settings import written_settings

_NUMBERS = ("no passes", "one pass", "two passes", "three passes", "four passes")
_PLAIN = written_settings(Configuration())


def error_in_words(error: float) -> str:
    """An error between 0 and 1 with two significant digits and without the nought."""
    return "0" if error == 0.0 else f"{error:.2g}".removeprefix("0")


def algorithm_in_words(name: str) -> str:
    """Such as "two passes"; of those that are not usual the name as well."""
    record = algorithm(name)
    words = _NUMBERS[len(record.passes)]
    return words if record.usual else f"{words} ({name})"


def settings_in_words(chosen: Configuration) -> Iterator[str]:
    """What of a cache differs from the default, as the command line has it."""
    if chosen.storage.format != Configuration().storage.format:
        yield f"format={chosen.storage.format}"
    if chosen.payload_rate != Configuration().payload_rate:
        yield f"rate={chosen.payload_rate}"
    for word, value in written_settings(chosen).items():
        if value != _PLAIN[word]:
            yield f"{word}={value}"


def listed(parts: Sequence[str]) -> str:
    """Such as "a, b and c"."""
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def capital(text: str) -> str:
    """With a capital letter in front."""
    return text[:1].upper() + text[1:]

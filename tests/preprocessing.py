"""The preprocessor at work, for tests: what a text becomes, and what is wrong with it."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.preprocess import Preprocessed, preprocess
from shadercache.front.read_options import DEFAULTS, ReadOptions
from shadercache.source import Source


def run(text: str, options: ReadOptions = DEFAULTS, name: str = "test.frag") -> Preprocessed:
    return preprocess(Source(name, text), options)


def words(body: str, version: str = "330", options: ReadOptions = DEFAULTS) -> str:
    """The lexemes, with a blank between them, of what stands below ``#version``."""
    return " ".join(run(f"#version {version}\n{body}", options).lexemes.texts)


def rejected(
    text: str, options: ReadOptions = DEFAULTS, name: str = "test.frag"
) -> tuple[Diagnostic, ...]:
    """Every diagnostic of a text that is rejected."""
    with pytest.raises(InputError) as caught:
        run(text, options, name)
    return caught.value.diagnostics


def placed(item: Diagnostic) -> str:
    """``line:column code``."""
    assert item.source is not None
    assert item.span is not None
    line, column = item.source.position(item.span.start)
    return f"{line}:{column} {item.code}"


def errors(text: str, options: ReadOptions = DEFAULTS) -> list[str]:
    """``line:column code`` of each error."""
    return [placed(item) for item in rejected(text, options)]


def problem(body: str, version: str = "330", options: ReadOptions = DEFAULTS) -> str:
    """``line:column code message`` of the one error below ``#version``."""
    (item,) = rejected(f"#version {version}\n{body}", options)
    return f"{placed(item)} {item.message}"

"""The options about reading: what they become."""

from __future__ import annotations

from pathlib import Path

from shadercache.cli.reading import read_options
from shadercache.front.read_options import ReadOptions


def test_without_options() -> None:
    assert read_options() == ReadOptions()


def test_definitions(tmp_path: Path) -> None:
    options = read_options(["A", "B=", "C=x = 1", "A=2"], ["GL_ES"], [tmp_path], "auto", 10)
    assert options.defines == (("A", "2"), ("B", ""), ("C", "x = 1"))
    assert options.undefined == ("GL_ES",)
    assert options.include_folders == (tmp_path,)
    assert (options.dialect, options.max_tokens) == ("auto", 10)

"""The options about reading: what they become."""

from __future__ import annotations

from pathlib import Path

from shadercache.cli.options import ShaderOptions, SourceOptions
from shadercache.front.read_options import ReadOptions


def test_without_options() -> None:
    assert SourceOptions().read_options() == ReadOptions()
    assert ShaderOptions(unroll=True).read_options() == ReadOptions(unroll=True)


def test_definitions(tmp_path: Path) -> None:
    options = SourceOptions(
        define=["A", "B=", "C=x = 1", "A=2"],
        undefine=["GL_ES"],
        include=[tmp_path],
        dialect="auto",
        max_tokens=10,
    ).read_options()
    assert options.defines == (("A", "2"), ("B", ""), ("C", "x = 1"))
    assert options.undefined == ("GL_ES",)
    assert options.include_folders == (tmp_path,)
    assert (options.dialect, options.max_tokens) == ("auto", 10)

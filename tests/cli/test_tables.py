"""Plain tables and progress."""

from __future__ import annotations

import sys

import pytest

from shadercache.cli import progress as progress_module
from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table, shorten


def test_columns_line_up() -> None:
    table = format_table(("id", "cost"), [("a", "1"), ("long", "1000")], right="cost")
    assert table == "id    cost\na        1\nlong  1000"


def test_no_rows() -> None:
    assert format_table(("id", "text"), []) == "id  text"


def test_lines_are_cut_to_the_width() -> None:
    lines = format_table(("id", "text"), [("a", "x" * 99)], width=20).splitlines()
    assert [len(line) for line in lines] == [8, 20]
    assert lines[1].endswith("x...")


@pytest.mark.parametrize(
    ("text", "width", "expected"),
    [("abcdef", 6, "abcdef"), ("abcdefg", 6, "abc..."), ("a\nb", None, "a b"), ("abc", 2, "...")],
)
def test_shorten(text: str, width: int | None, expected: str) -> None:
    assert shorten(text, width) == expected


def test_short_work_says_nothing_in_a_log(capsys: pytest.CaptureFixture[str]) -> None:
    with progress("work", 3) as advance:
        for _ in range(3):
            advance(1)
    assert capsys.readouterr() == ("", "")


def test_long_work_says_how_long(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = iter([0.0, 5.0, 20.0, 22.0])
    monkeypatch.setattr(progress_module.time, "monotonic", lambda: next(clock))
    with progress("work", 8) as advance:
        for _ in range(3):
            advance(1)
    assert capsys.readouterr() == ("", "work: 2 of 8, about 60 s left\n")


def test_a_terminal_gets_a_bar(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    with progress("work", 2) as advance:
        advance(2)
    captured = capsys.readouterr()
    assert captured.out == "" and "work" in captured.err and "100%" in captured.err

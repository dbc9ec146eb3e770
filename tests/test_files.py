"""Files are written whole, under names that every system takes."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.diagnostics import UsageError
from shadercache.files import MAX_STEM, file_stem, write_bytes


@pytest.mark.parametrize(
    ("text", "stem"),
    [
        ("dragon", "dragon"),
        ("main.16-7891657a", "main.16-7891657a"),
        ("Höhle", "Höhle"),
        ("a < b ? c : d", "a-b-c-d"),
        ("fbm(p * 2.0)", "fbm-p-2.0-"),
        ("../../etc/passwd", "-..-etc-passwd"),
        (r"C:\scenes\x", "C-scenes-x"),
        ("CON", "_CON"),
        ("aux.3-12", "_aux.3-12"),
        ("com1", "_com1"),
        ("COM²", "_COM²"),
        ("console", "console"),
        ("com10", "com10"),
        ("...", "_"),
        ("", "_"),
        ("\ud800", "-"),
    ],
)
def test_the_name_of_a_file_from_a_text(text: str, stem: str) -> None:
    assert file_stem(text) == stem


@pytest.mark.parametrize("letter", ["x", "é", "語", "𐎀"])
def test_a_long_text_gives_no_long_name(letter: str, tmp_path: Path) -> None:
    stem = file_stem(letter * 1000)
    assert MAX_STEM - 4 < len(stem.encode()) <= MAX_STEM
    write_bytes(tmp_path / f"{stem}-2-pass-difference.png", b"")


def test_a_file_that_another_program_has_open(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Windows renames nothing over it."""
    goal = tmp_path / "a b ü.json"
    goal.write_bytes(b"old")

    def refuse(path: Path, target: Path) -> None:
        raise PermissionError(13, "Access is denied", str(path))

    monkeypatch.setattr(Path, "replace", refuse)
    with pytest.raises(UsageError, match=r"cannot write .*a b ü\.json: Access is denied"):
        write_bytes(goal, b"new")
    assert [path.name for path in tmp_path.iterdir()] == [goal.name]
    assert goal.read_bytes() == b"old"

"""Diagnostics as objects; what they say is tested where they arise."""

from __future__ import annotations

import pickle
import re
from pathlib import Path

import pytest

from shadercache.diagnostics import (
    Diagnostic,
    DiagnosticError,
    GraphicsError,
    InputError,
    UsageError,
)
from shadercache.source import Source, Span

ROOT = Path(__file__).resolve().parent.parent


@pytest.mark.parametrize("kind", [InputError, UsageError, GraphicsError])
def test_an_error_survives_the_way_from_another_process(kind: type[DiagnosticError]) -> None:
    source = Source("a.frag", "void main() {}\n")
    error = kind(
        [Diagnostic("SC999", "no", source, Span(0, 4), hint="yes"), Diagnostic("SC998", "")]
    )
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is kind
    assert [item.code for item in again.diagnostics] == ["SC999", "SC998"]
    assert str(again) == str(error)


def test_every_code_is_documented() -> None:
    used = {
        code
        for path in (ROOT / "shadercache").rglob("*.py")
        for code in re.findall(r"\bSC\d{3}\b", path.read_text(encoding="utf-8"))
    }
    text = (ROOT / "docs" / "DIAGNOSTICS.md").read_text(encoding="utf-8")
    documented = re.findall(r"^\| (SC\d{3}) \|", text, re.MULTILINE)
    assert sorted(used) == sorted(documented)


@pytest.mark.parametrize(("at", "dots"), [(0, "end"), (5_000, "both"), (9_999, "start")])
def test_of_a_very_long_line_the_place_is_shown(at: int, dots: str) -> None:
    text = "-" * at + "x" + "-" * (9_999 - at)
    place, line, caret = (
        Diagnostic("SC999", "no", Source("a", text), Span(at, at + 1)).render().split("\n")
    )
    assert place.startswith(f"a:1:{at + 1}: ")
    assert len(line) < 250
    assert line[caret.index("^")] == "x" and "~" not in caret
    assert line.endswith("...") == (dots != "start")
    assert line.startswith("    1 | ...") == (dots != "end")

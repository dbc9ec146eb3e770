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
    shortened,
)
from shadercache.source import Source, Span

ROOT = Path(__file__).resolve().parent.parent


@pytest.mark.parametrize("kind", [InputError, UsageError, GraphicsError])
def test_an_error_survives_the_way_from_another_process(kind: type[DiagnosticError]) -> None:
    source = Source("a.frag", "void main() {}\n")
    second = Diagnostic("SC998", "")
    error = kind([Diagnostic("SC999", "no", source, Span(0, 4), hint="yes"), second])
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is kind
    assert [item.code for item in again.diagnostics] == ["SC999", "SC998"]
    assert str(again) == str(error)


def test_long_names_are_shortened_where_they_are_quoted() -> None:
    name, sum_ = "a" * 10_000, "0123456789abcdef" * 4
    error = Diagnostic("SC999", f"'{name}' is not in '{sum_}.glsl'", hint=f"leave {name}")
    assert error.message == f"'{'a' * 59}…' is not in '{sum_}.glsl'"
    assert error.hint == f"leave {'a' * 59}…"
    assert Diagnostic("SC999", "no").hint is None


def test_a_message_has_an_end() -> None:
    error = Diagnostic("SC999", "1 + " * 10_000, hint="2 + " * 10_000)
    assert error.message == "1 + " * 124 + "1 +…"
    assert error.hint is not None
    assert len(error.hint) == 500


def test_shortened() -> None:
    assert [shortened("abcd", limit) for limit in (5, 4, 3)] == ["abcd", "abcd", "ab…"]


def test_every_code_is_documented() -> None:
    used = {
        code
        for path in (ROOT / "shadercache").rglob("*.py")
        for code in re.findall(r"\bSC\d{3}\b", path.read_text(encoding="utf-8"))
    }
    text = (ROOT / "docs" / "DIAGNOSTICS.md").read_text(encoding="utf-8")
    documented = re.findall(r"^\| (SC\d{3}) \|", text, re.MULTILINE)
    assert sorted(used) == sorted(documented)

"""``shadercache report`` from the command line."""

from __future__ import annotations

import sqlite3
from pathlib import Path

import pytest

from bench.made_sweep import MadeSize, fill_store
from shadercache.report.parts import page_parts
from shadercache.sweep.store import Store

from .conftest import Shell


@pytest.fixture
def store(tmp_path: Path) -> Path:
    path = tmp_path / "made.db"
    fill_store(path, MadeSize(values=1, peers=1, edge=32, files=False))
    return path


def test_it_writes_a_page(shell: Shell, store: Path, tmp_path: Path) -> None:
    page = tmp_path / "new" / "page.html"
    outcome = shell("report", store, "-o", page)
    assert (outcome.status, outcome.err) == (0, "")
    assert outcome.out == f"wrote {page}: 13 rows, {page.stat().st_size / 1e6:.1f} MB\n"
    assert page.read_bytes().endswith(b"</html>\n")


def test_rows_that_are_stale_are_left_out(shell: Shell, store: Path, tmp_path: Path) -> None:
    with Store(store) as opened:
        opened.mark_stale({row.identity: "another key" for row in opened.rows()[:3]})
    outcome = shell("report", store, "-o", tmp_path / "page.html")
    assert "10 rows, 3 stale rows left out, " in outcome.out
    assert '"stale":3' in (tmp_path / "page.html").read_text(encoding="utf-8")


def _missing(path: Path) -> None:
    path.unlink()


def _text(path: Path) -> None:
    path.write_text("no database, though it is long enough to be one" * 99)


def _foreign(path: Path) -> None:
    path.unlink()
    base = sqlite3.connect(path)
    base.execute("CREATE TABLE trial (key TEXT)")
    base.close()


def _empty(path: Path) -> None:
    path.unlink()
    Store(path, create=True).release()


@pytest.mark.parametrize(
    ("spoil", "status", "code"),
    [
        (_missing, 1, "SC033"),
        (_text, 1, "SC033"),
        (_foreign, 1, "SC033"),
        (_empty, 1, "SC037"),
    ],
)
def test_what_is_no_store_with_rows_is_told(
    shell: Shell, store: Path, tmp_path: Path, spoil: object, status: int, code: str
) -> None:
    assert callable(spoil)
    spoil(store)
    outcome = shell("report", store, "-o", tmp_path / "page.html")
    assert (outcome.status, outcome.out) == (status, "")
    assert outcome.err.count("error:") == 1 and f"[{code}]" in outcome.err
    assert not (tmp_path / "page.html").exists()


def test_without_plotly_the_extra_is_named(
    shell: Shell, store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page_parts, "find_spec", lambda name: None)
    outcome = shell("report", store, "-o", tmp_path / "page.html")
    assert outcome.status == 2
    assert "[SC031]" in outcome.err and "pip install 'shadercache[report]'" in outcome.err


def test_a_page_that_cannot_be_written_is_told(shell: Shell, store: Path) -> None:
    outcome = shell("report", store, "-o", store / "page.html")
    assert outcome.status == 2
    assert "[SC025]" in outcome.err

"""A small store with made-up numbers, and what pages are made of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from bench.made_sweep import MadeSize, fill_store
from shadercache.report.page.page_data import PageSource
from shadercache.sweep.row import Row
from shadercache.sweep.store import Store

Sourced = Callable[[Sequence[Row]], PageSource]


@pytest.fixture(scope="session")
def made_store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three values by three algorithms with four periods, two peers; four rows are failures."""
    path = tmp_path_factory.mktemp("made") / "made.db"
    fill_store(path, MadeSize(values=3, peers=2, edge=64))
    return path


@pytest.fixture(scope="session")
def made_rows(made_store: Path) -> list[Row]:
    with Store(made_store) as store:
        return store.rows()


@pytest.fixture(scope="session")
def made_blobs(made_store: Path, made_rows: list[Row]) -> dict[str, bytes]:
    hashes = {
        name for row in made_rows for kind in (row.texts, row.pictures) for name in kind.values()
    }
    with Store(made_store) as store:
        return {hashed: store.blob(hashed) for hashed in hashes}


@pytest.fixture(scope="session")
def sourced(made_blobs: dict[str, bytes]) -> Sourced:
    """``sourced(rows)``: a page's source with the made store's texts and pictures."""
    return lambda rows: PageSource("made.db", rows, made_blobs.__getitem__)

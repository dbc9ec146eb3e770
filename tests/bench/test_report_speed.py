"""How fast a report opens: what is measured, and what is made of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image

from bench.browser import MISSING
from bench.made_sweep import PERIODS, MadeSize, fill_store
from bench.report_speed import main, targets
from shadercache.sweep.store import Store


@pytest.mark.parametrize(
    ("size", "seconds", "met"),
    [
        (11_000_000, [1.0, 1.5, 9.0], [True, True, True]),
        (12_500_000, [1.0, 2.5, 3.0], [False, False, True]),
    ],
)
def test_targets_are_of_the_middle_round(size: int, seconds: list[float], met: list[bool]) -> None:
    samples = [{"seconds": value, "processor": 0.5} for value in seconds]
    assert [row["met"] for row in targets(size, samples)] == met


def test_a_made_up_sweep_has_what_was_asked_for(tmp_path: Path) -> None:
    size = MadeSize(values=2, peers=1, edge=16, files=False)
    rows = fill_store(tmp_path / "made.db", size)
    assert len(rows) == 2 * 3 * len(PERIODS) + 1
    with Store(tmp_path / "made.db") as store:
        assert store.rows() == rows
        assert all(store.blob(hashed) for row in rows for hashed in row.pictures.values())


@pytest.mark.skipif(MISSING is not None, reason=str(MISSING))
@pytest.mark.xdist_group("browser")
def test_it_opens_a_page_and_takes_its_picture(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    store, pictures = tmp_path / "made.db", tmp_path / "pictures"
    fill_store(store, MadeSize(values=2, peers=1, edge=16, files=False))
    main(["--rounds", "1", "--store", str(store), "--pictures", str(pictures)])
    assert capsys.readouterr().out.count("<=") == 3
    widths = {}
    for path in pictures.glob("*.png"):
        with Image.open(path) as image:
            widths[path.stem] = image.width
    assert widths == {
        f"report-{width}-{theme}": width for width in (1280, 390) for theme in ("light", "dark")
    }

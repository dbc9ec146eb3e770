"""How fast the page of a sweep of 500 configurations opens in headless Chromium, and its size.

The store is made up: 41 values by three algorithms with four periods, and eight peers. A time is
from the beginning of a navigation to a file until the last plot is drawn; beside it stands the time
of the processor, which a busy machine does not stretch. Exit status 1 if a target is missed.

    python -m bench.report_speed [--rounds N] [--store STORE] [--pictures DIR]

With --pictures it also writes the page as it looks on a screen and on a phone, light and dark.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from bench.browser import MISSING, open_browser, open_page, picture_of, set_window
from bench.made_sweep import MadeSize, fill_store
from bench.speed import Sample, target, targets_table
from shadercache.report.page.page_data import PageSource
from shadercache.report.page.page_file import page_file
from shadercache.sweep.store import Store

if TYPE_CHECKING:
    from selenium.webdriver import Chrome

MOST_BYTES, MOST_SECONDS = 12e6, 2.0
WIDTHS = 1280, 390


def openings(browser: Chrome, page: Path, rounds: int) -> list[Sample]:
    """Seconds on the clock and of the processor until the page is drawn, for each round."""
    browser.execute_cdp_cmd("Performance.enable", {"timeDomain": "threadTicks"})
    samples = []
    for _ in range(rounds):
        browser.get("about:blank")
        drawn = open_page(browser, page)
        told = browser.execute_cdp_cmd("Performance.getMetrics", {})["metrics"]
        metrics = {metric["name"]: metric["value"] for metric in told}
        samples.append({"seconds": drawn / 1e3, "processor": metrics["TaskDuration"]})
    return samples


def targets(size: int, samples: Sequence[Sample]) -> list[Sample]:
    """The page's size in bytes and the middle of its times, beside what they may be."""
    seconds = float(np.median([sample["seconds"] for sample in samples]))
    processor = float(np.median([sample["processor"] for sample in samples]))
    return [
        target("size, MB", size / 1e6, MOST_BYTES / 1e6),
        target("drawn after, s", seconds, MOST_SECONDS),
        target("of these on the processor, s", processor, MOST_SECONDS),
    ]


def main(arguments: Sequence[str]) -> int:
    """Make the store and the page, open it, print the table."""
    parser = argparse.ArgumentParser(prog="report_speed")
    parser.add_argument("--rounds", type=int, default=5, help="how often the page is opened")
    parser.add_argument("--store", type=Path, help="this store instead of a made-up one")
    parser.add_argument("--pictures", type=Path, help="also write pictures of the page here")
    chosen = parser.parse_args(arguments)
    if MISSING is not None:
        print(MISSING)
        return 3
    with tempfile.TemporaryDirectory() as folder:
        path = chosen.store or Path(folder) / "made.db"
        if chosen.store is None:
            fill_store(path, MadeSize())
        with Store(path) as store:
            written = page_file(PageSource(path.name, store.rows(), store.blob))
        page = Path(folder) / "page.html"
        page.write_bytes(written)
        with open_browser() as browser:
            set_window(browser, WIDTHS[0])
            found = targets(len(written), openings(browser, page, chosen.rounds))
            if chosen.pictures is not None:
                _take_pictures(browser, page, chosen.pictures)
    print(targets_table(found))
    return int(any(row["met"] is False for row in found))


def _take_pictures(browser: Chrome, page: Path, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for width in WIDTHS:
        for theme in ("light", "dark"):
            set_window(browser, width, theme)
            open_page(browser, page)
            picture_of(browser, folder / f"report-{width}-{theme}.png", width)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

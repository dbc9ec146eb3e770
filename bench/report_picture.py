"""The upper part of a store's report, down to the pictures: what the front page shows of it.

    python -m bench.report_picture STORE [-o docs/images/report.jpg]

Needs Debian's chromium and chromium-driver.
"""

from __future__ import annotations

import argparse
import io
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from PIL import Image

from bench.browser import MISSING, open_browser, open_page, picture_of, set_window
from shadercache.files import write_bytes
from shadercache.report.page.page_data import PageSource
from shadercache.report.page.page_file import page_file
from shadercache.sweep.store import Store

ROOT = Path(__file__).resolve().parent.parent
WIDTH = 1280

_END = "return document.querySelector('.look').getBoundingClientRect().bottom + scrollY"


def main(arguments: Sequence[str]) -> int:
    """Make the page, open it, write its picture."""
    parser = argparse.ArgumentParser(prog="report_picture")
    parser.add_argument("store", type=Path)
    default = ROOT / "docs" / "images" / "report.jpg"
    parser.add_argument("-o", "--output", type=Path, default=default, metavar="FILE")
    chosen = parser.parse_args(arguments)
    if MISSING is not None:
        print(MISSING)
        return 3
    with tempfile.TemporaryDirectory() as folder:
        page, shot = Path(folder) / "page.html", Path(folder) / "page.png"
        with Store(chosen.store) as store:
            page.write_bytes(page_file(PageSource(chosen.store.name, store.rows(), store.blob)))
        with open_browser() as browser:
            set_window(browser, WIDTH)
            open_page(browser, page)
            picture_of(browser, shot, WIDTH, round(browser.execute_script(_END)) + 30)
        buffer = io.BytesIO()
        with Image.open(shot) as image:
            image.convert("RGB").save(buffer, "JPEG", quality=85, optimize=True)
    write_bytes(chosen.output, buffer.getvalue())
    print(f"wrote {chosen.output}, {len(buffer.getvalue()) / 1e3:.0f} KB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

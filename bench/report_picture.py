"""Pictures of a store's report for the documents.

    python -m bench.report_picture STORE [-o docs/images]

``report.jpg`` is its upper part, down to the slider; ``front.jpg``, which the front page shows, the
closer look alone. Needs Debian's chromium and chromium-driver.
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

_LOOK = "const box = document.querySelector('.look').getBoundingClientRect();"
_EDGES = f"{_LOOK} return [box.top + scrollY, box.bottom + scrollY]"
MARGIN = 30


def main(arguments: Sequence[str]) -> int:
    """Make the page, open it, write the pictures."""
    parser = argparse.ArgumentParser(prog="report_picture")
    parser.add_argument("store", type=Path)
    default = ROOT / "docs" / "images"
    parser.add_argument("-o", "--output", type=Path, default=default, metavar="DIR")
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
            top, bottom = map(round, browser.execute_script(_EDGES))
            picture_of(browser, shot, WIDTH, bottom + MARGIN)
        with Image.open(shot) as image:
            _write(image, chosen.output / "report.jpg")
            _write(image.crop((0, top - MARGIN, *image.size)), chosen.output / "front.jpg")
    return 0


def _write(image: Image.Image, path: Path) -> None:
    buffer = io.BytesIO()
    image.convert("RGB").save(buffer, "JPEG", quality=85, optimize=True)
    write_bytes(path, buffer.getvalue())
    print(f"wrote {path}, {len(buffer.getvalue()) / 1e3:.0f} KB")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

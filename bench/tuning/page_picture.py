"""The picture of a tuning's page for the documents: the plane with its slider.

    shadercache tune trashcan --max-error 0.01,0.03,0.06 --page page.html
    python -m bench.tuning.page_picture page.html [-o docs/images/tuning.jpg]

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

WIDTH, MARGIN = 1180, 16
DEFAULT = Path(__file__).resolve().parents[2] / "docs" / "images" / "tuning.jpg"

_EDGES = (
    "const edge = (name) => document.querySelector(name).getBoundingClientRect();"
    "return [edge('#plane-figure').top + scrollY, edge('.bound-bar').bottom + scrollY]"
)


def main(arguments: Sequence[str]) -> int:
    """Open the page, write the picture."""
    parser = argparse.ArgumentParser(prog="page_picture")
    parser.add_argument("page", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=DEFAULT, metavar="FILE")
    chosen = parser.parse_args(arguments)
    if MISSING is not None:
        print(MISSING)
        return 3
    with tempfile.TemporaryDirectory() as folder, open_browser() as browser:
        shot = Path(folder) / "page.png"
        set_window(browser, WIDTH)
        open_page(browser, chosen.page)
        top, bottom = map(round, browser.execute_script(_EDGES))
        picture_of(browser, shot, WIDTH, bottom + MARGIN)
        buffer = io.BytesIO()
        with Image.open(shot) as image:
            cropped = image.convert("RGB").crop((0, top - MARGIN, *image.size))
            cropped.save(buffer, "JPEG", quality=85, optimize=True)
    write_bytes(chosen.output, buffer.getvalue())
    print(f"wrote {chosen.output}, {len(buffer.getvalue()) / 1e3:.0f} KB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""The picture of the front page: both demo scenes, each as original, cached and hit map.

    python -m bench.front_picture        # writes docs/images/front.jpg

The pictures are those of ``shadercache run`` in the 34th frame after a reset, so that the whole
picture has been refreshed once.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image, ImageDraw, ImageFont

ROOT = Path(__file__).resolve().parent.parent
SCENES = {
    "dragon": ("albedo", 2, 32),
    "trashcan": ("24 of 25 samples", 3, 4),
}
"""The node that the front page speaks of, the passes that draw it, and its period."""

COLUMNS = {
    "original": "original",
    "cached": "cached",
    "hits": "blue: reused, yellow: refreshed, red: missed",
}
DRAWN, CELL, GAP, TITLE = 768, 300, 6, 22


def main() -> None:
    """Draw, put together, write."""
    width = len(COLUMNS) * (CELL + GAP) - GAP
    height = TITLE + len(SCENES) * (CELL + GAP) - GAP
    sheet = Image.new("RGB", (width, height), "white")
    draw = ImageDraw.Draw(sheet)
    for column, title in enumerate(COLUMNS.values()):
        draw.text((column * (CELL + GAP), 2), title, "black", ImageFont.load_default(14))
    for row, scene in enumerate(SCENES):
        for column, picture in enumerate(_pictures(scene)):
            sheet.paste(picture, (column * (CELL + GAP), TITLE + row * (CELL + GAP)))
    sheet.save(ROOT / "docs" / "images" / "front.jpg", quality=82, optimize=True)


def _pictures(scene: str) -> list[Image.Image]:
    node, passes, period = SCENES[scene]
    with TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "shadercache", "run", f"corpus/{scene}/scene.toml"]
        command += ["--node", node, "--passes", str(passes), "--period", str(period)]
        command += ["--frame", "33", "--size", str(DRAWN), "-o", folder]
        subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        paths = [next(Path(folder).glob(f"*-{kind}.png")) for kind in COLUMNS]
        return [_cell(Image.open(path)) for path in paths]


def _cell(picture: Image.Image) -> Image.Image:
    """The picture without the legend below it, in the size of a cell."""
    return picture.convert("RGB").crop((0, 0, DRAWN, DRAWN)).resize((CELL, CELL))


if __name__ == "__main__":
    main()

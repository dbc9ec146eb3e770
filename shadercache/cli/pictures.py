"""Writing the four pictures of a variant."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from shadercache.harness.measurement import Shot


def write_pictures(folder: Path, shot: Shot, views: Sequence[str] = ("hits",)) -> list[Path]:
    """Write original, cached, 10x difference and the views as PNG; return their paths.

    Raises :class:`UsageError` SC025 where the folder cannot be written, SC442 for an unknown view.
    """
    from shadercache.harness.debug_views import chosen_views, view_picture
    from shadercache.harness.pictures import difference_picture, write_png

    stem = f"{re.sub(r'[^A-Za-z0-9._-]+', '-', shot.label)}-{shot.algorithm}"
    shown = {
        "original": shot.original,
        "cached": shot.cached,
        "difference": difference_picture(shot.original, shot.cached),
        **{name: view_picture(name, shot.probe) for name in chosen_views(views, shot.probe)},
    }
    paths: list[Path] = []
    for kind, picture in shown.items():
        paths.append(folder / f"{stem}-{kind}.png")
        write_png(paths[-1], picture)
    return paths

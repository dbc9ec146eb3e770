"""Writing the four pictures of a variant."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from shadercache.measure.measurement import Shot


def write_pictures(folder: Path, shot: Shot, views: Sequence[str] = ("hits",)) -> list[Path]:
    """Write original, cached, 10x difference and the views as PNG; return their paths.

    Raises :class:`UsageError` SC025 where the folder cannot be written, SC442 for an unknown view.
    """
    from shadercache.report.debug_views import chosen_views, view_picture
    from shadercache.report.images import difference_picture, picture, write_png

    stem = f"{re.sub(r'[^A-Za-z0-9._-]+', '-', shot.label)}-{shot.configuration.algorithm}"
    original, cached = picture(shot.original), picture(shot.cached)
    shown = {
        "original": original,
        "cached": cached,
        "difference": difference_picture(original, cached),
        **{name: view_picture(name, shot.probe) for name in chosen_views(views, shot.probe)},
    }
    paths: list[Path] = []
    for kind, pixels in shown.items():
        paths.append(folder / f"{stem}-{kind}.png")
        write_png(paths[-1], pixels)
    return paths

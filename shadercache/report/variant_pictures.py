"""All pictures of one variant at one frame, as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from shadercache.files import file_stem
from shadercache.measure.measurement import Shot
from shadercache.measure.shown import picture
from shadercache.report.debug_views import chosen_views, view_picture
from shadercache.report.error_images import absolute_error, signed_error
from shadercache.report.images import write_png


def write_pictures(folder: Path, shot: Shot, views: Sequence[str]) -> list[Path]:
    """Write original, cached, the error (absolute and signed) and the views as PNG; return their
    paths.

    Raises :class:`UsageError` SC025 where the folder cannot be written, SC442 for an unknown view.
    """
    stem = f"{file_stem(shot.label)}-{shot.configuration.algorithm}"
    original, cached = picture(shot.original), picture(shot.cached)
    pictures = {
        "original": original,
        "cached": cached,
        "difference": absolute_error(original, cached),
        "signed": signed_error(original, cached),
        **{name: view_picture(name, shot.probe) for name in chosen_views(views, shot.probe)},
    }
    paths = {folder / f"{stem}-{kind}.png": pixels for kind, pixels in pictures.items()}
    for path, pixels in paths.items():
        write_png(path, pixels)
    return list(paths)

"""Pictures for people: PNG files, the amplified difference, the hit map in false colours.

Input arrays have row 0 at the bottom (OpenGL); everything made here has row 0 at the top.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from shadercache.files import write_bytes
from shadercache.measure.shown import Picture

Color = tuple[int, int, int]

LEGEND: Mapping[str, tuple[Color, str]] = {
    "hit": ((38, 132, 148), "hit: reused"),
    "refresh": ((240, 190, 70), "refresh: recomputed on purpose"),
    "outside": ((150, 90, 170), "miss: was outside the picture"),
    "depth": ((214, 75, 60), "miss: was hidden, or another surface"),
    "id": ((96, 176, 88), "miss: another object"),
    "poison": ((232, 232, 236), "miss: not finite, or out of range"),
    "magnified": ((70, 96, 200), "miss: has become too large"),
    "opted-out": ((150, 150, 156), "miss: by the draw's mask"),
    "old": ((236, 130, 40), "refresh: older than the period"),
}
"""Colours of the hit map, told apart in grey and by most colour-blind people, and their meaning."""


def outcome_color(name: str, value: int) -> Color:
    """The colour of an outcome; one that is not known has a colour by its number."""
    if name in LEGEND:
        return LEGEND[name][0]
    # Steps without a common factor with 180: neighbouring numbers get distant colours.
    return (60 + 67 * value % 180, 60 + 113 * value % 180, 60 + 31 * value % 180)


def difference_picture(original: Picture, image: Picture) -> Picture:
    """Ten times the absolute difference, clipped."""
    difference = np.abs(original.astype(np.float32) - image.astype(np.float32))
    return np.minimum(10.0 * difference, 255.0).astype(np.uint8)


def hit_picture(mask: NDArray[np.uint8], values: Mapping[str, int]) -> Picture:
    """The hit mask (h, w) in false colours; uncovered pixels are black.

    ``values``: outcome -> the mask's number for it, from the manifest.
    """
    colors = np.zeros((256, 3), np.uint8)
    for outcome, value in values.items():
        colors[value] = outcome_color(outcome, value)
    return np.ascontiguousarray(colors[mask[::-1]])


def write_png(path: Path, shown: Picture) -> None:
    """Write a picture. Raises :class:`UsageError` SC025: the path cannot be written."""
    buffer = io.BytesIO()
    Image.fromarray(shown).save(buffer, "PNG", compress_level=4)  # 6: twice the time, 4 % smaller
    write_bytes(path, buffer.getvalue())

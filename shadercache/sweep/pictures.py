"""The pictures that a store keeps of a trial, as PNG files with row 0 at the top."""

from __future__ import annotations

import io
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from shadercache.measure.image_error import Pixels
from shadercache.measure.measurement import Shot
from shadercache.measure.shown import picture

THUMBNAIL = 160
"""Longer edge of a thumbnail, pixels."""

# Ages have fractions: look-ups blend them as they blend payloads.
AGE_STEPS = 16
"""What the picture ``ages`` holds is the age in frames times this, in 16 bits."""


def shot_pictures(shot: Shot) -> Iterator[tuple[str, bytes]]:
    """The layers of one frame: ``original``, ``cached``, ``outcomes`` (8 bits, the hit mask's own
    numbers, 0 where nothing is drawn), ``ages`` (where the cache keeps them), ``thumbnail``."""
    yield from drawn_pictures(shot.original, shot.cached)
    yield "outcomes", _png(shot.probe.mask[::-1])
    if shot.probe.ages is not None:
        steps = np.clip(np.rint(shot.probe.ages[::-1] * AGE_STEPS), 0, 65_535)
        yield "ages", _png(steps.astype(np.uint16))


def drawn_pictures(original: Pixels, drawn: Pixels) -> Iterator[tuple[str, bytes]]:
    """Those of anything that can be drawn: ``original``, ``cached``, and a ``thumbnail`` of it."""
    shown = picture(drawn)
    yield "original", _png(picture(original))
    yield "cached", _png(shown)
    small = Image.fromarray(shown)
    small.thumbnail((THUMBNAIL, THUMBNAIL))
    buffer = io.BytesIO()
    small.save(buffer, "WEBP", quality=80)
    yield "thumbnail", buffer.getvalue()


def payload_picture(pixels: NDArray[np.generic]) -> bytes:
    """The payload as it was drawn, clipped to 0-1."""
    return _png(picture(pixels))


def _png(pixels: NDArray[np.generic]) -> bytes:
    buffer = io.BytesIO()
    # Level 6 takes twice the time for files 4 % smaller.
    Image.fromarray(np.ascontiguousarray(pixels)).save(buffer, "PNG", compress_level=4)
    return buffer.getvalue()

"""How old what a pixel reuses is, and how wrong pixels of each age are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from shadercache.measure.image_error import Floats, Mask
from shadercache.measure.metrics.pixel_motion import PixelMotion

Ages = NDArray[np.int64]
"""Frames since a pixel's payload was computed (h, w): 0 in this frame, -1 where none is cached."""


@dataclass(frozen=True, slots=True)
class AgeError:
    """Pixels whose payloads are ``youngest`` to ``oldest`` frames old.

    ``share`` of the pixels that have a payload; ``rmse`` display-encoded in 0-1, over channels.
    """

    youngest: int
    oldest: int
    share: float
    rmse: float


def next_ages(before: Ages, hit: Mask, cached: Mask, motion: PixelMotion) -> Ages:
    """The ages of a frame, from those of the frame before.

    A hit is one frame older than what the pixel nearest to its place was; filters that read four
    texels have a mean age that is not followed. What is ``cached`` and no ``hit`` was computed.
    """
    # A hit whose nearest texel is another surface's reused one of the other three.
    older = np.maximum(motion.nearest(before), 0) + 1
    return np.where(cached, np.where(hit, older, 0), -1)


class AgeErrors:
    """Adds up the error by age over the frames of a run.

    Ages are put together by powers of two: 0, 1, 2, 3-4, 5-8, 9-16 and so on.
    """

    def __init__(self) -> None:
        self._squares = np.zeros(64)
        self._pixels = np.zeros(64, np.int64)

    def add(self, ages: Ages, error: Floats, covered: Mask) -> None:
        """Add a frame; ``error`` (h, w, 3) is image - original, display-encoded in 0-1."""
        counted = covered & (ages >= 0)
        # An age of 0 counts as a half, whose place is 0.
        # log2 of powers of two is exact.
        places = np.ceil(np.log2(np.maximum(ages[counted], 0.5))).astype(np.int64) + 1
        squares = np.mean(error[counted].astype(np.float64) ** 2, axis=-1)
        self._squares += np.bincount(places, squares, minlength=64)
        self._pixels += np.bincount(places, minlength=64)

    def result(self) -> tuple[AgeError, ...]:
        """The ages that occur, the youngest first."""
        total = int(self._pixels.sum())
        return tuple(
            AgeError(
                youngest=0 if place == 0 else 1 + (1 << place - 1) // 2,
                oldest=0 if place == 0 else 1 << place - 1,
                share=float(pixels) / total,
                rmse=float(np.sqrt(self._squares[place] / pixels)),
            )
            for place, pixels in enumerate(self._pixels)
            if pixels
        )

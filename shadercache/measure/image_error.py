"""How far an image is from the original, over the covered pixels, display-encoded 0-1.

Non-finite pixels are looked for first: some error measures give them a finite score.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error

Pixels = NDArray[np.generic]
"""An image (h, w, 3 or 4): uint8, or floats; alpha is not looked at."""

Floats = NDArray[np.float32]
"""An image, or the difference of two (h, w, 3), display-encoded 0-1; or of one channel (h, w)."""

Mask = NDArray[np.bool_]
"""Which pixels count (h, w)."""

# A histogram adds up over frames; the differences themselves would have to be kept and sorted.
_BINS = 1 << 16


@dataclass(frozen=True, slots=True)
class ErrorStats:
    """Difference of images in display-encoded units (0-1).

    ``rmse`` over pixels and the three channels (the L2 error of the papers); ``p99`` and
    ``maximum`` of each pixel's largest channel difference; ``psnr`` in decibels for a peak of 1
    (infinite for equal images); ``pixels`` how many were compared.
    """

    rmse: float
    p99: float
    maximum: float
    psnr: float
    pixels: int


class ErrorSum:
    """Adds up the difference over the frames of a run.

    Percentiles come from a histogram of 65536 steps from 0 to 1, which is exact for 8-bit images.
    """

    def __init__(self) -> None:
        self._squares = 0.0
        self._maximum = 0.0
        self._histogram = np.zeros(_BINS, np.int64)

    def add(self, original: Pixels, image: Pixels, covered: NDArray[np.bool_]) -> float:
        """Compare one frame; returns its RMSE over the covered pixels (0 if none is covered).

        Raises :class:`InputError` SC604: an image holds NaN or infinity.
        """
        count = np.count_nonzero(covered)
        if not count:
            return 0.0
        both_bytes = original.dtype == image.dtype == np.uint8
        measured = _bytes_apart if both_bytes else _floats_apart
        squares, histogram, maximum = measured(original, image, covered)
        self._histogram += histogram
        self._squares += squares
        self._maximum = max(self._maximum, maximum)
        return math.sqrt(squares / (3 * count))

    def stats(self) -> ErrorStats:
        """The error over everything added so far."""
        count = int(self._histogram.sum())
        if count == 0:
            return ErrorStats(0.0, 0.0, 0.0, math.inf, 0)
        rmse = math.sqrt(self._squares / (3 * count))
        rank = math.ceil(0.99 * count)  # the nearest rank: a value that really is there
        p99 = int(np.searchsorted(np.cumsum(self._histogram), rank)) / (_BINS - 1)
        psnr = math.inf if rmse == 0.0 else -20.0 * math.log10(rmse)
        # A bin's value may exceed every difference that was rounded to it.
        return ErrorStats(rmse, min(p99, self._maximum), self._maximum, psnr, count)


def encoded_pair(original: Pixels, image: Pixels) -> tuple[Floats, Floats]:
    """Both images (h, w, 3) in single precision, display-encoded 0-1, without alpha.

    Raises :class:`InputError` SC604: an image holds NaN or infinity, covered or not, for metrics
    with windows look at both.
    """
    one, other = (_encoded(pixels[..., :3]).astype(np.float32) for pixels in (original, image))
    _require_finite(one, other)
    return one, other


def _bytes_apart(
    a: Pixels, b: Pixels, covered: NDArray[np.bool_]
) -> tuple[float, NDArray[np.int64], float]:
    """Sum of squares, histogram of each pixel's largest difference, the largest of all."""
    levels = np.maximum(a, b) - np.minimum(a, b)
    if levels.shape[2] == 4:  # whole pixels are picked ten times as fast as rows of channels
        levels = levels.view(np.uint32)[..., 0][covered].view(np.uint8).reshape(-1, 4)[:, :3]
    else:
        levels = levels[covered]
    flat = levels.astype(np.float64).ravel()
    # Exact in doubles. Not by BLAS: its threads spin on after a product, and whatever is timed next
    # loses a core to them (measured: 25 % slower frames).
    squares = float(np.einsum("p,p->", flat, flat)) / 255.0**2
    largest = np.maximum(np.maximum(levels[:, 0], levels[:, 1]), levels[:, 2])
    histogram = np.zeros(_BINS, np.int64)
    # 65535 = 257 * 255, so every level of a byte has a bin of its own.
    histogram[:: (_BINS - 1) // 255] = np.bincount(largest, minlength=256)
    return squares, histogram, float(largest.max()) / 255.0


def _floats_apart(
    a: Pixels, b: Pixels, covered: NDArray[np.bool_]
) -> tuple[float, NDArray[np.int64], float]:
    """The same for images of which one or both hold floats."""
    x, y = _encoded(a[covered][:, :3]), _encoded(b[covered][:, :3])
    _require_finite(x, y)
    difference = np.abs(x - y)
    squares = float(np.einsum("pc,pc->", difference, difference, dtype=np.float64))
    largest = difference.max(axis=1)
    # Float targets are not clipped: a difference may exceed 1, and the last bin takes it.
    bins = np.minimum(np.rint(largest * (_BINS - 1)), _BINS - 1).astype(np.intp)
    return squares, np.bincount(bins, minlength=_BINS), float(largest.max())


def _require_finite(*images: NDArray[np.floating[Any]]) -> None:
    bad = sum(int(np.count_nonzero(~np.isfinite(image))) for image in images)
    if bad:
        raise input_error("SC604", f"an image holds {bad} values that are NaN or infinite")


def _encoded(pixels: Pixels) -> NDArray[np.float64]:
    colors = pixels.astype(np.float64)
    return colors / 255.0 if pixels.dtype == np.uint8 else colors

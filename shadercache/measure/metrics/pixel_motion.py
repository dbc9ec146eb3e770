"""Where each pixel was in the frame before, and images of that frame brought to this one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from shadercache.measure.image_error import Floats, Mask
from shadercache.render.surfaces import Surface

NEAR = 0.02
"""So much may the 1/w of a texel be off that of the point that is looked for, relative to it, and
still count as the same surface (as the look-ups of the variants have it, times the slope)."""

ROUNDED = 1.0 / 256.0
"""Pixels by which the place of a pixel's centre may be off: as fine as rasterisers are."""


@dataclass(frozen=True, eq=False)
class PixelMotion:
    """Of each pixel of a frame, where its point was in the frame before.

    ``place`` (h, w, 2): x and y in pixels of that frame, whose centres are at halves; ``both``
    (h, w): whether it was visible there, with all four pixels around it of the same surface.
    """

    place: NDArray[np.float64]
    both: Mask

    def warped(self, image: Floats) -> Floats:
        """An image (h, w, c) of the frame before as this frame sees it, interpolated linearly.

        It means something only where ``both``.
        """
        corner, part = self._corner
        low = self._within(corner)
        high = self._within(corner + 1)
        right, up = part[..., :1].astype(image.dtype), part[..., 1:].astype(image.dtype)
        below = (1 - right) * image[low[1], low[0]] + right * image[low[1], high[0]]
        above = (1 - right) * image[high[1], low[0]] + right * image[high[1], high[0]]
        warped: Floats = (1 - up) * below + up * above
        return warped

    def nearest(self, values: NDArray[np.int64]) -> NDArray[np.int64]:
        """Values (h, w) of the frame before at the pixels in which the points were."""
        x, y = self._within(np.floor(np.nan_to_num(self.place)))
        return values[y, x]

    @property
    def _corner(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The centre below and to the left, as an index, and how far beyond it the point was."""
        # A point behind the camera has no place.
        at = np.nan_to_num(self.place - 0.5)
        corner = np.floor(at)
        return corner, at - corner

    def _within(self, index: NDArray[np.float64]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        height, width = self.both.shape
        x = np.clip(index[..., 0], 0, width - 1).astype(np.intp)
        y = np.clip(index[..., 1], 0, height - 1).astype(np.intp)
        return x, y


def motion_between(now: Surface, before: Surface) -> PixelMotion:
    """The motion from one frame to the next; both are of the same size."""
    height, width = now.number.shape
    place = now.place
    last = np.array([width - 1, height - 1])
    with np.errstate(invalid="ignore", divide="ignore"):
        at = place - 0.5
        # Where 1/w was not positive, the point lay behind the camera.
        both: Mask = (now.number > 0) & (now.before > 0.0) & np.isfinite(place).all(axis=-1)
        both &= ((at >= -ROUNDED) & (at <= last + ROUNDED)).all(axis=-1)
        corner = np.clip(np.floor(at), 0, last)
        x = np.where(both, corner[..., 0], 0).astype(np.intp)
        y = np.where(both, corner[..., 1], 0).astype(np.intp)
        for right in (0, 1):
            for up in (0, 1):
                # At the last row and column nothing is beyond, and nothing weighs there.
                tap = np.minimum(y + up, height - 1), np.minimum(x + right, width - 1)
                off = before.inverse_w[tap] / now.before - 1.0
                both &= (before.number[tap] == now.number) & (np.abs(off) <= NEAR)
    return PixelMotion(place, both)

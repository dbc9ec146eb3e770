"""Flicker: what changes from frame to frame that does not change in the original."""

from __future__ import annotations

import numpy as np

from shadercache.measure.image_error import Floats, Mask
from shadercache.measure.metrics.pixel_motion import PixelMotion


def flicker(now: Floats, before: Floats, motion: PixelMotion, covered: Mask) -> tuple[float, int]:
    """The sum of squares, over channels, of the error of the change; and of how many pixels.

    The change of an image is the image less the last one, each point where it is now. The error of
    it is that of the cached image less that of the original, so it is the error ``now`` less the
    error ``before`` at the same points: both (h, w, 3), image - original, display-encoded in 0-1.
    Pixels count that are covered and were visible in both frames. The flicker of a run is the root
    of the mean square: 0 where an error, however large, moves along with the surface.
    """
    counted = covered & motion.both
    change = (now - motion.warped(before))[counted].astype(np.float64)
    return float(np.sum(change**2)), int(np.count_nonzero(counted))

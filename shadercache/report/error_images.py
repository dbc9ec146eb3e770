"""The error of an image as a picture, by channel: how large it is, and in which direction.

The scale is chosen for each pair of images and stands in the legend.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from shadercache.measure.shown import Picture
from shadercache.report.debug_views import with_legend
from shadercache.report.images import Color

SCALES = (1, 2, 5, 10, 20, 50, 100)

FITTING = 0.999
"""So many of the values are shown as they are; the rest is clipped."""

_GREY: Color = (128, 128, 128)
_BLACK: Color = (0, 0, 0)
_WHITE: Color = (255, 255, 255)


def absolute_error(original: Picture, image: Picture) -> Picture:
    """The size of the error: black where there is none, with a legend."""
    scale = scale_of(original, image)
    size = np.abs(_signed(original, image))
    shown = np.minimum(scale * size, 255).astype(np.uint8)
    return with_legend(shown, [(_BLACK, "equal"), (_WHITE, f"{1 / scale:g} or more apart")])


def signed_error(original: Picture, image: Picture) -> Picture:
    """The error with its sign: grey where there is none, brighter where the image is too bright."""
    scale = scale_of(original, image)
    # Half of the scale, for either direction has half of the levels.
    shown = np.clip(128 + np.rint(0.5 * scale * _signed(original, image)), 0, 255).astype(np.uint8)
    legend = [
        (_BLACK, f"too dark by {1 / scale:g} or more"),
        (_GREY, "equal"),
        (_WHITE, f"too bright by {1 / scale:g} or more"),
    ]
    return with_legend(shown, legend)


def scale_of(original: Picture, image: Picture) -> int:
    """By how much errors are multiplied so that nearly all fit: the largest of ``SCALES`` that
    does, which is 1 where none does."""
    sizes = np.sort(np.abs(_signed(original, image)), axis=None)
    largest = max(1, int(sizes[math.ceil(FITTING * sizes.size) - 1]))
    return max((scale for scale in SCALES if scale * largest <= 255), default=SCALES[0])


def _signed(original: Picture, image: Picture) -> NDArray[np.int32]:
    return image.astype(np.int32) - original.astype(np.int32)

"""Images as they are shown to people."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from shadercache.measure.image_error import Pixels

Picture = NDArray[np.uint8]
"""(h, w, 3) with row 0 at the top."""


def picture(pixels: Pixels) -> Picture:
    """An image as it is shown: 8 bits, no alpha, right way up."""
    colors = pixels[::-1, :, :3]
    if colors.dtype != np.uint8:
        # A cast of NaN to a byte is undefined, and differs between processors.
        safe = np.nan_to_num(colors.astype(np.float32), nan=0.0, posinf=1.0, neginf=0.0)
        colors = np.rint(np.clip(safe, 0.0, 1.0) * 255.0)
    return np.ascontiguousarray(colors, np.uint8)

"""FLIP: how much one sees when two images are shown in turns (Andersson et al. 2020), by its
authors' flip-evaluator."""

from __future__ import annotations

import numpy as np

from shadercache.measure.image_error import Floats, Mask

PIXELS_PER_DEGREE = 67.0
"""Of the viewer's field of view: a 4K monitor 0.7 m wide, seen from 0.7 m. It is the default of the
paper."""

RADIUS = 16
"""A pixel's value depends on pixels up to so far away, and not beyond, at these pixels a degree."""


def flip_error(original: Floats, image: Floats, covered: Mask) -> float | None:
    """The mean LDR-FLIP over the covered pixels: 0 for equal images, at most 1.

    On images (h, w, 3) that are encoded as sRGB, in 0-1; what lies outside is clipped, as a display
    does. None where nothing is covered. Needs flip-evaluator.
    """
    if not covered.any():
        return None
    import flip_evaluator

    shown = (np.ascontiguousarray(np.clip(one, 0.0, 1.0), np.float32) for one in (original, image))
    errors, _, _ = flip_evaluator.evaluate(
        *shown,
        "LDR",
        inputsRGB=True,
        applyMagma=False,
        computeMeanError=False,
        parameters={"ppd": PIXELS_PER_DEGREE},
    )
    return float(np.mean(errors[..., 0][covered], dtype=np.float64))

"""Whether what a variant takes for its vertices' places in the last frame is where they were.

A vertex shader tells its places when it runs alone (:mod:`render.position_pass`).
"""

from __future__ import annotations

import numpy as np

from shadercache.render.bound_pass import FrameInputs
from shadercache.render.position_pass import PositionPass, Positions
from shadercache.scene.camera import Values

EXACT = 1e-5
"""How far two positions may be apart and count as the same, relative to their size: programs that
are compiled by themselves may round in other ways."""

_SHAKEN = (0.03, 0.01)
"""By how much of themselves, and by how much besides, uniforms are changed."""


def misplaced(of: PositionPass, inputs: FrameInputs, truth: Positions) -> str:
    """What is wrong with a varying as the vertices' places in the last frame; or nothing.

    ``truth`` is where the last frame drew the vertices.
    """
    positions = of.captured(inputs)
    # Both may be infinite or NaN, where only the bits can be compared.
    with np.errstate(invalid="ignore", over="ignore"):
        size = np.abs(truth).max(axis=-1)
        away = np.abs(positions - truth).max(axis=-1)
        bits = positions.view(np.uint32), truth.view(np.uint32)
        same = (away <= EXACT * size) | (bits[0] == bits[1]).all(-1)
    # What is not finite was drawn nowhere, so nothing is reused of it.
    wrong = ~same & np.isfinite(truth).all(-1)
    if not wrong.any():
        return ""
    return (
        f"{of.shader} takes {int(np.count_nonzero(wrong)):,} of {len(truth):,} "
        "vertices to have been elsewhere in the last frame than they were, by up to "
        f"{float(np.max(away[wrong] / size[wrong])):.2g} of their clip-space position"
    )


def shaken(values: Values) -> Values:
    """The uniforms, every number of them changed: what a frame before might have had."""
    random = np.random.default_rng(20)
    # A share alone would leave a zero as it is.
    share, more = _SHAKEN
    return {
        name: value * (1.0 + share * random.uniform(-1.0, 1.0, value.shape))
        + more * random.uniform(0.5, 1.0, value.shape)
        for name, value in values.items()
    }

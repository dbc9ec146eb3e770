"""The pattern of blocks that are refreshed together, as it is seen in the error.

After Wang et al. 2000, who find the blocks of JPEG in this way: what the error steps by from pixel
to pixel is largest at the edges of the blocks, so the spectrum of the steps' size has a line at one
per block. (The error's own spectrum has none. Which blocks are refreshed is random, so it is that
of one block, a sinc, which is zero at one per block.)
"""

from __future__ import annotations

import numpy as np

from shadercache.measure.image_error import Floats, Mask

FEWEST_BLOCKS = 8
"""Of fewer blocks in a row a line could not be told from what is beside it."""

_STRIPE = 16
"""So many rows are averaged: edges of blocks are in the same columns, all else averages out. More
would leave too few stripes, whose powers are averaged in turn, to tell a line from chance."""

_SLOW = 3
"""So many of the lowest frequencies are the shape of the object, spread by the window."""

_BESIDE = 8
"""So many frequencies on either side say what is usual there. The nearest is left out: the window
spreads a line to it."""


def block_pattern(error: Floats, covered: Mask, block: int) -> float | None:
    """The power at one per ``block`` pixels over the median of that beside it; about 1 without a
    pattern.

    ``error`` (h, w) is the mean over the channels of image - original, display-encoded in 0-1; only
    ratios count, so any range will do. The size of its steps between covered neighbours, averaged
    over stripes of 16 rows, less the mean, is weighted by a Hann window; the powers of all stripes
    are averaged. The result is the mean of that along rows and along columns. None for an error
    that has no steps, and for fewer than eight blocks in a row.
    """
    if not covered.any():
        return None
    rows, columns = np.flatnonzero(covered.any(axis=1)), np.flatnonzero(covered.any(axis=0))
    # The box need not begin at the edge of a block: powers know no phase.
    box = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    along = _line(error[box], covered[box], block), _line(error[box].T, covered[box].T, block)
    found = [line for line in along if line is not None]
    return float(np.mean(found)) if found else None


def _line(error: Floats, covered: Mask, block: int) -> float | None:
    """The same along rows alone."""
    # A whole number of blocks, so that the line falls on a frequency.
    length = (error.shape[1] - 1) // block * block
    if length < FEWEST_BLOCKS * block:
        return None
    both = (covered[:, 1:] & covered[:, :-1])[:, :length]
    steps = np.abs(np.diff(error.astype(np.float64), axis=1))[:, :length]
    if not steps[both].any():
        return None
    # What is not covered gets the mean, 0: anything else would show the object's outline as steps.
    steps = np.where(both, steps - steps[both].mean(), 0.0)
    starts = np.arange(0, len(steps), _STRIPE)
    counts = np.maximum(np.add.reduceat(both, starts, axis=0, dtype=np.int64), 1)
    stripes = np.add.reduceat(steps, starts, axis=0) / counts * np.hanning(length)
    powers = np.mean(np.abs(np.fft.rfft(stripes, axis=1)) ** 2, axis=0)
    at = length // block
    # A line at a block of 2 is the highest frequency there is: places above it do not exist.
    beside = [*range(max(_SLOW, at - _BESIDE), at - 1), *range(at + 2, at + _BESIDE + 1)]
    usual = float(np.median(powers[[place for place in beside if place < len(powers)]]))
    return float(powers[at]) / usual if usual > 0.0 else None

"""Payloads that no later frame may reuse: how many there are, in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import GuardKind
from shadercache.caching.layout import Layout, precision_of

_LATER = {"miss": "", "clamp": "; guard=clamp has numbers for them later", "off": ""}


def told_of(
    cache: NDArray[np.float32], covered: NDArray[np.bool_], layout: Layout, guard: GuardKind
) -> str:
    """What of the payloads in a cache of 32-bit floats is not finite or too small; else nothing.

    ``cache`` as :meth:`VariantRunner.cache` gives it; pixels count where ``covered``.
    """
    channels = [channel for channel, discrete in layout.read_back if not discrete]
    found = cache[covered][:, channels]
    size = np.abs(found)
    least = np.float32(precision_of("rgba32f").least)
    kinds = {
        "NaN": np.isnan(found),
        "infinite": np.isinf(found),
        # Compared as bits: a processor that flushes such numbers finds them equal to zero.
        "below the smallest normal number": (size.view(np.uint32) > 0)
        & (size.view(np.uint32) < least.view(np.uint32)),
    }
    counts = {word: int(marks.any(axis=1).sum()) for word, marks in kinds.items()}
    words = [f"{word} in {count:,}" for word, count in counts.items() if count]
    if not words:
        return ""
    pixels = f"of {int(covered.sum()):,} pixels"
    return f"the payload is {', '.join(words)} {pixels}{_LATER[guard]}"

"""How far a cache can tell depths apart, by what is kept of them and in which format."""

from __future__ import annotations

from shadercache.emit.layout import precision_of
from shadercache.options import CacheFormat, DepthKind

SCALE = 16.0
"""What 1/w is multiplied by where it is kept (``macros.glsl``)."""

_SMALLEST = {"rgba16f": 2.0**-25, "rgba32f": 2.0**-150}
"""What a number near zero is rounded by at most."""


def rounding(depth: DepthKind, form: CacheFormat, w: float, near: float, far: float) -> float:
    """What a depth at ``w`` is rounded by where it is kept, relative to 1/w; at most 1."""
    held = precision_of(form)
    unit = 2.0 * near * far / (far - near)
    kept, scale = {
        "inverse-w": (SCALE / w, SCALE / w),
        "linear": (w, w),
        "ndc": ((far + near) / (far - near) - unit / w, unit / w),
    }[depth]
    if abs(kept) > held.limit:
        return 1.0
    return min(1.0, max(abs(kept) * held.resolution, _SMALLEST[form]) / scale)


def resolved_until(
    depth: DepthKind, form: CacheFormat, epsilon: float, near: float, far: float
) -> float:
    """The depth w up to which what is kept is rounded by less than ``epsilon``; at most ``far``.

    What lies farther misses falsely, or hits what lies a little before or behind it. Rounding
    grows with w, but for what is larger than the format holds, so the bound is sought by halving.
    """
    if rounding(depth, form, far, near, far) <= epsilon:
        return far
    low, high = near, far
    for _ in range(60):
        middle = (low * high) ** 0.5
        if rounding(depth, form, middle, near, far) <= epsilon:
            low = middle
        else:
            high = middle
    return low

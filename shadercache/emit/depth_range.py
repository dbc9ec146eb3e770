"""How far a cache can tell depths apart, by what is kept of them and in which format."""

from __future__ import annotations

from shadercache.caching.configuration import CacheFormat, Configuration, DepthKind
from shadercache.caching.layout import precision_of
from shadercache.diagnostics import Diagnostic, Severity

SCALE = 16.0
"""What 1/w is multiplied by where it is kept (``caching/glsl/depth``)."""

_SMALLEST = {"rgba16f": 2.0**-25, "rgba32f": 2.0**-150}  # Half of what is next to zero.
"""What a number near zero is rounded by at most."""


def rounding(depth: DepthKind, form: CacheFormat, w: float, near: float, far: float) -> float:
    """What a depth at ``w`` is rounded by where it is kept, relative to 1/w; at most 1."""
    held = precision_of(form)
    # In the usual perspective z/w is (far + near) / (far - near) - unit / w.
    unit = 2.0 * near * far / (far - near)
    kept, scale = {
        "inverse-w": (SCALE / w, SCALE / w),
        "linear": (w, w),
        "ndc": ((far + near) / (far - near) - unit / w, unit / w),
    }[depth]
    # A depth that the format cannot hold tells nothing.
    if abs(kept) > held.limit:
        return 1.0
    return min(1.0, max(abs(kept) * held.resolution, _SMALLEST[form]) / scale)


def resolved_until(
    depth: DepthKind, form: CacheFormat, epsilon: float, near: float, far: float
) -> float:
    """The depth w up to which what is kept is rounded by less than ``epsilon``; at most ``far``.

    What lies farther misses falsely, or hits what lies a little before or behind it.
    """
    if rounding(depth, form, far, near, far) <= epsilon:
        return far
    # Rounding grows with w, but for what is larger than the format holds.
    low, high = near, far
    for _ in range(60):
        # Halved by ratio: the planes may be magnitudes apart.
        middle = (low * high) ** 0.5
        if rounding(depth, form, middle, near, far) <= epsilon:
            low = middle
        else:
            high = middle
    return low


def depth_warnings(configuration: Configuration, near: float, far: float) -> tuple[Diagnostic, ...]:
    """SC431 where the cache cannot tell depths apart in all of a perspective's range."""
    depth, form = configuration.storage.depth, configuration.storage.format
    until = resolved_until(depth, form, configuration.hit_test.epsilon, near, far)
    if until >= far:
        return ()
    message = (
        f"depth={depth} in {form} is rounded by more than epsilon beyond w = {until:.3g}, and the "
        f"scene reaches from {near:g} to {far:g}: what lies there is mostly computed anew"
    )
    hint = "take depth=inverse-w" if depth != "inverse-w" else "take --format rgba32f"
    return (Diagnostic("SC431", message, hint=hint, severity=Severity.WARNING),)

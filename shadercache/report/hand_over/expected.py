"""What was measured of a variant that is handed over."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Expected:
    """Gain and error on frames that were not used for choosing.

    ``speedup``: time of the original over that of the variant, the median, and the ends of its
    95 % interval. ``mean`` and ``worst``: the error of a frame in ``metric``; ``bound`` is what it
    had to stay below, if anything. ``size``: width and height in pixels.
    """

    speedup: float
    low: float
    high: float
    metric: str
    mean: float
    worst: float
    bound: float | None
    size: tuple[int, int]
    frames: int
    renderer: str

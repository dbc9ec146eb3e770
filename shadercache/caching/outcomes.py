"""What a look-up says of a pixel, and the numbers that its hit test goes by."""

from __future__ import annotations

from shadercache.caching.configuration import Configuration

OUTCOMES = {
    **{"hit": 1, "refresh": 2, "outside": 3, "depth": 4},
    **{"id": 5, "poison": 6, "magnified": 7, "opted-out": 8, "old": 9},
}
"""What a look-up says, as the hit mask shows it (0: nothing is drawn there)."""

_OPTIONAL = {
    "id": lambda chosen: chosen.hit_test.ids,
    "poison": lambda chosen: chosen.storage.guard == "miss",
    "magnified": lambda chosen: chosen.hit_test.magnification,
    "opted-out": lambda chosen: chosen.hit_test.mask,
    "old": lambda chosen: chosen.refresh.age,
}
"""Outcome -> do look-ups of such a configuration say so? (The others always do.)"""

SPREAD = 24.0
"""How many epsilons a single texel of the filter may be off in depth (docs/why/reuse.md)."""

INTERPOLATION = 1.2e-5
"""What the interpolation of positions leaves uncertain in 1/w, relative to it: 4.3e-4 of a pixel,
on the steepest slope that ``SPREAD`` lets through, and rounding (docs/why/reuse.md)."""

LEAST_WEIGHT = 0.25
"""What those texels must weigh together that fit in the depth-aware filter: as the nearest may."""


NEARBY = 2e-3
"""What the depth of a texel of a smaller cache may be off, relative to 1/w, where its payload is
taken for a pixel beside it: the surface may bend between the two (docs/why/rate.md)."""

STEEPEST = 0.024
"""How much the depth of such a texel may differ from the pixel's, by the same measure."""

REACHES = {"REACH": 1.0, "REACH_ROUGH": 0.6, "REACH_ALONE": 0.25}
"""How far from its pixel's centre, in pixels and each direction, a carried sample may lie: where
all four texels show one plane, where they show one surface, and where only some of them do
(docs/lab/reuse.md)."""

LEAST_AREA = 0.5
"""What a pixel of a carried sample must have covered in the previous frame, in pixels."""


def outcomes(configuration: Configuration) -> dict[str, int]:
    """What a look-up can say."""
    return {
        word: value
        for word, value in OUTCOMES.items()
        if word not in _OPTIONAL or _OPTIONAL[word](configuration)
    }

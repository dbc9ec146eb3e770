"""What can be chosen about a rewrite."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

Mode: TypeAlias = Literal["plain", "proof"]
CacheFormat: TypeAlias = Literal["rgba16f", "rgba32f"]

MappingKind: TypeAlias = Literal["surface", "screen", "user"]
"""Where a fragment finds what the previous frame stored: where its point of the surface was then,
at its own pixel, or where a function of the user's says (docs/TRANSFORMATIONS.md)."""

PREVIOUS_CLIP, CURRENT_CLIP = "scPreviousClip", "scCurrentClip"
"""The user's functions that ``user`` calls; without the second the pixel's own place is taken."""

ALGORITHMS = (1, 2, 3)

DEFAULT_EPSILON = 1e-3
"""Accepted relative difference of 1/w: twice what half floats round it by (docs/NUMERICS.md)."""


@dataclass(frozen=True, slots=True)
class Options:
    """Options of a rewrite.

    ``mode``: ``plain`` is what is shipped, ``proof`` forbids the driver to rearrange arithmetic.
    ``cache_format``: the texture format of the cache. ``epsilon``: the hit test's accepted
    difference of depths, relative to the depth.
    """

    mode: Mode = "plain"
    cache_format: CacheFormat = "rgba16f"
    epsilon: float = DEFAULT_EPSILON

"""What can be chosen about a rewrite."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

Mode: TypeAlias = Literal["plain", "proof"]
CacheFormat: TypeAlias = Literal["rgba16f", "rgba32f"]

ALGORITHMS = (1, 2, 3)

DEFAULT_EPSILON: dict[CacheFormat, float] = {"rgba16f": 2e-3, "rgba32f": 1e-3}
"""Accepted relative difference of 1/w. Half floats alone round by up to 5e-4."""


@dataclass(frozen=True, slots=True)
class Options:
    """Options of a rewrite.

    ``mode``: ``plain`` is what is shipped, ``proof`` forbids the driver to rearrange arithmetic.
    ``cache_format``: the texture format of the cache. ``epsilon``: the hit test's accepted
    difference of depths, relative to the depth; ``None`` takes the default of the format.
    """

    mode: Mode = "plain"
    cache_format: CacheFormat = "rgba16f"
    epsilon: float | None = None

    @property
    def tolerance(self) -> float:
        """The epsilon in force."""
        return DEFAULT_EPSILON[self.cache_format] if self.epsilon is None else self.epsilon

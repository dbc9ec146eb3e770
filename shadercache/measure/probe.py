"""What became of each pixel of a frame, as its debug program and its cache say."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Probe:
    """What a frame's debug program and its cache say.

    ``mask`` (h, w): 0 where nothing is drawn, else one of ``values`` by outcome. ``ages`` (h, w):
    in frames, where the cache keeps them; ``period`` is the refresh period.
    """

    mask: NDArray[np.uint8]
    values: Mapping[str, int]
    ages: NDArray[np.float32] | None
    period: int

    @property
    def shares(self) -> dict[str, float]:
        """Of the pixels where something is drawn, the share of each outcome."""
        counts = np.bincount(self.mask.ravel(), minlength=256)
        covered = max(1, self.mask.size - int(counts[0]))
        return {name: float(counts[value]) / covered for name, value in self.values.items()}

"""The error over all outputs of a shader, and of each of several."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from shadercache.gpu.color_targets import holds_integers
from shadercache.measure.image_error import ErrorStats, ErrorSum, Mask, Pixels


@dataclass(frozen=True, slots=True)
class OutputError:
    """Of one output: the RMSE of floats, in their own unit; of integers, which have no distance,
    the share of the covered pixels that changed."""

    output: str
    error: float
    integers: bool


class OutputErrors:
    """Adds up the error of every output over the frames of a run.

    The error of the whole is over the outputs of floats, as if they lay side by side; where all are
    integers a pixel that changed counts as 1.
    """

    def __init__(self) -> None:
        self._whole = ErrorSum()
        self._each: list[ErrorSum] = []
        self._integers: list[bool] = []

    def add(self, originals: Sequence[Pixels], images: Sequence[Pixels], covered: Mask) -> float:
        """Compare one frame, output by output; returns the RMSE of the whole.

        Raises :class:`InputError` SC604: an output of floats holds NaN or infinity.
        """
        self._integers = list(map(holds_integers, images))
        both = zip(originals, images, self._integers, strict=True)
        pairs = [_changes(a, b) if integers else (a, b) for a, b, integers in both]
        if len(pairs) == 1:
            return self._whole.add(*pairs[0], covered)
        self._each = self._each or [ErrorSum() for _ in pairs]
        for one, pair in zip(self._each, pairs, strict=True):
            one.add(*pair, covered)
        counted = [
            pair
            for pair, integers in zip(pairs, self._integers, strict=True)
            if not integers or all(self._integers)
        ]
        squares = [self._whole.add(*pair, covered) ** 2 for pair in counted]
        return math.sqrt(sum(squares) / len(squares))

    def stats(self) -> ErrorStats:
        """The error of the whole."""
        return self._whole.stats()

    def each(self, names: Sequence[str]) -> tuple[OutputError, ...]:
        """The error of each output, where there are several."""
        rows = zip(names, self._each, self._integers, strict=bool(self._each))
        return tuple(
            # Of changes that are 0 or 1 the mean is that of their squares.
            OutputError(name, one.stats().rmse ** (2 if integers else 1), integers)
            for name, one, integers in rows
        )


def _changes(original: Pixels, image: Pixels) -> tuple[Pixels, Pixels]:
    """Black, and white where a pixel changed."""
    changed = np.any(original != image, axis=-1)
    white = np.where(changed, np.uint8(255), np.uint8(0))
    return np.zeros((*white.shape, 3), np.uint8), np.repeat(white[..., None], 3, axis=-1)

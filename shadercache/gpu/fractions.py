"""Targets that are a fraction of the picture: their sizes, viewports and coordinates."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

Viewport: TypeAlias = tuple[int, int, int, int]
"""Left, bottom, width and height, in pixels."""


WhichDepth: TypeAlias = Literal["shared", "apart", "marks"]
"""A depth buffer: what objects share, another one for targets of another size, or one of marks."""


def divided_size(size: tuple[int, int], divisor: int) -> tuple[int, int]:
    """Width and height of targets that are so many times smaller in each direction: rounded up, so
    that they cover every pixel."""
    return -(-size[0] // divisor), -(-size[1] // divisor)


def divided(viewport: Viewport, divisor: int) -> Viewport:
    """The viewport in such targets. (It lies inside of them, wherever it lies in the picture.)"""
    left, bottom, width, height = viewport
    return left // divisor, bottom // divisor, *divided_size((width, height), divisor)


def scale_of(viewport: Viewport, divisor: int) -> NDArray[np.float64]:
    """What leads from pixels to texels of such targets: a factor for each direction, and what is
    added."""
    whole, small = np.array(viewport, np.float64), np.array(divided(viewport, divisor), np.float64)
    factor = small[2:] / whole[2:]
    return np.concatenate([factor, small[:2] - factor * whole[:2]])


def spread(texels: NDArray[Any], size: tuple[int, int]) -> NDArray[Any]:
    """What such targets hold, for every pixel of a picture: (h, w), of the texel it lies in."""
    rows, columns = (
        ((np.arange(pixels) + 0.5) * (held / pixels)).astype(np.intp)
        for pixels, held in zip(size[::-1], texels.shape, strict=False)
    )
    return texels[np.ix_(rows, columns)]

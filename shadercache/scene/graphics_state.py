"""What an application sets beside its shaders: depth, polygon offset, clip space, jitter."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias, cast, get_args

import numpy as np
from numpy.typing import NDArray

from shadercache.scene.toml_reader import Table, is_numbers

DepthFunction: TypeAlias = Literal["less", "lequal", "greater", "gequal", "equal"]
ClipSpace: TypeAlias = Literal["symmetric", "zero-to-one"]

Rectangle: TypeAlias = tuple[float, float, float, float]
WHOLE: Rectangle = (0.0, 0.0, 1.0, 1.0)

ORIGINALS: Mapping[str, str] = {
    "less": "<",
    "lequal": "<=",
    "equal": "==",
    "greater": ">",
    "gequal": ">=",
}
"""What the application itself draws with."""


@dataclass(frozen=True, slots=True)
class GraphicsState:
    """State of an application.

    ``offset``: factor and units of the polygon offset. ``jitter``: over how many places the picture
    is shifted, by less than half a pixel, one a frame (0: it is not). ``jitter_told``: the previous
    positions have this frame's jitter, so that jitter is no motion. ``places``: these shifts in
    pixels, one a frame in turns, in place of those that ``jitter`` counts. ``viewports``: left,
    bottom, width and height as shares of the target, in turns of ``hold`` frames each.
    """

    depth: DepthFunction = "less"
    offset: tuple[float, float] = (0.0, 0.0)
    clip: ClipSpace = "symmetric"
    jitter: int = 0
    jitter_told: bool = True
    places: tuple[tuple[float, float], ...] = ()
    viewports: tuple[Rectangle, ...] = (WHOLE,)
    hold: int = 1

    def viewport(self, frame: int, size: tuple[int, int]) -> tuple[int, int, int, int]:
        """Left, bottom, width and height in pixels, in a target of a size."""
        left, bottom, width, height = self.viewports[frame // self.hold % len(self.viewports)]
        x, y = round(left * size[0]), round(bottom * size[1])
        return x, y, max(1, round(width * size[0])), max(1, round(height * size[1]))

    @property
    def reversed(self) -> bool:
        """Is what is near the greater depth?"""
        return self.depth in ("greater", "gequal")

    @property
    def empty_depth(self) -> float:
        """What depth is cleared to."""
        return 0.0 if self.reversed else 1.0

    def function(self, test: str) -> str:
        """moderngl's depth function for a pass that has this one where depth is not reversed.

        What the manifest tells engines as ``depth_functions``. ``equal`` stands for an application
        that draws depth first: the variants do without that pass.
        """
        return test.replace("<", ">") if self.reversed else test

    def projection(
        self, matrix: NDArray[np.float64], shift: tuple[float, float]
    ) -> NDArray[np.float64]:
        """A projection (clip z from -w to w) as it is here, shifted by ``shift`` of the picture's
        half width and height."""
        here = matrix.copy()
        # z/w becomes (z/w + 1) / 2, and 1 minus that where depth is reversed.
        if self.clip == "zero-to-one":
            here[2] = 0.5 * (here[2] + here[3])
            if self.reversed:
                here[2] = here[3] - here[2]
        elif self.reversed:
            here[2] = -here[2]
        if self.jittered:
            # Times w, so that after the division the shift is the same at every depth.
            here[0] += shift[0] * here[3]
            here[1] += shift[1] * here[3]
        return here

    @property
    def jittered(self) -> bool:
        """Is the picture shifted?"""
        return bool(self.jitter or self.places)

    def shift(self, frame: int) -> tuple[float, float]:
        """The jitter of a frame in pixels, each part within half a pixel of none."""
        if self.places:
            return self.places[frame % len(self.places)]
        if not self.jitter:
            return 0.0, 0.0
        # From 1 on: the first number of every Halton sequence is 0, a corner of the pixel.
        place = frame % self.jitter + 1
        return _halton(place, 2) - 0.5, _halton(place, 3) - 0.5


PLAIN = GraphicsState()


def read_engine(table: Table) -> GraphicsState:
    """``[engine]``."""
    depth = table.text("depth", "less", get_args(DepthFunction))
    clip = table.text("clip", "symmetric", get_args(ClipSpace))
    factor, units = table.checked(
        "polygon_offset", "factor and units", lambda value: is_numbers(value, 2), (0.0, 0.0)
    )
    rectangles = "rectangles inside of [0, 0, 1, 1]"
    viewports = table.rows("viewports", rectangles, _is_rectangle, least=1)
    return GraphicsState(
        depth=cast(DepthFunction, depth),
        offset=(float(factor), float(units)),
        clip=cast(ClipSpace, clip),
        jitter=table.whole("jitter", 0, least=0),
        jitter_told=table.boolean("jitter_told", True),
        viewports=tuple((float(a), float(b), float(c), float(d)) for a, b, c, d in viewports)
        or (WHOLE,),
        hold=table.whole("viewport_frames", 1, least=1),
    )


def _is_rectangle(value: Any) -> bool:
    if not is_numbers(value, 4):
        return False
    left, bottom, width, height = value
    inside = min(left, bottom) >= 0.0 and left + width <= 1.0 and bottom + height <= 1.0
    return bool(inside and width > 0.0 and height > 0.0)


def _halton(index: int, base: int) -> float:
    """The radical inverse: 1/2, 1/4, 3/4, ... for base 2."""
    result, part = 0.0, 1.0 / base
    while index:
        result += part * (index % base)
        index, part = index // base, part / base
    return result

"""What an application sets beside its shaders: depth functions, polygon offset, clip space, jitter.

The manifest names the passes' depth functions for an application that draws with ``less``; what
they are for another is in :data:`FUNCTIONS` here and in ``depth_functions`` there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from shadercache.scene.toml_reader import Table, is_number

DepthFunction: TypeAlias = Literal["less", "lequal", "greater", "gequal", "equal"]
ClipSpace: TypeAlias = Literal["symmetric", "zero-to-one"]

Rectangle: TypeAlias = tuple[float, float, float, float]
WHOLE: Rectangle = (0.0, 0.0, 1.0, 1.0)

FUNCTIONS: Mapping[str, Mapping[str, str]] = {
    "less": {"<": "<", "<=": "<=", "==": "=="},
    "lequal": {"<": "<", "<=": "<=", "==": "=="},
    "equal": {"<": "<", "<=": "<=", "==": "=="},
    "greater": {"<": ">", "<=": ">=", "==": "=="},
    "gequal": {"<": ">", "<=": ">=", "==": "=="},
}
"""An application's depth function -> a pass's, as the manifest says it -> the pass's there.

``equal`` stands for an application that draws depth first: the variants do without that pass.
"""

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

    ``offset``: factor and units of the polygon offset. ``jitter``: the picture is shifted by less
    than half a pixel, by another of so many places in each frame (0: it is not). ``told``: the
    previous positions are those of this frame's jitter, so that jitter is no motion.
    ``viewports``: left, bottom, width and height as shares of the target, in turns of ``hold``
    frames each.
    """

    depth: DepthFunction = "less"
    offset: tuple[float, float] = (0.0, 0.0)
    clip: ClipSpace = "symmetric"
    jitter: int = 0
    told: bool = True
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
        """moderngl's depth function of a pass that the manifest gives this one."""
        return FUNCTIONS[self.depth][test]

    def projection(
        self, matrix: NDArray[np.float64], shift: tuple[float, float]
    ) -> NDArray[np.float64]:
        """A projection (clip z from -w to w) as it is here, shifted by ``shift`` of the picture's
        half width and height."""
        made = matrix.copy()
        if self.clip == "zero-to-one":
            made[2] = 0.5 * (made[2] + made[3])
            if self.reversed:
                made[2] = made[3] - made[2]
        elif self.reversed:
            made[2] = -made[2]
        if self.jitter:
            made[0] += shift[0] * made[3]
            made[1] += shift[1] * made[3]
        return made

    def shift(self, frame: int) -> tuple[float, float]:
        """The jitter of a frame in pixels, each part within half a pixel of none."""
        if not self.jitter:
            return 0.0, 0.0
        place = frame % self.jitter + 1
        return _halton(place, 2) - 0.5, _halton(place, 3) - 0.5


PLAIN = GraphicsState()


def read_engine(table: Table) -> GraphicsState:
    """``[engine]``; mistakes are noted in the table."""
    pair = table.values.get("polygon_offset", [0.0, 0.0])
    if table.has("polygon_offset") and not _is_pair(pair):
        table.problem("SC505", "polygon_offset", "engine.polygon_offset must be factor and units")
        pair = [0.0, 0.0]
    depth = table.text("depth", "less", get_args(DepthFunction))
    clip = table.text("clip", "symmetric", get_args(ClipSpace))
    engine = GraphicsState(
        depth=next(known for known in get_args(DepthFunction) if known == depth),
        offset=(float(pair[0]), float(pair[1])),
        clip="zero-to-one" if clip == "zero-to-one" else "symmetric",
        jitter=table.whole("jitter", 0, least=0),
        told=table.boolean("jitter_told", True),
        viewports=_viewports(table),
        hold=table.whole("viewport_frames", 1, least=1),
    )
    table.refuse_unknown()
    return engine


def _viewports(table: Table) -> tuple[Rectangle, ...]:
    value = table.values.get("viewports", [list(WHOLE)])
    if table.has("viewports") and not (
        isinstance(value, list) and value and all(map(_is_rectangle, value))
    ):
        message = "engine.viewports must be rectangles inside of [0, 0, 1, 1]"
        table.problem("SC505", "viewports", message)
        return (WHOLE,)
    return tuple((float(a), float(b), float(c), float(d)) for a, b, c, d in value)


def _is_rectangle(value: object) -> bool:
    if not (isinstance(value, list) and len(value) == 4 and all(map(is_number, value))):
        return False
    left, bottom, width, height = value
    inside = min(left, bottom) >= 0.0 and left + width <= 1.0 and bottom + height <= 1.0
    return bool(inside and width > 0.0 and height > 0.0)


def _is_pair(value: object) -> bool:
    return (
        isinstance(value, list)
        and len(value) == 2
        and all(isinstance(number, int | float) for number in value)
    )


def _halton(index: int, base: int) -> float:
    """The radical inverse: 1/2, 1/4, 3/4, ... for base 2."""
    result, part = 0.0, 1.0 / base
    while index:
        result += part * (index % base)
        index, part = index // base, part / base
    return result

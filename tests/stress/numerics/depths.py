"""How well a format and an encoding of depth tell surfaces apart (S4, S18).

``python -m tests.stress.numerics.depths`` prints the table of docs/lab/reuse.md. A plane that faces
the camera is drawn at some depth, then asked for at another: at the same depth it must hit (a
*false miss* else), at one that lies twice the tolerance and the cache's rounding away it must miss
(a *false hit* else).
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from shadercache.caching.configuration import DEFAULT_EPSILON, CacheFormat, DepthKind, ToleranceKind
from shadercache.caching.layout import precision_of
from shadercache.caching.outcomes import INTERPOLATION
from shadercache.gpu.context import Gpu, open_context
from tests.configured import configured

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # as pytest has it

from tests.stress.numerics.plane import Plane, plane, projection

DEPTHS: tuple[DepthKind, ...] = ("inverse-w", "linear", "ndc")
FORMATS: tuple[CacheFormat, ...] = ("rgba16f", "rgba32f")
RANGES = ((1e-3, 1e1), (1e-3, 1e5), (0.1, 1e2), (1.0, 1e3), (1.0, 1e5))
"""Near and far plane."""


@dataclass
class Told:
    """Of surfaces at ``asked`` depths: how many missed falsely, at rest and when they came nearer,
    and how many hit falsely."""

    asked: int = 0
    resting: int = 0
    moving: int = 0
    hits: int = 0

    def __str__(self) -> str:
        shares = (self.resting, self.moving, self.hits)
        return " | ".join(f"{share / self.asked:.2f}" for share in shares)


def separation(
    form: CacheFormat, depth: DepthKind, tolerance: ToleranceKind, w: float, near: float, far: float
) -> float:
    """How far apart, relative to w, two surfaces at w must at least be not to be taken for one
    another (what Akeley and Su 2006 ask of a depth buffer): the accepted difference, and what the
    cache rounds by."""
    rounding = precision_of(form).resolution
    if depth == "ndc":
        a, b = projection(near, far)
        rounding *= abs(a + b / w) * w / -b
    accepted = DEFAULT_EPSILON if tolerance == "relative" else INTERPOLATION + rounding
    return accepted + rounding


def told(
    gpu: Gpu,
    form: CacheFormat,
    depth: DepthKind,
    tolerance: ToleranceKind,
    planes: tuple[float, float],
    steps: int = 12,
    apart: float = 2.0,
) -> Told:
    """Ask at so many depths from near to far; ``apart`` counts separations of false hits."""
    near, far = planes
    numbers = {"unit": 2.0 * near * far / (far - near)}
    cached = configured(
        refresh="none", filter="bilinear", depth=depth, tolerance=tolerance, fallback=depth != "ndc"
    )
    made = plane(gpu, cached, form, numbers=numbers)
    made.values["u_depth"] = projection(near, far)
    found = Told()
    for w in np.geomspace(near * 1.1, far / 1.1, steps):
        if not drawn(planes, w):
            continue
        away = 1.0 + apart * separation(form, depth, tolerance, w, near, far)
        found.asked += 1
        found.resting += not hits(made, w, w, w)
        found.moving += not hits(made, w, w, w * 0.97)
        for other in (w * away, w / away):
            found.hits += hits(made, w, other, other) if near < other < far else 0
    return found


def drawn(planes: tuple[float, float], w: float) -> bool:
    """Is what lies there before the far plane, as a depth buffer has it? Else nothing is drawn."""
    a, b = projection(*planes)
    return a + b / w < 1.0 - 2.0**-20


def hits(made: Plane, cached: float, expected: float, now: float) -> bool:
    """Is a plane at w = ``cached`` reused for one that was at ``expected`` and is at ``now``?

    More than half of the picture decides; all of it is at the same depth.
    """
    made.runner.reset()
    made.draw(0, u_value=(1.0, 1.0, 1.0), u_plane=(0.0, 0.0, cached))
    made.runner.last_values = made.values | {"u_plane": (0.0, 0.0, expected)}
    image = made.draw(1, u_value=(0.0, 0.0, 0.0), u_plane=(0.0, 0.0, now))
    return bool(image.mean() > 0.25)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the table: shares of false misses at rest, in motion, and of false hits."""
    print("| near, far | " + " | ".join(f"{f} {d}" for f in FORMATS for d in DEPTHS) + " |")
    print("|---" * (1 + len(FORMATS) * len(DEPTHS)) + "|")
    with open_context() as gpu:
        for planes in RANGES:
            cells = [told(gpu, f, d, "relative", planes, 40) for f in FORMATS for d in DEPTHS]
            row = " | ".join(str(cell).replace(" | ", " / ") for cell in cells)
            print(f"| {planes[0]:g}, {planes[1]:g} | {row} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

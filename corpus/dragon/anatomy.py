"""The body of the dragon: where its bones lie and how thick the flesh is.

The dragon looks along +x, +y is up and +z its right-hand side; it stands on y = 0 and is about
2.3 units long. Bones are Catmull-Rom splines through rows of (x, y, z, radius).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from field import Field, Part, capsule, ellipsoid, triangle

Rows = list[tuple[float, float, float, float]]
Curve = npt.NDArray[np.float64]

LOW, HIGH = (-1.55, -0.08, -1.35), (1.35, 2.25, 1.35)
"""The box the dragon stands in."""

TRUNK: Rows = [
    (-0.50, 0.50, 0.00, 0.150),
    (-0.38, 0.53, 0.00, 0.200),
    (-0.15, 0.52, 0.00, 0.210),
    (0.10, 0.55, 0.00, 0.250),
    (0.30, 0.64, 0.00, 0.235),
    (0.44, 0.80, 0.00, 0.178),
    (0.48, 0.98, 0.00, 0.136),
    (0.44, 1.16, 0.00, 0.116),
    (0.43, 1.33, 0.02, 0.106),
    (0.52, 1.48, 0.03, 0.104),
    (0.69, 1.53, 0.04, 0.104),
]
TAIL: Rows = [
    (-0.30, 0.52, 0.00, 0.190),
    (-0.52, 0.47, 0.00, 0.156),
    (-0.76, 0.33, 0.02, 0.126),
    (-0.96, 0.18, 0.12, 0.102),
    (-1.05, 0.11, 0.36, 0.086),
    (-0.96, 0.09, 0.63, 0.073),
    (-0.70, 0.08, 0.82, 0.062),
    (-0.36, 0.09, 0.88, 0.052),
    (-0.04, 0.12, 0.80, 0.042),
    (0.14, 0.22, 0.71, 0.033),
    (0.20, 0.37, 0.69, 0.025),
    (0.12, 0.48, 0.73, 0.018),
]
HEAD_AT, HEAD_DOWN, HEAD_SIZE = np.array([0.69, 1.53, 0.04]), np.radians(-18.0), 1.22


def spline(rows: Rows, samples: int) -> Curve:
    """``samples`` points (x, y, z, radius) of the Catmull-Rom spline through ``rows``."""
    points = np.array(rows, dtype=np.float64)
    ends = np.vstack([2 * points[0] - points[1], points, 2 * points[-1] - points[-2]])
    at = np.linspace(0.0, len(points) - 1.0, samples)
    i = np.minimum(at.astype(int), len(points) - 2)
    t = (at - i)[:, None]
    a, b, c, d = (ends[i + k] for k in range(4))
    return np.asarray(
        0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2)
        + 0.5 * (3 * b - a - 3 * c + d) * t**3
    )


def tube(curve: Curve) -> list[Part]:
    """Tapered capsules along a curve of (x, y, z, radius)."""
    return [capsule(p[:3], q[:3], p[3], q[3]) for p, q in pairwise(curve)]


def mirrored(rows: Rows, side: int) -> Rows:
    """The rows on the right (+1) or on the left (-1)."""
    return [(x, y, z * side, r) for x, y, z, r in rows]


@dataclass(frozen=True)
class Leg:
    """One leg: its bones from the trunk down and where its foot points."""

    bones: Rows
    muscle: tuple[tuple[float, float, float], tuple[float, float, float]]
    toe_length: float


FRONT = Leg(
    [
        (0.26, 0.58, 0.17, 0.130),
        (0.16, 0.36, 0.29, 0.090),
        (0.24, 0.20, 0.31, 0.068),
        (0.34, 0.07, 0.32, 0.056),
    ],
    ((0.24, 0.54, 0.20), (0.13, 0.19, 0.11)),
    0.15,
)
HIND = Leg(
    [
        (-0.36, 0.50, 0.17, 0.150),
        (-0.16, 0.30, 0.32, 0.100),
        (-0.40, 0.18, 0.34, 0.066),
        (-0.34, 0.06, 0.35, 0.058),
    ],
    ((-0.30, 0.45, 0.22), (0.19, 0.20, 0.12)),
    0.17,
)


def legs(field: Field) -> None:
    """Four legs with three toes and a spur each, every toe with a claw."""
    for leg, shift in ((FRONT, 0.06), (HIND, -0.05)):
        for side in (1, -1):
            step = shift * side
            rows = [(x + step * (i / 3), y, z, r) for i, (x, y, z, r) in enumerate(leg.bones)]
            bones = mirrored(rows, side)
            centre, radii = leg.muscle
            field.union([ellipsoid((centre[0], centre[1], centre[2] * side), radii)], 0.09)
            field.union(tube(spline(bones, 22)), 0.06)
            foot = np.array(bones[-1][:3])
            for angle in (-38.0, 0.0, 38.0, 180.0):
                _toe(field, foot, np.radians(angle - 14.0 * side), leg.toe_length)


def _toe(field: Field, foot: Curve, angle: float, length: float) -> None:
    ahead = np.array([np.cos(angle), 0.0, np.sin(angle)])
    reach = length if np.cos(angle) > 0 else 0.55 * length
    knuckle = foot + ahead * reach * 0.5
    knuckle[1] -= 0.005
    tip = foot + ahead * reach
    tip[1] = 0.034
    field.union([capsule(foot, knuckle, 0.048, 0.042), capsule(knuckle, tip, 0.042, 0.034)], 0.03)
    root, claw = tip.copy(), tip + ahead * 0.062
    root[1], claw[1] = 0.042, 0.004
    field.union([capsule(root, claw, 0.024, 0.007)], 0.012)


def trunk(field: Field) -> None:
    """Trunk with neck, belly and breast, then the tail with its barb."""
    field.union(tube(spline(TRUNK, 60)), 0.0)
    field.union([ellipsoid((0.24, 0.56, 0.0), (0.21, 0.25, 0.20))], 0.10)
    field.union([ellipsoid((-0.12, 0.47, 0.0), (0.32, 0.17, 0.20))], 0.10)
    field.union(tube(spline(TAIL, 110)), 0.08)
    end, before = (np.array(TAIL[i][:3]) for i in (-1, -2))
    ahead = (end - before) / np.linalg.norm(end - before)
    across = np.cross(ahead, (0.0, 0.0, 1.0))
    tip, back = end + 0.17 * ahead, end - 0.03 * ahead
    for side in (1.0, -1.0):
        field.union([triangle(tip, end, back + side * 0.085 * across, 0.014)], 0.02)


def head(field: Field) -> None:
    """Skull, open jaws with teeth and tongue, brows, eyes, frill and two pairs of horns."""
    to_world = _head_frame()

    def bone(rows: Rows, samples: int = 12) -> list[Part]:
        moved = [(*to_world(r[:3]), r[3] * HEAD_SIZE) for r in rows]
        return tube(spline(moved, samples))

    field.union(bone([(-0.06, 0.0, 0, 0.10), (0.05, 0.02, 0, 0.105), (0.14, 0.02, 0, 0.085)]), 0.05)
    for side in (1, -1):
        z = float(side)
        upper: Rows = [(0.10, 0.0, 0.030 * z, 0.062), (0.24, 0.0, 0.024 * z, 0.052)]
        field.union(bone([*upper, (0.36, -0.012, 0.018 * z, 0.042)]), 0.035)
        lower: Rows = [(0.02, -0.05, 0.045 * z, 0.055), (0.15, -0.135, 0.036 * z, 0.036)]
        field.union(bone([*lower, (0.30, -0.185, 0.014 * z, 0.026)]), 0.03)
        field.union(bone([(0.33, 0.03, 0.026 * z, 0.022), (0.345, 0.036, 0.03 * z, 0.018)]), 0.02)
        field.union(bone([(0.02, 0.10, 0.065 * z, 0.03), (0.17, 0.065, 0.05 * z, 0.02)]), 0.02)
        field.union(bone([(0.10, 0.045, 0.074 * z, 0.031), (0.12, 0.046, 0.074 * z, 0.029)]), 0.008)
        horn: Rows = [(-0.03, 0.08, 0.055 * z, 0.040), (-0.14, 0.17, 0.085 * z, 0.031)]
        horn += [(-0.27, 0.21, 0.115 * z, 0.021), (-0.40, 0.195, 0.125 * z, 0.010)]
        field.union(bone(horn, 20), 0.025)
        spur: Rows = [(-0.04, 0.0, 0.09 * z, 0.030), (-0.15, 0.015, 0.145 * z, 0.019)]
        field.union(bone([*spur, (-0.25, 0.05, 0.165 * z, 0.009)]), 0.02)
        _teeth(field, bone, z)
    field.union(
        bone([(0.10, -0.06, 0, 0.03), (0.22, -0.10, 0, 0.02), (0.32, -0.09, 0, 0.013)]), 0.02
    )
    field.union(bone([(0.02, -0.07, 0, 0.06), (0.14, -0.11, 0, 0.03)]), 0.03)


def _teeth(field: Field, bone: Callable[[Rows, int], list[Part]], z: float) -> None:
    for x, size in ((0.365, 0.050), (0.31, 0.034), (0.26, 0.030), (0.21, 0.026)):
        width = z * (0.052 - 0.055 * (x - 0.21))
        tooth: Rows = [(x, -0.03, width, 0.013), (x, -0.04 - size, width, 0.005)]
        field.union(bone(tooth, 2), 0.006)
    for x, size in ((0.285, 0.045), (0.235, 0.030), (0.185, 0.026)):
        y = -0.135 - 0.36 * (x - 0.15)
        width = z * (0.046 - 0.14 * (x - 0.15))
        tooth = [(x, y, width, 0.012), (x - 0.012, y + 0.012 + size, width, 0.005)]
        field.union(bone(tooth, 2), 0.006)


def _head_frame() -> Callable[[tuple[float, float, float]], tuple[float, float, float]]:
    """From the head's own axes (snout along +x) to the body's."""
    c, s = np.cos(HEAD_DOWN), np.sin(HEAD_DOWN)

    def to_world(p: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = p
        moved = HEAD_AT + np.array([c * x - s * y, s * x + c * y, z]) * HEAD_SIZE
        return float(moved[0]), float(moved[1]), float(moved[2])

    return to_world


def ridges(field: Field) -> None:
    """A row of backward-leaning plates from the back of the head to the end of the tail."""
    for here in _frames(spline(TRUNK, 240)[20:236], 17):
        field.union([_plate(here, 0.105 - 0.03 * here.at, -1.0, 0.012)], 0.015)
    for here in _frames(spline(TAIL, 320)[40:310], 26):
        field.union([_plate(here, 0.105 - 0.077 * here.at, 1.0, 0.009)], 0.012)


def scutes(field: Field) -> None:
    """Bands across throat and belly, each a little over the one behind."""
    for here in _frames(spline(TRUNK, 240)[30:232], 34):
        across = np.cross(here.along, here.up) * here.radius * 0.52
        middle = here.point - here.up * here.radius * 0.80
        band = 0.26 * here.radius
        field.union([capsule(middle - across, middle + across, band, band)], 0.012)


@dataclass(frozen=True)
class _Frame:
    """A place on a curve: how far along (0 .. 1), where, how thick, and two axes."""

    at: float
    point: Curve
    radius: float
    along: Curve
    up: Curve


def _plate(here: _Frame, height: float, lean: float, thickness: float) -> Part:
    """A triangle that stands on the back, leaning along the curve."""
    size = height * (0.9 + 0.2 * (int(here.at * 1000) % 2))
    root = here.point + here.up * here.radius * 0.86
    foot = here.along * size * 0.5
    return triangle(root - foot, root + foot, root + here.up * size + 1.4 * lean * foot, thickness)


def _frames(curve: Curve, count: int) -> Iterator[_Frame]:
    """``count`` frames along a curve; the back is up at its start and stays what it is."""
    up = np.array([0.0, 1.0, 0.0])
    wanted = [int((i + 0.5) / count * (len(curve) - 1)) for i in range(count)]
    for i in range(1, len(curve) - 1):
        along = (curve[i + 1] - curve[i - 1])[:3]
        along /= np.linalg.norm(along)
        up = up - along * (up @ along)
        up /= np.linalg.norm(up)
        if i in wanted:
            yield _Frame(i / len(curve), curve[i, :3], float(curve[i, 3]), along, up)

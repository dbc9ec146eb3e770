"""The wings: an arm, four fingers and the skin between them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from field import Field, Part, capsule, triangle

Vector = npt.NDArray[np.float64]
Triple = tuple[float, float, float]

SHOULDER, ELBOW, WRIST = (0.16, 0.74, 0.14), (-0.12, 1.10, 0.40), (0.10, 1.52, 0.62)
FINGERS: tuple[tuple[Triple, Triple], ...] = (
    ((0.02, 1.92, 0.80), (-0.26, 2.10, 0.90)),
    ((-0.30, 1.75, 0.96), (-0.74, 1.76, 1.06)),
    ((-0.36, 1.46, 0.97), (-0.90, 1.25, 0.99)),
    ((-0.30, 1.20, 0.84), (-0.92, 0.70, 0.82)),
)
"""Middle control point and tip of each finger, all starting at the wrist (right wing)."""
ROOT = (-0.44, 0.60, 0.10)
"""Where the last skin meets the flank."""
SKIN = 0.0125
"""Half the thickness of the skin."""


def wings(field: Field) -> None:
    """Both wings; the left one is folded a little further."""
    for side in (1.0, -1.0):
        _wing(field, np.array([1.0, 1.0, side]))


def _wing(field: Field, mirror: Vector) -> None:
    shoulder, elbow, wrist = (np.array(p) * mirror for p in (SHOULDER, ELBOW, WRIST))
    arm = [
        capsule(shoulder, elbow, 0.078, 0.055),
        capsule(elbow, wrist, 0.055, 0.044),
        capsule(wrist, wrist + np.array([0.10, 0.10, 0.02]) * mirror, 0.034, 0.009),
    ]
    field.union(arm, 0.05)
    fingers = [
        _bezier(wrist, np.array(middle) * mirror, np.array(tip) * mirror, 17)
        for middle, tip in FINGERS
    ]
    flank = _bezier(elbow, (elbow + np.array(ROOT) * mirror) / 2, np.array(ROOT) * mirror, 17)
    inner = _bezier(wrist, elbow, np.array(ROOT) * mirror, 17)
    outward = np.array([0.35, 0.1, 0.9]) * mirror
    for one, other in zip(fingers, [*fingers[1:], inner], strict=True):
        field.union(_skin(one, other, -0.10 * outward), 0.012)
    field.union(
        _skin(flank, _bezier(elbow, shoulder, np.array(ROOT) * mirror, 17), 0 * outward), 0.01
    )
    front = _bezier(shoulder, (shoulder + wrist) / 2 - 0.1 * outward, wrist, 17)
    field.union(_skin(front, _bezier(shoulder, elbow, wrist, 17), 0 * outward), 0.012)
    for finger in fingers:
        radii = np.linspace(0.036, 0.014, len(finger))
        bones = [
            capsule(finger[i], finger[i + 1], radii[i], radii[i + 1])
            for i in range(len(finger) - 1)
        ]
        field.union(bones, 0.03)


def _bezier(a: Vector, b: Vector, c: Vector, samples: int) -> Vector:
    t = np.linspace(0.0, 1.0, samples)[:, None]
    return np.asarray((1 - t) ** 2 * a + 2 * t * (1 - t) * b + t**2 * c)


def _skin(one: Vector, other: Vector, billow: Vector, across: int = 6) -> list[Part]:
    """Skin between two curves: bulging along ``billow``, with a hollow outer edge."""
    v = np.linspace(0.0, 1.0, across + 1)[None, :, None]
    arch = 4.0 * v * (1.0 - v)
    length = len(one) - 1
    u = np.linspace(0.0, 1.0, length + 1)[:, None, None] * (1.0 - 0.20 * arch) * length
    i = np.minimum(u.astype(int), length - 1)[..., 0]
    t = u - i[..., None]
    left, right = ((1 - t) * c[i] + t * c[i + 1] for c in (one, other))
    sheet = left * (1 - v) + right * v + billow * arch * (u / length)
    parts = []
    for a, b, c, d in zip(
        *(sheet[s].reshape(-1, 3) for s in (np.s_[:-1, :-1], np.s_[1:, :-1])),
        *(sheet[s].reshape(-1, 3) for s in (np.s_[1:, 1:], np.s_[:-1, 1:])),
        strict=True,
    ):
        parts += [triangle(a, b, c, SKIN), triangle(a, c, d, SKIN)]
    return parts

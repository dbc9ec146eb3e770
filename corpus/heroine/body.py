"""Her shape at rest: round cones blended into a skin, and over it cloth, leather and hair.

Signed distances in metres (negative inside), of points (n, 3); see ``skeleton`` for the axes.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float32]
Point = Sequence[float]

LAYERS = ("cloth", "leather", "hair")
"""What she wears over her skin."""
LOW, HIGH = (-0.56, -0.03, -0.30), (0.56, 1.76, 0.30)


def cone(p: Floats, a: Point, b: Point, radius_a: float, radius_b: float) -> Floats:
    """A segment whose radius runs linearly from one end to the other."""
    start, axis = np.asarray(a, np.float32), np.subtract(b, a).astype(np.float32)
    t = np.clip((p - start) @ axis / max(float(axis @ axis), 1e-12), 0.0, 1.0)
    radius = np.float32(radius_a) + t * np.float32(radius_b - radius_a)
    return np.asarray(np.linalg.norm(p - start - t[:, None] * axis, axis=1) - radius)


def ellipsoid(p: Floats, centre: Point, radii: Point) -> Floats:
    """An ellipsoid with axes along x, y, z; the distance is right near the surface."""
    q = (p - np.asarray(centre, np.float32)) / np.asarray(radii, np.float32)
    near = np.linalg.norm(q, axis=1)
    slope = np.linalg.norm(q / np.asarray(radii, np.float32), axis=1)
    return np.asarray(near * (near - 1.0) / np.maximum(slope, 1e-6))


def blend(parts: Sequence[Floats], width: float) -> Floats:
    """The union of solids with creases filled to about ``width`` (Quilez's polynomial)."""
    result = parts[0]
    for part in parts[1:]:
        share = np.maximum(width - np.abs(result - part), 0.0) / width
        result = np.minimum(result, part) - share * share * (0.25 * width)
    return np.asarray(result, np.float32)


def both(p: Floats) -> Floats:
    """Points on her left, those on her right mirrored: her shape is the same on both sides."""
    return np.stack([np.abs(p[:, 0]), p[:, 1], p[:, 2]], axis=1)


def skin(p: Floats) -> Floats:
    """The body itself."""
    q = both(p)
    trunk = [
        ellipsoid(p, (0.0, 0.965, -0.012), (0.158, 0.115, 0.112)),
        ellipsoid(p, (0.0, 1.10, 0.0), (0.112, 0.14, 0.085)),
        ellipsoid(p, (0.0, 1.27, 0.0), (0.138, 0.145, 0.098)),
        ellipsoid(q, (0.066, 1.265, 0.070), (0.060, 0.062, 0.056)),
        ellipsoid(q, (0.070, 0.945, -0.065), (0.078, 0.088, 0.072)),
        cone(q, (0.02, 1.405, -0.015), (0.150, 1.385, -0.012), 0.048, 0.050),
        cone(p, (0.0, 1.40, -0.018), (0.0, 1.53, 0.0), 0.048, 0.045),
    ]
    arm = [
        cone(q, (0.158, 1.385, -0.01), (0.290, 1.155, -0.02), 0.048, 0.036),
        cone(q, (0.290, 1.155, -0.02), (0.400, 0.945, 0.0), 0.037, 0.024),
        ellipsoid(q, (0.424, 0.893, 0.006), (0.022, 0.046, 0.030)),
        cone(q, (0.432, 0.870, 0.012), (0.452, 0.812, 0.018), 0.017, 0.010),
        cone(q, (0.414, 0.905, 0.026), (0.424, 0.860, 0.048), 0.011, 0.008),
    ]
    leg = [
        cone(q, (0.088, 0.93, 0.0), (0.098, 0.52, 0.012), 0.084, 0.050),
        cone(q, (0.098, 0.50, 0.010), (0.102, 0.32, -0.012), 0.048, 0.047),
        cone(q, (0.102, 0.34, -0.012), (0.104, 0.085, -0.025), 0.047, 0.030),
    ]
    head = [
        ellipsoid(p, (0.0, 1.625, -0.008), (0.076, 0.098, 0.094)),
        ellipsoid(p, (0.0, 1.565, 0.026), (0.054, 0.062, 0.060)),
        cone(p, (0.0, 1.605, 0.086), (0.0, 1.585, 0.100), 0.009, 0.011),
        ellipsoid(p, (0.0, 1.530, 0.062), (0.022, 0.018, 0.020)),
        ellipsoid(p, (0.0, 1.555, 0.082), (0.018, 0.009, 0.010)),
    ]
    body = blend([blend(trunk, 0.06), blend(leg, 0.03), blend(head, 0.022)], 0.035)
    return blend([body, blend(arm, 0.02)], 0.03)


def cloth(p: Floats) -> Floats:
    """A tunic: thick cloth over the trunk, short sleeves, a wide skirt to above the knees."""
    q = both(p)
    y = p[:, 1]
    flare = np.clip((1.0 - y) / 0.42, 0.0, 1.0)
    angle = np.arctan2(p[:, 0], p[:, 2])
    folds = 0.012 * flare * np.cos(9.0 * angle) + 0.006 * flare * np.cos(14.0 * angle + 1.0)
    width, depth = 0.158 + 0.115 * flare, 0.130 + 0.120 * flare
    round_way = np.hypot(p[:, 0] / width, p[:, 2] / depth)
    skirt = (round_way - 1.0) * np.minimum(width, depth) - folds
    skirt = np.maximum(np.abs(skirt + 0.008) - 0.008, np.maximum(0.60 - y, y - 1.02))
    top = blend(
        [
            ellipsoid(p, (0.0, 0.985, -0.012), (0.180, 0.125, 0.136)),
            ellipsoid(p, (0.0, 1.10, 0.0), (0.122, 0.15, 0.096)),
            ellipsoid(p, (0.0, 1.265, 0.0), (0.148, 0.150, 0.108)),
            ellipsoid(q, (0.066, 1.265, 0.070), (0.070, 0.072, 0.064)),
            cone(q, (0.06, 1.375, -0.012), (0.165, 1.365, -0.012), 0.050, 0.056),
            cone(q, (0.158, 1.372, -0.012), (0.232, 1.250, -0.016), 0.060, 0.060),
        ],
        0.05,
    )
    neckline = 1.405 - 0.30 * np.clip(p[:, 2], 0.0, 0.1)
    top = np.maximum(top, y - neckline - 0.4 * np.abs(p[:, 0]))
    return blend([np.asarray(top, np.float32), np.asarray(skirt, np.float32)], 0.03)


def leather(p: Floats) -> Floats:
    """A belt, bracers, and boots to below the knees."""
    q = both(p)
    waist = np.hypot(p[:, 0] / 0.152, (p[:, 2] - 0.002) / 0.124)
    belt = np.maximum((waist - 1.0) * 0.12, np.abs(p[:, 1] - 1.045) - 0.026)
    buckle = ellipsoid(p, (0.0, 1.045, 0.127), (0.034, 0.034, 0.012))
    boot = [
        cone(q, (0.100, 0.40, -0.006), (0.102, 0.28, -0.015), 0.060, 0.060),
        cone(q, (0.102, 0.28, -0.015), (0.104, 0.11, -0.025), 0.060, 0.043),
        cone(q, (0.104, 0.060, -0.040), (0.110, 0.042, 0.080), 0.044, 0.038),
        cone(q, (0.110, 0.040, 0.080), (0.112, 0.034, 0.135), 0.038, 0.030),
    ]
    shaft = np.maximum(blend(boot, 0.03), -p[:, 1])
    cuff = cone(q, (0.099, 0.425, -0.004), (0.100, 0.385, -0.006), 0.063, 0.060)
    bracer = cone(q, (0.320, 1.098, -0.016), (0.388, 0.968, -0.002), 0.041, 0.031)
    worn = np.minimum.reduce([belt, buckle, shaft, cuff, bracer])
    return np.asarray(worn, np.float32)


def hair(p: Floats) -> Floats:
    """Hair drawn back from the face into a braid."""
    cap = ellipsoid(p, (0.0, 1.635, -0.020), (0.088, 0.100, 0.100))
    face = ellipsoid(p, (0.0, 1.560, 0.088), (0.066, 0.088, 0.085))
    cap = np.maximum(cap, -face)
    cap = np.maximum(cap, 1.535 - p[:, 1])
    bun = ellipsoid(p, (0.0, 1.605, -0.118), (0.045, 0.045, 0.040))
    wave = 0.008 * np.sin(70.0 * p[:, 1])
    tail = [
        cone(p, (0.0, 1.585, -0.125), (0.0, 1.43, -0.152), 0.036, 0.038),
        cone(p, (0.0, 1.43, -0.152), (0.0, 1.24, -0.150), 0.038, 0.026),
        cone(p, (0.0, 1.24, -0.150), (0.0, 1.17, -0.145), 0.026, 0.010),
    ]
    return blend([np.asarray(cap, np.float32), bun, blend(tail, 0.02) - wave], 0.018)


def layers(p: Floats) -> Floats:
    """Distances to the skin and to each of ``LAYERS``, (n, 4)."""
    return np.stack([skin(p), cloth(p), leather(p), hair(p)], axis=1)

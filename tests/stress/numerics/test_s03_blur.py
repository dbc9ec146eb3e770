"""S3 and S19: what a filter blurs while the picture pans evenly.

Bilinear weights add ``v (1 - v)`` to the variance of an impulse in each frame and direction, so
after n frames the course's equation 4 holds: n (vx (1 - vx) + vy (1 - vy)) / 2.
"""

from __future__ import annotations

import os

import numpy as np
import pytest
from numpy.typing import NDArray

from shadercache.caching.configuration import FilterKind
from shadercache.gpu.context import Gpu
from tests.configured import configured

from .criteria import Criteria
from .plane import SIZE, plane

pytestmark = pytest.mark.xdist_group("gl")

DEEP = os.environ.get("SHADERCACHE_STRESS") == "deep"
FRAMES = (1, 4, 16)
PANS = [(0.1, 0.0), (0.25, 0.0), (0.5, 0.5)]
if DEEP:
    PANS += [(x, y) for x in (0.05, 0.3, 0.9) for y in (0.2, 0.5, 0.75)]

START = (20, 20)


def impulses(gpu: Gpu, kind: FilterKind, pan: tuple[float, float]) -> list[NDArray[np.float64]]:
    """What is left of an impulse at ``START`` after each number of frames, (h, w)."""
    made = plane(gpu, configured(refresh="none", filter=kind))
    made.draw(0, u_value=(0.0, 0.0, 0.0))
    texels = made.cached().copy()
    texels[START[1], START[0], :3] = 1.0
    made.overwrite(texels)
    found = []
    for frame in range(1, FRAMES[-1] + 1):
        made.draw(frame, u_pan=(frame * pan[0], frame * pan[1]))
        found.append(made.cached()[..., 0].astype(np.float64))
    return [found[count - 1] for count in FRAMES]


def moments(image: NDArray[np.float64]) -> tuple[float, NDArray[np.float64], float]:
    """Sum of an image, its centre (x, y), and its variance, the mean of both directions."""
    at = np.arange(SIZE, dtype=np.float64)
    total = image.sum()
    centre = np.array([image.sum(0) @ at, image.sum(1) @ at]) / total
    x, y = (at - centre[0]) ** 2, (at - centre[1]) ** 2
    return total, centre, float((image.sum(0) @ x + image.sum(1) @ y) / total / 2.0)


@pytest.mark.parametrize("pan", PANS, ids=str)
@pytest.mark.parametrize("kind", ["bilinear", "bilateral"])
def test_bilinear_blur_is_what_theory_says(
    gpu: Gpu, stress: Criteria, kind: FilterKind, pan: tuple[float, float]
) -> None:
    for count, image in zip(FRAMES, impulses(gpu, kind, pan), strict=True):
        total, centre, variance = moments(image)
        expected = count * sum(v % 1.0 * (1.0 - v % 1.0) for v in pan) / 2.0
        assert total == pytest.approx(1.0, abs=1e-4), "nothing is lost or made"
        assert centre == pytest.approx(np.array(START) + count * np.array(pan), abs=2e-3)
        stress.at_most(
            f"variance beside theory after {count} frames", abs(variance / expected - 1.0), 0.05
        )


@pytest.mark.parametrize("kind", ["lanczos2", "mitchell"])
def test_sixteen_texels_keep_more_of_an_impulse(
    gpu: Gpu, stress: Criteria, kind: FilterKind
) -> None:
    """And stay in place, and within the range of what was there."""
    four, sixteen = (impulses(gpu, k, (0.25, 0.25))[-1] for k in ("bilinear", kind))
    _, centre, variance = moments(sixteen)
    least = {"lanczos2": 1.5, "mitchell": 1.05}[kind]
    stress.at_least("peak, of the bilinear one", sixteen.max() / four.max(), least)
    stress.tell("variance, of the bilinear one", variance / moments(four)[2])
    assert sixteen.min() >= 0.0
    assert centre == pytest.approx(np.array(START) + FRAMES[-1] * 0.25, abs=0.25)


def test_nearest_keeps_all_of_it_and_does_not_move(gpu: Gpu) -> None:
    """What moves by less than half a pixel a frame is left behind (docs/why/reuse.md)."""
    image = impulses(gpu, "nearest", (0.25, 0.25))[-1]
    assert image[START[1], START[0]] == image.max() == 1.0


@pytest.mark.parametrize(
    "kind", ["bilinear", "nearest", "bilateral", "lanczos2", "mitchell", "carried"]
)
def test_whole_pixels_are_not_blurred(gpu: Gpu, kind: FilterKind) -> None:
    for count, image in zip(FRAMES, impulses(gpu, kind, (1.0, 0.0)), strict=True):
        assert image[START[1], START[0] + count] == pytest.approx(1.0, abs=1e-4)

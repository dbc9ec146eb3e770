"""S5: a plane seen edge on, a thin fence before it, bodies that pass through one another.

No trails: one frame after anything was hidden no pixel reuses what was stored for something else.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.harness.context import Gpu
from shadercache.harness.scene import Camera, Key, Motion
from shadercache.harness.stage import Stage

from .crowds import Body, Record, ball, crowd, fence, judge, sheet

pytestmark = pytest.mark.xdist_group("numerics")

SIZE = (128, 128)
FRAMES = range(16)
CAMERA = Camera((0.0, 1.0, 4.0), (0.0, 0.6, 0.0), (0.0, 1.0, 0.0), 50.0, 0.05, 60.0)
PLANE = sheet("plane", [(-8.0, 0.0, 8.0), (-8.0, 0.0, -30.0), (8.0, 0.0, -30.0)], 16)


def low_flight() -> list[Key]:
    """A tenth above the plane, looking along it: most of it lies under 3 degrees."""
    return [
        Key(n, (0.05 * n, 0.12, 6.0 - 0.06 * n), (0.05 * n, 0.10, -20.0), (0.0, 1.0, 0.0), 50.0)
        for n in FRAMES
    ]


def bodies(name: str) -> tuple[dict[str, Body], list[Key]]:
    """The bodies of a case, and the camera's path."""
    match name:
        case "grazing":
            return {"plane": Body(PLANE)}, low_flight()
        case "fence":
            bars = fence("fence", 41, 4.0, 1.6, 0.012)  # less than a pixel wide
            slide = Motion((0.0, 1.0, 0.0), 0.0, 0.0, 99, (-0.2, 0.0, 0.8), (0.021, 0.0, 0.0))
            return {"plane": Body(PLANE), "fence": Body(bars, slide)}, []
        case _:
            roll = Motion((1.0, 0.3, 0.2), 7.0, 0.0, 99, (-0.8, 0.1, 0.4), (0.05, 0.0, 0.02))
            spin = Motion((0.0, 1.0, 0.0), -5.0, 0.0, 99, (0.6, 0.2, 0.6), (-0.06, 0.0, 0.0))
            return {
                "plane": Body(PLANE),
                "one": Body(ball("one", 0.55), roll),
                "other": Body(ball("other", 0.5), spin),
            }, []


def record(gpu: Gpu, folder: Path, name: str, cached: str) -> Record:
    """What the look-ups of all frames of a case bring, together."""
    made, keys = bodies(name)
    whole = Record()
    with Stage(gpu, crowd(folder, made, CAMERA, keys), SIZE, "rgba32f") as stage:
        for _, found in judge(stage, FRAMES, cached):
            whole.add(found)
    return whole

"""S5: a plane seen edge on, a thin fence before it, bodies that pass through one another.

No trails: one frame after anything was hidden no pixel reuses what was stored for something else.
``PYTHONPATH=tests python -m tests.stress.numerics.test_s05_grazing_fence_intersecting`` prints the
table of docs/lab/reuse.md.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest

from shadercache.gpu.context import Gpu, open_context
from shadercache.render.render_scene import RenderScene
from shadercache.scene.motion import Camera, Key, Motion

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
    with RenderScene(gpu, crowd(folder, made, CAMERA, keys), SIZE, "rgba32f") as world:
        for _, found in judge(world, FRAMES, cached):
            whole.add(found)
    return whole


@pytest.mark.parametrize("name", ["grazing", "fence", "intersecting"])
def test_nothing_trails(gpu: Gpu, tmp_path: Path, name: str) -> None:
    """Every hit is of the right body, and of the right place on it."""
    found = record(gpu, tmp_path, name, "ids=on")
    assert found.hits > 30_000, found
    assert not found.broken, "\n".join([str(found), *found.broken])


LEAST = {"grazing": 0.4, "fence": 0.8, "intersecting": 0.9}


@pytest.mark.parametrize(("name", "least"), LEAST.items())
def test_what_was_seen_is_mostly_reused(gpu: Gpu, tmp_path: Path, name: str, least: float) -> None:
    """Under 3 degrees a pixel's depth changes by more than epsilon, so half of the plane misses."""
    found = record(gpu, tmp_path, name, "ids=on")
    assert found.hits > least * found.seen, found


def test_without_the_id_test_bodies_that_pass_through_one_another_trail(
    gpu: Gpu, tmp_path: Path
) -> None:
    """Where they cut each other both are equally deep. So the checks above can fail."""
    found = record(gpu, tmp_path, "intersecting", "")
    assert len(found.foreign) > 100
    assert "of another body" in "\n".join(found.broken)


def main() -> None:
    """Print what each option brings."""
    with open_context() as gpu:
        for cached in ("", "ids=on", "filter=bilinear", "ids=on,filter=bilinear"):
            for name in LEAST:
                with tempfile.TemporaryDirectory() as folder:
                    found = record(gpu, Path(folder), name, cached)
                share = found.hits / found.seen
                print(f"{name}, {cached or 'defaults'}: {share:.1%} of what was seen; {found}")


if __name__ == "__main__":
    main()

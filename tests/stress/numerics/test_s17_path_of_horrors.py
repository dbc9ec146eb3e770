"""S17: a camera that cuts, rolls, dives through bodies and goes to 1e6 and back, before bodies that
appear, vanish and jump. Law 5 holds in every frame; what breaks it is listed pixel by pixel.

``PYTHONPATH=tests python -m tests.stress.numerics.test_s17_path_of_horrors --seeds N`` tries more.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np
import pytest

from shadercache.gpu.context import Gpu, open_context
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from tests.configured import variant

from .crowds import Record, bundle_of, crowd, judge
from .horrors import CAMERA, bodies, path

pytestmark = pytest.mark.xdist_group("numerics")

SIZE = (96, 96)
FRAMES = 48
SEEDS = (1, 2, 5)


def record(gpu: Gpu, folder: Path, seed: int, cached: str, frames: int = FRAMES) -> Record:
    """What the look-ups of a path bring, together."""
    keys, _ = path(seed, frames)
    whole = Record()
    scene = crowd(folder, bodies(seed, frames), CAMERA, keys)
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        for _, found in judge(world, range(frames), cached):
            whole.add(found)
    return whole


@pytest.mark.parametrize("seed", SEEDS)
def test_every_hit_is_sound(gpu: Gpu, tmp_path: Path, seed: int) -> None:
    found = record(gpu, tmp_path, seed, "ids=on")
    assert found.hits > 30_000, found
    assert not found.broken, "\n".join([str(found), *found.broken])


def test_the_path_is_horrible() -> None:
    """The seeds have all events between them, and bodies that are not there in every frame."""
    events = {event for seed in SEEDS for event in path(seed, FRAMES)[1]}
    assert {"glide", "roll", "dive", "cut", "far"} <= events
    for seed in SEEDS:
        motions = [body.motion for body in bodies(seed, FRAMES).values()]
        assert sum(len(motion.visible) > 1 for motion in motions) >= 3
        assert sum(bool(motion.jumps) for motion in motions) >= 3


def test_without_the_id_test_it_fails(gpu: Gpu, tmp_path: Path) -> None:
    assert record(gpu, tmp_path, SEEDS[0], "").foreign


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
def test_its_own_cache_stays_sound(gpu: Gpu, tmp_path: Path, algorithm: str) -> None:
    """A run that carries its cache: all is finite, no number is another body's, cuts are exact."""
    keys, _ = path(SEEDS[0], FRAMES, told=True)
    bundle = bundle_of("v_body", "ids=on")
    scene = crowd(tmp_path, bodies(SEEDS[0], FRAMES), CAMERA, keys)
    cuts = scene.view.camera_path.cuts
    assert cuts
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f") as world,
        OriginalRunner(world, bundle) as original,
        variant(world, bundle, algorithm, period=16, block=4) as runner,
    ):
        for frame in range(FRAMES):
            expected = original.image(frame).copy()
            image = runner.image(frame)
            assert np.isfinite(image).all() and np.isfinite(runner.cache()).all(), frame
            away = np.abs(image - expected)
            assert away.max() <= (0.0 if frame in cuts else 1e-3), (frame, float(away.max()))


def main() -> None:
    """Try seeds, and say what was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--frames", type=int, default=120)
    options = parser.parse_args()
    with open_context() as gpu:
        for seed in range(options.seeds):
            for cached in ("", "ids=on"):
                with tempfile.TemporaryDirectory() as folder:
                    found = record(gpu, Path(folder), seed, cached, options.frames)
                print(f"seed {seed}, {cached or 'no ids'}: {found}")
                print("\n".join(found.broken) if cached else "", flush=True)


if __name__ == "__main__":
    main()

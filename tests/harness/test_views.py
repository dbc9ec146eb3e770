"""Several views of one scene take turns, each with a cache of its own."""

from __future__ import annotations

from dataclasses import replace

import pytest

from shadercache.harness.bundle import Bundle
from shadercache.harness.context import Gpu
from shadercache.harness.runner import OriginalRunner, RunOptions, VariantRunner, render_variant
from shadercache.harness.scene import CameraPath, Scene
from shadercache.harness.stage import Stage

pytestmark = pytest.mark.xdist_group("gl")

FRAMES = range(5)
OPTIONS = RunOptions(16, cache_format="rgba32f")


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
def test_views_that_take_turns_draw_what_they_draw_alone(
    gpu: Gpu, scene: Scene, bundle: Bundle, algorithm: str
) -> None:
    other = replace(scene.camera, eye=(1.8, -0.6, 1.9), fov_degrees=50.0)
    path = CameraPath(degrees_per_frame=2.0)
    with Stage(gpu, scene, (96, 64), "rgba32f") as stage, stage.seen_from(other, path) as view:
        alone = [render_variant(item, bundle, algorithm, FRAMES, OPTIONS) for item in (stage, view)]
        with (
            VariantRunner(stage, bundle, algorithm, OPTIONS) as one,
            VariantRunner(view, bundle, algorithm, OPTIONS) as two,
            OriginalRunner(view, bundle) as original,
        ):
            for frame in FRAMES:
                assert one.image(frame).tobytes() == alone[0][frame].tobytes()
                assert two.image(frame).tobytes() == alone[1][frame].tobytes()
            assert two.hit_mask(5).any(), "the stage is still there"
            assert original.image(4).tobytes() != alone[1][4].tobytes(), "values are reused"
        assert alone[0][4].tobytes() != alone[1][4].tobytes()
        programs = stage.programs.used
    with Stage(gpu, scene, (96, 64), "rgba32f") as stage:
        assert programs == stage.programs.used == 0

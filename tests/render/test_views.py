"""Several views of one scene take turns, each with a cache of its own."""

from __future__ import annotations

from dataclasses import replace

import pytest

from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.motion import CameraPath
from tests.configured import render_variant, variant

pytestmark = pytest.mark.xdist_group("gl")

FRAMES = range(5)
OPTIONS = {"period": 16, "form": "rgba32f"}


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
def test_views_that_take_turns_draw_what_they_draw_alone(
    gpu: Gpu, scene: Scene, bundle: Bundle, algorithm: str
) -> None:
    other = replace(scene.view.camera, eye=(1.8, -0.6, 1.9), fov_degrees=50.0)
    path = CameraPath(degrees_per_frame=2.0)
    with (
        RenderScene(gpu, scene, (96, 64), "rgba32f") as world,
        world.seen_from(other, path) as view,
    ):
        alone = [
            render_variant(item, bundle, algorithm, FRAMES, **OPTIONS) for item in (world, view)
        ]
        with (
            variant(world, bundle, algorithm, **OPTIONS) as one,
            variant(view, bundle, algorithm, **OPTIONS) as two,
            OriginalRunner(view, bundle) as original,
        ):
            for frame in FRAMES:
                assert one.image(frame).tobytes() == alone[0][frame].tobytes()
                assert two.image(frame).tobytes() == alone[1][frame].tobytes()
            assert two.hit_mask(5).any(), "the world is still there"
            assert original.image(4).tobytes() != alone[1][4].tobytes(), "values are reused"
        assert alone[0][4].tobytes() != alone[1][4].tobytes()
        programs = world.programs.used
    with RenderScene(gpu, scene, (96, 64), "rgba32f") as world:
        assert programs == world.programs.used == 0

"""S11: a scene a million units from the origin of the world, drawn camera-relative."""

from __future__ import annotations

import numpy as np
import pytest
from laws.ground_truth import body_mesh, body_scene, bundle_of

from shadercache.gpu.context import Gpu
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from tests.altered import altered
from tests.configured import variant

from .criteria import Criteria

pytestmark = pytest.mark.xdist_group("gl")

FAR = (1e6, -1e6, 1e6)


def hit_rate(gpu: Gpu, scene: Scene, frames: int) -> float:
    """Mean share of hits of what is covered."""
    bundle = bundle_of("v_position", "rgba16f")
    with (
        RenderScene(gpu, scene, (128, 128), mesh=body_mesh("trashcan")) as world,
        variant(world, bundle, "2-pass", period=32) as runner,
    ):
        rates = []
        for frame in range(frames):
            if frame:
                mask = runner.hit_mask(frame)
                assert (mask > 0).mean() > 0.1, "there must be something to see"
                rates.append((mask[mask > 0] == runner.bundle.mask_values["hit"]).mean())
            runner.draw(frame)
    return float(np.mean(rates))


def moved(scene: Scene, by: tuple[float, float, float]) -> Scene:
    """The scene with camera and object elsewhere in the world."""

    def shifted(point: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = (a + b for a, b in zip(point, by, strict=True))
        return (x, y, z)

    camera, position = scene.view.camera, scene.common.motion.position
    there = {"eye": shifted(camera.eye), "target": shifted(camera.target)}
    return altered(scene, **there, position=shifted(position))


@pytest.mark.parametrize("degrees", [0.2, 2.0])
def test_hits_do_not_depend_on_the_place(gpu: Gpu, stress: Criteria, degrees: float) -> None:
    """What reaches the shaders is relative to the camera; the harness multiplies matrices in 64
    bits before it rounds them, as engines do."""
    scene = body_scene("trashcan", degrees)
    frames = 60 if stress.deep else 12
    near, far = hit_rate(gpu, scene, frames), hit_rate(gpu, moved(scene, FAR), frames)
    stress.tell("hit rate at the origin", near)
    stress.at_most("difference of hit rates at 1e6 and at the origin", abs(far - near), 0.01)

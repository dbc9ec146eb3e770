"""S15: a light that moves. What depends on it is as old as the period, and no further off.

The dragon rests and the lamp turns, so a cached pixel must be the original's of one of the last
frames, bit for bit, and differ from the original of now by no more than that many steps of it.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from shadercache.caching.settings import with_settings
from shadercache.compiler import emit_original
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.object_inputs import Ramp
from tests.altered import altered
from tests.configured import DEFAULT, configured, rewritten, variant

from .criteria import Criteria
from .subjects import ALGORITHMS

pytestmark = pytest.mark.xdist_group("gl")

LIT = "blinn_phong(marble(v_position), normal, view, polish)"
LAMP = Ramp((0.45, 0.72, 0.53), (-0.006, 0.001, 0.004))


def lit_scene() -> Scene:
    scene = load_scene(data_path("corpus", "dragon"))
    given = scene.common.inputs.constants
    constants = {name: value for name, value in given.items() if name != "u_light"}
    return altered(scene, degrees_per_frame=0.0, constants=constants, animated={"u_light": LAMP})


@pytest.mark.parametrize("settings", ["", "age=on", "refresh=none,age=on"])
@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_an_error_is_that_of_the_period(
    gpu: Gpu, stress: Criteria, algorithm: str, settings: str
) -> None:
    if not stress.deep and (algorithm, settings) not in (("2-pass", ""), ("3-pass", "age=on")):
        pytest.skip("not in the short form")
    period, frames = (8, 40) if stress.deep else (4, 10)
    scene, analysis = analyse_scene(lit_scene(), mapping="surface")
    node = next(item for item in analysis.nodes if item.text == LIT)
    cache = with_settings(DEFAULT, [settings] if settings else [])
    found = rewritten(analysis, node, configured(cache, mode="proof", form="rgba32f"))
    plain = emit_original(analysis, "proof")
    with RenderScene(gpu, scene, (96, 96), "rgba32f") as world:
        truth = render_original(world, [Bundle(plain.manifest, plain.files)], range(frames))
        bundle = Bundle(found.manifest, found.files)
        with variant(world, bundle, algorithm, period=period) as runner:
            images = [runner.image(frame) for frame in range(frames)]
    step = max(np.abs(now - last).max() for last, now in pairwise(truth))
    errors, strange, reused = [], 0, 0
    for frame, image in enumerate(images):
        last = np.stack(truth[max(0, frame - period) : frame + 1])
        strange += int((~(last == image).all(axis=-1).any(axis=0)).sum())
        reused += int((image != truth[frame]).any(axis=-1).sum())
        errors.append(float(np.abs(image - truth[frame]).max()))
    stress.tell("largest change of the original in a frame", float(step))
    stress.none("pixels that no frame of the period had", strange)
    stress.at_most("largest error", max(errors), float(step) * period)
    stress.at_least("pixels from an earlier frame", reused, frames * 100)

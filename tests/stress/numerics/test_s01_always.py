"""S1 and its like by the verifier: laws 2, 3, 4 and 7 for every way to refresh, bit for bit."""

from __future__ import annotations

from contextlib import closing

import numpy as np
import pytest

from shadercache.caching.settings import with_settings
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.scene.description import load_scene
from shadercache.verify.verdict import PERIOD
from shadercache.verify.verifier import Verifier
from tests.configured import DEFAULT

from .criteria import Criteria

pytestmark = pytest.mark.xdist_group("gl")

SETTINGS = (
    *("", "age=on", "refresh=random", "refresh=tiled", "refresh=surface", "refresh=none"),
    *("refresh=tiled,age=on", "refresh=surface,age=on", "refresh=none,age=on", "ids=on,age=on"),
)

SHORT = ("refresh=surface", "refresh=none,age=on", "ids=on,age=on")


PRIMITIVE = """#version 330
in vec2 v_place; out vec4 o;
void main() { o = vec4(v_place, float(gl_PrimitiveID), 1.0); }
"""
PLACE = """#version 330
in vec2 a_place; out vec2 v_place;
void main() { v_place = vec2(0.5); gl_Position = vec4(a_place, 0.0, 1.0); }
"""


def draws_primitive_ids(gpu: Gpu) -> bool:
    """Some drivers draw nothing then: one triangle, number 0."""
    program = gpu.ctx.program(vertex_shader=PLACE, fragment_shader=PRIMITIVE)
    corners = gpu.ctx.buffer(np.array([-1, -1, 3, -1, -1, 3], np.float32).tobytes())
    array = gpu.ctx.vertex_array(program, corners, "a_place")
    target = gpu.ctx.texture((1, 1), 4, dtype="f4")
    framebuffer = gpu.ctx.framebuffer([target])
    framebuffer.use()
    gpu.ctx.enable_only(0)
    array.render()
    drawn = np.frombuffer(target.read(), np.float32).tolist()
    for item in (array, corners, program, framebuffer, target):
        item.release()
    return drawn == [0.5, 0.5, 0.0, 1.0]


@pytest.mark.parametrize("settings", SETTINGS)
def test_always_refreshed_is_the_original(gpu: Gpu, stress: Criteria, settings: str) -> None:
    if not stress.deep and settings not in SHORT:
        pytest.skip("not in the short form")
    if "surface" in settings and not draws_primitive_ids(gpu):
        pytest.skip("the driver draws nothing where a shader reads gl_PrimitiveID")
    cache = with_settings(DEFAULT, [settings] if settings else [])
    scenes = ("dragon", "trashcan") if stress.deep else ("trashcan",)
    checked, broken = 0, []
    oldest: dict[str, float] = {}
    for name in scenes:
        scene, analysis = analyse_scene(load_scene(data_path("corpus", name)))
        nodes = [node for node in analysis.nodes if node.offered]
        few = nodes[:: max(1, len(nodes) // (24 if stress.deep else 1))]
        with closing(Verifier(gpu, (scene, analysis), (64, 64), configuration=cache)) as verifier:
            for node in few:
                verdict = verifier.check(node, plain=False)
                checked += 1
                broken += [f"{name} {node.id} {law}" for law in verdict.broken]
                for way, age in verdict.ages.items():
                    oldest[way] = max(age, oldest.get(way, 0.0))
    for way, age in oldest.items():
        stress.at_most(f"oldest, {way}, frames of {PERIOD}", age, PERIOD)
    stress.tell("nodes", checked)
    stress.demand("laws 2, 3, 4 and 7 that are broken", str(broken[:5]), "none", not broken)

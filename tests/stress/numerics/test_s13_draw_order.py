"""S13: occlusion order, overdraw, surfaces seen from both sides: one image in any draw order."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from shadercache.caching.settings import with_settings
from shadercache.compiler import analyse
from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner, OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.motion import Camera, Motion
from shadercache.source import Source
from tests.altered import altered
from tests.configured import PROOF, rewritten, variant

from .crowds import Body, ball, crowd, fence, sheet

pytestmark = pytest.mark.xdist_group("numerics")

SIZE = (96, 96)
FRAMES = range(7)
ORDERS = 4
CAMERA = Camera((0.4, 1.2, 4.0), (0.0, 0.4, 0.0), (0.0, 1.0, 0.0), 55.0, 0.1, 40.0)

VERTEX = """#version 330
in vec3 a_position;
uniform mat4 u_modelViewProjection;
uniform float u_number;
out vec3 v_position;
out float v_number;
void main() {
    v_position = a_position;
    v_number = u_number;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
"""

FRAGMENT = """#version 330
in vec3 v_position;
in float v_number;
out vec4 o_color;
vec3 rings(vec3 p, float number) {
    return 0.5 + 0.5 * sin(11.0 * p + number * vec3(0.0, 2.0, 4.0) + 3.0 * cos(8.0 * p.zxy));
}
void main() {
    vec3 color = rings(v_position, v_number);
    o_color = vec4(gl_FrontFacing ? color : 1.0 - color.zxy, 1.0);
}
"""


@cache
def proof() -> Bundle:
    """Colours that differ on both sides, and payloads that differ from body to body."""
    analysis = analyse(Source("rings.frag", FRAGMENT), Source("rings.vert", VERTEX))
    node = next(node for node in analysis.nodes if node.text.startswith("rings("))
    options = with_settings(PROOF, ["ids=on"])
    emission = rewritten(analysis, node, options, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def in_order(scene: Scene, order: list[int]) -> Scene:
    return replace(scene, objects=tuple(scene.objects[number] for number in order))


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """Sheets behind sheets, bars, and balls that pass through them; one is not cached."""
    bodies = {f"sheet{n}": Body(*sheets(n)) for n in range(4)}
    bodies["bars"] = Body(fence("bars", 21, 3.0, 1.8, 0.06), turning(-3.0, (0.0, -0.4, 1.0)))
    bodies["ball"] = Body(ball("ball", 0.6), turning(9.0, (0.2, 0.4, 0.3)))
    bodies["other"] = Body(ball("other", 0.5), turning(-5.0, (-0.5, 0.3, 0.9)))
    made = crowd(tmp_path_factory.mktemp("order"), bodies, CAMERA)
    items = [
        altered(item, on=item.name != "other", constants={"u_number": (float(number),)})
        for number, item in enumerate(made.objects)
    ]
    return replace(made, objects=tuple(items))


def sheets(number: int) -> tuple:
    x, z = 0.3 * number - 0.5, 0.35 * number - 0.6
    corners = [(x - 1.0, -0.5, z), (x - 1.0, 1.4, z - 0.2), (x + 1.0, 1.4, z + 0.2)]
    return sheet(f"sheet{number}", corners), turning(4.0 - 2.5 * number, (0.0, 0.0, 0.0))


def turning(degrees: float, position: tuple[float, float, float]) -> Motion:
    return Motion((0.1, 1.0, 0.2), degrees, 0.0, 99, position, (0.01, 0.0, -0.02))


@pytest.fixture(scope="module")
def orders(scene: Scene) -> list[list[int]]:
    pick = random.Random(13)
    numbers = list(range(len(scene.objects)))
    return [numbers, numbers[::-1], *(pick.sample(numbers, len(numbers)) for _ in range(ORDERS))]


@pytest.fixture(scope="module")
def apart(gpu: Gpu, scene: Scene) -> Iterator[list[np.ndarray]]:
    """Pixels of each frame that one fragment alone wins."""
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f") as world,
        CoverageRunner(world, proof()) as runner,
    ):
        ties = [runner.ties(frame) for frame in FRAMES]
    assert np.mean(ties) < 1e-3
    yield [~tie for tie in ties]


def test_much_lies_behind_something(gpu: Gpu, scene: Scene) -> None:
    """Both sides are seen, and the image is drawn over more than twice."""
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f") as world,
        OriginalRunner(world, proof()) as runner,
    ):
        covered = (runner.image(0)[..., 3] > 0).sum()
        drawn = 0
        for drawable in world.drawables:
            alone = replace(scene, objects=(drawable.scene_object,))
            with (
                RenderScene(gpu, alone, SIZE, "rgba32f") as one,
                OriginalRunner(one, proof()) as single,
            ):
                drawn += (single.image(0)[..., 3] > 0).sum()
    assert drawn > 2.0 * covered


@pytest.mark.parametrize("algorithm", ["1-pass", "2-pass", "3-pass"])
def test_the_same_image_in_any_order(
    gpu: Gpu, scene: Scene, orders: list[list[int]], apart: list[np.ndarray], algorithm: str
) -> None:
    first: list[np.ndarray] = []
    for order in orders:
        with (
            RenderScene(gpu, in_order(scene, order), SIZE, "rgba32f") as world,
            variant(world, proof(), algorithm, period=5) as runner,
        ):
            images = [runner.image(frame)[apart[frame]] for frame in FRAMES]
        first = first or images
        same = [a.tobytes() == b.tobytes() for a, b in zip(first, images, strict=True)]
        assert all(same), (order, same)


def test_the_algorithms_agree(gpu: Gpu, scene: Scene, apart: list[np.ndarray]) -> None:
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        runs = []
        for algorithm in ("1-pass", "2-pass", "3-pass"):
            with variant(world, proof(), algorithm, period=5) as runner:
                runs.append([runner.image(frame)[apart[frame]] for frame in FRAMES])
        with OriginalRunner(world, proof()) as runner:
            original = [runner.image(frame)[apart[frame]] for frame in FRAMES]
    for one, two, three in zip(*runs, strict=True):
        assert one.tobytes() == two.tobytes() == three.tobytes()
    assert original[0].tobytes() == runs[0][0].tobytes()
    assert original[-1].tobytes() != runs[0][-1].tobytes(), "values must be reused in motion"

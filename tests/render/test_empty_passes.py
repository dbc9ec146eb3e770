"""Passes with nothing to do are left out, and the image stays the same, bit for bit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.empty_passes import EmptyPasses
from shadercache.render.pass_runners import render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, SceneObject
from shadercache.scene.graphics_state import GraphicsState
from shadercache.scene.motion import REST, Motion
from tests.altered import altered
from tests.configured import PROOF, rewritten, variant

pytestmark = pytest.mark.xdist_group("gl")

SIZE = (96, 64)


@pytest.fixture(scope="module")
def opened(scene_folder: Path) -> tuple[Scene, Analysis]:
    """Two rings by one shader; the second moves from frame 4 to 5."""
    scene, analysis = open_scene(scene_folder / "objects" / "scene.toml")
    still, other = scene.objects[0], scene.objects[1]
    jump = Motion((0.0, 1.0, 0.0), 0.0, 0.0, 9, (0.6, 0.0, 0.4), jumps=((5, (0.5, 0.1, 0.4)),))
    rest = _unchanging(still, replace(jump, jumps=(), position=(0, 0, 0)))
    objects = (rest, _unchanging(other, jump))
    return altered(scene, camera_path=REST, objects=objects), analysis


def _unchanging(item: SceneObject, motion: Motion) -> SceneObject:
    given = item.inputs
    constants = {**given.constants, "u_tint": (1.0, 0.5, 0.2), "u_time": (0.0,)}
    semantics = {name: word for name, word in given.semantics.items() if name != "u_time"}
    return altered(item, motion=motion, constants=constants, semantics=semantics, animated={})


def bundle_of(analysis: Analysis, cached: str) -> Bundle:
    node = analysis.node("main.0-7a71c60a")
    options = with_settings(PROOF, [cached])
    emission = rewritten(analysis, node, options, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


@pytest.mark.parametrize(("algorithm", "skipped"), [("1-pass", 0), ("2-pass", 2), ("3-pass", 2)])
def test_passes_that_compute_rest_while_nothing_moves(
    gpu: Gpu, opened: tuple[Scene, Analysis], algorithm: str, skipped: int
) -> None:
    scene, analysis = opened
    bundle = bundle_of(analysis, "refresh=none,ids=on")
    counts = []
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        original = render_original(world, [bundle], range(10))
        with variant(world, bundle, algorithm) as runner:
            for frame in range(10):
                before = runner.idle.skipped
                image = runner.image(frame)
                counts.append(runner.idle.skipped - before)
                if frame < 5:
                    assert image.tobytes() == original[frame].tobytes()
            runner.reset()
            assert runner.image(9).tobytes() == original[9].tobytes()
            assert runner.idle.skipped == sum(counts), "a reset draws all"
    # Frame 1 is the first like the one before, and counts; 5 moves, 6 counts again.
    assert counts == [0, 0, *[skipped] * 3, 0, 0, *[skipped] * 3]


def test_with_it_or_without_the_images_are_the_same(
    gpu: Gpu, opened: tuple[Scene, Analysis], monkeypatch: pytest.MonkeyPatch
) -> None:
    scene, analysis = opened
    bundle = bundle_of(analysis, "refresh=none,ids=on")
    runs = []
    for skips in (True, False):
        if not skips:
            monkeypatch.setattr(EmptyPasses, "draw", lambda self, turn: turn.draw() or True)
        with (
            RenderScene(gpu, scene, SIZE, "rgba32f") as world,
            variant(world, bundle, "3-pass") as runner,
        ):
            runs.append([runner.image(frame).tobytes() for frame in range(10)])
    assert runs[0] == runs[1]


@pytest.mark.parametrize("jitter", [0, 4])
def test_nothing_is_left_out_where_something_may_be_due(
    gpu: Gpu, opened: tuple[Scene, Analysis], jitter: int
) -> None:
    """With refresh on purpose, and under jitter, which moves the picture."""
    scene, analysis = opened
    bundle = bundle_of(analysis, "refresh=none" if jitter else "refresh=random")
    made = altered(scene, engine=GraphicsState(jitter=jitter))
    with (
        RenderScene(gpu, made, SIZE, "rgba32f") as world,
        variant(world, bundle, "2-pass", period=4) as runner,
    ):
        for frame in range(5):
            runner.draw(frame)
        assert runner.idle.skipped == 0

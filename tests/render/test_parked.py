"""Parked misses on the renderer: several objects, and whatever an application does with depth."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from render.test_graphics_state import ENGINES

from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis
from shadercache.diagnostics import UsageError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render import draw_items
from shadercache.render.bundle import Bundle
from shadercache.render.draw_items import turns
from shadercache.render.pass_runners import CoverageRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.graphics_state import WHOLE, GraphicsState
from tests.altered import altered
from tests.configured import PROOF, bundled, originals, render_variant, variant

pytestmark = pytest.mark.xdist_group("parked")

NODE = "main.0-7a71c60a"
SIZE = (96, 80)
BOTH = ("2-pass", "parked")


@pytest.fixture(scope="module")
def opened(scene_folder: Path) -> tuple[Scene, Analysis]:
    """Several objects by two shaders, some with uniforms of their own, one that is not cached."""
    return open_scene(scene_folder / "objects" / "scene.toml")


def bundle_of(analysis: Analysis, *cached: str) -> Bundle:
    options = with_settings(PROOF, cached)
    return bundled(analysis, analysis.node(NODE), options, BOTH, unprofitable=True)


@pytest.fixture(scope="module")
def proof(opened: tuple[Scene, Analysis]) -> Bundle:
    return bundle_of(opened[1])


@pytest.fixture(scope="module")
def crowd(gpu: Gpu, opened: tuple[Scene, Analysis]) -> Iterator[RenderScene]:
    with RenderScene(gpu, opened[0], SIZE, "rgba32f") as made:
        yield made


def assert_like_two_passes(world: RenderScene, bundle: Bundle) -> None:
    """Always refreshed it is the original, and otherwise what two passes are."""
    frames = range(7)
    original = render_original(world, originals(world.scene, bundle), frames)
    with CoverageRunner(world, *originals(world.scene, bundle)) as cover:
        apart = [~cover.ties(frame) for frame in frames]
    always = render_variant(world, bundle, "parked", frames, period=1)
    two, parked = (render_variant(world, bundle, name, frames, period=5) for name in BOTH)
    for frame, kept in enumerate(apart):
        assert same(always[frame], original[frame], kept), frame
        assert same(parked[frame], two[frame], kept), frame
    assert not same(parked[-1], original[-1], apart[-1]), "values must be reused in motion"


def same(one: np.ndarray, other: np.ndarray, kept: np.ndarray) -> bool:
    return one[kept].tobytes() == other[kept].tobytes()


@pytest.mark.parametrize("engine", ENGINES.values(), ids=ENGINES)
def test_several_objects_in_any_application(
    gpu: Gpu, opened: tuple[Scene, Analysis], proof: Bundle, engine: GraphicsState
) -> None:
    with RenderScene(gpu, altered(opened[0], engine=engine), SIZE, "rgba32f") as world:
        assert_like_two_passes(world, proof)


def test_a_viewport_that_moves(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    scene, analysis = opened
    engine = GraphicsState(viewports=(WHOLE, (0.1, 0.2, 0.6, 0.6)), hold=2)
    with RenderScene(gpu, altered(scene, engine=engine), SIZE, "rgba32f") as world:
        assert_like_two_passes(world, bundle_of(analysis, "viewport"))


def test_the_order_of_objects_changes_nothing(
    gpu: Gpu, opened: tuple[Scene, Analysis], proof: Bundle, crowd: RenderScene
) -> None:
    turned = altered(opened[0], objects=opened[0].objects[::-1])
    with CoverageRunner(crowd, *originals(crowd.scene, proof)) as cover:
        apart = [~cover.ties(frame) for frame in range(6)]
    one = render_variant(crowd, proof, "parked", range(6), period=5)
    with RenderScene(gpu, turned, SIZE, "rgba32f") as world:
        two = render_variant(world, proof, "parked", range(6), period=5)
    for first, second, kept in zip(one, two, apart, strict=True):
        assert same(first, second, kept)


def drawn_in_frame(world: RenderScene, bundle: Bundle) -> list[str]:
    with variant(world, bundle, "parked", period=5) as runner:
        runner.draw(0)
        return [turn.bound.name for turn in turns(runner.roles, runner.inputs, 1)]


def test_passes_over_the_screen_come_last_and_once_for_each_group(
    gpu: Gpu, opened: tuple[Scene, Analysis], proof: Bundle, crowd: RenderScene
) -> None:
    scene = opened[0]
    names = drawn_in_frame(crowd, proof)
    cached = [item for item in scene.objects if item.caching.on]
    found = [names.count(name) for name in ("find", "mark", "fix-up")]
    assert found == [len(cached), 1, len(cached)], "each has uniforms of its own"
    assert names[-found[2] - 1 :] == ["mark", *["fix-up"] * found[2]]
    alike = altered(scene, objects=(scene.objects[0],) * 3)
    with RenderScene(gpu, alike, SIZE, "rgba32f") as world:
        assert drawn_in_frame(world, proof).count("fix-up") == 1


def test_too_many_groups(
    crowd: RenderScene, proof: Bundle, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(draw_items, "MOST_GROUPS", 1)
    with pytest.raises(UsageError, match="SC444"):
        render_variant(crowd, proof, "parked", range(1))

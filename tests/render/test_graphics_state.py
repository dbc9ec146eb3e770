"""Depth functions, polygon offset, clip space and jitter of an application."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.manifest.build import DEPTH_FUNCTIONS
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.graphics_state import ORIGINALS, PLAIN, GraphicsState
from tests.altered import altered
from tests.configured import render_variant, variant

pytestmark = pytest.mark.xdist_group("gl")

SIZE = (96, 64)
EXACT = "rgba32f"
ALGORITHMS = ("1-pass", "2-pass", "3-pass")
ENGINES = {
    "lequal": GraphicsState("lequal"),
    "z-prepass": GraphicsState("equal"),
    "reversed": GraphicsState("greater"),
    "reversed, zero to one": GraphicsState("gequal", clip="zero-to-one"),
    "zero to one": GraphicsState(clip="zero-to-one"),
    "polygon offset": GraphicsState(offset=(1.5, 40.0)),
    "jitter": GraphicsState(jitter=8),
    "jitter, untold": GraphicsState(jitter=8, jitter_told=False),
    "all": GraphicsState("greater", (-1.0, -8.0), "zero-to-one", 5),
}


@pytest.fixture(params=ENGINES.values(), ids=ENGINES.keys())
def engine(request: pytest.FixtureRequest) -> GraphicsState:
    found: GraphicsState = request.param
    return found


def drawn(gpu: Gpu, scene: Scene, bundle: Bundle, engine: GraphicsState) -> list[np.ndarray]:
    with RenderScene(gpu, altered(scene, engine=engine), SIZE, "rgba32f") as world:
        return render_original(world, [bundle], range(3))


def test_the_picture_is_that_of_a_plain_application(
    gpu: Gpu, scene: Scene, bundle: Bundle, engine: GraphicsState
) -> None:
    plain = drawn(gpu, scene, bundle, PLAIN)
    found = drawn(gpu, scene, bundle, engine)
    for one, other in zip(plain, found, strict=True):
        changed = (one != other).any(-1).mean()
        assert changed < (0.9 if engine.jitter else 0.01)
    if engine.jitter:
        assert (plain[0] != found[0]).any()


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_laws_2_and_3(
    gpu: Gpu, scene: Scene, bundle: Bundle, engine: GraphicsState, algorithm: str
) -> None:
    with RenderScene(gpu, altered(scene, engine=engine), SIZE, "rgba32f") as world:
        with CoverageRunner(world, bundle) as cover:
            apart = [~cover.ties(frame) for frame in range(4)]
        original = render_original(world, [bundle], range(4))
        always = {"period": 1, "form": EXACT}
        for frame, image in enumerate(render_variant(world, bundle, algorithm, range(4), **always)):
            assert same(image, original[frame], apart[frame]), frame
        if not engine.jitter:
            resting = {"period": 4, "form": EXACT, "moving": False}
            for image in render_variant(world, bundle, algorithm, range(6), **resting):
                assert same(image, original[0], apart[0])


def test_law_4(gpu: Gpu, scene: Scene, bundle: Bundle, engine: GraphicsState) -> None:
    with RenderScene(gpu, altered(scene, engine=engine), SIZE, "rgba32f") as world:
        options = {"period": 5, "form": EXACT}
        with CoverageRunner(world, bundle) as cover:
            apart = [~cover.ties(frame) for frame in range(5)]
        runs = [render_variant(world, bundle, name, range(5), **options) for name in ALGORITHMS]
        original = render_original(world, [bundle], range(5))
    for one, two, three, kept in zip(*runs, apart, strict=True):
        assert same(one, two, kept) and same(one, three, kept)
    assert not same(runs[0][4], original[4], apart[4]), "values must be reused in motion"


def same(one: np.ndarray, other: np.ndarray, kept: np.ndarray) -> bool:
    return one[kept].tobytes() == other[kept].tobytes()


def test_as_much_is_reused_as_in_a_plain_application(
    gpu: Gpu, scene: Scene, bundle: Bundle, engine: GraphicsState
) -> None:
    # A point lies up to a pixel beside the one that a jittered texel holds (docs/why/reuse.md).
    options = {"period": 65535, "epsilon": 8e-3 if engine.jitter else None}
    rates = []
    for made in (PLAIN, engine):
        with (
            RenderScene(gpu, altered(scene, engine=made), SIZE, "rgba32f") as world,
            variant(world, bundle, "2-pass", **options) as runner,
        ):
            runner.draw(0)
            mask = runner.hit_mask(1)
            rates.append((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum())
    assert rates[1] > rates[0] - (0.15 if engine.jitter else 0.002)


def test_what_is_hidden_stays_hidden(gpu: Gpu, scene: Scene, bundle: Bundle) -> None:
    """Cleared to the wrong depth, or compared the wrong way, a reversed depth shows the inside."""
    plain, reverse = (drawn(gpu, scene, bundle, made) for made in (PLAIN, GraphicsState("greater")))
    wrong = drawn(gpu, scene, bundle, GraphicsState("greater"))
    assert same(reverse[0], wrong[0], np.ones(reverse[0].shape[:2], bool))
    assert (plain[0] != reverse[0]).any(-1).mean() < 0.003
    assert (plain[0][..., 3] > 0).mean() > 0.1


def test_jitter_is_no_motion_where_it_is_told(gpu: Gpu, scene: Scene, bundle: Bundle) -> None:
    """At rest a told cache reuses the very texels; untold it filters them in every frame: blur."""
    still = altered(scene, degrees_per_frame=0.0)
    changes = {}
    for told in (True, False):
        engine = GraphicsState(jitter=8, jitter_told=told)
        with (
            RenderScene(gpu, altered(still, engine=engine), SIZE, "rgba32f") as world,
            variant(world, bundle, "2-pass", period=65535, form=EXACT) as runner,
        ):
            runner.draw(0)
            first = runner.cache().copy()
            hits = runner.hit_mask(1) == bundle.mask_values["hit"]
            for frame in range(1, 9):
                hits &= runner.hit_mask(frame) == bundle.mask_values["hit"]
                runner.draw(frame)
            changes[told] = np.abs(runner.cache()[hits][:, :3] - first[hits][:, :3]).max()
            assert hits.mean() > 0.02
    assert changes[True] == 0.0
    assert changes[False] > 0.01


def test_a_jitter_covers_the_pixel() -> None:
    places = np.array([GraphicsState(jitter=16).shift(frame) for frame in range(32)])
    assert np.array_equal(places[:16], places[16:])
    assert (np.abs(places) <= 0.5).all() and (np.abs(places.mean(axis=0)) < 0.06).all()
    assert len({tuple(place) for place in places[:16]}) == 16
    assert PLAIN.shift(3) == (0.0, 0.0)


def test_it_is_read_from_a_scene_file(scene_folder: Path) -> None:
    text = (scene_folder / "scene.toml").read_text()
    table = (
        '[engine]\ndepth = "gequal"\npolygon_offset = [1.0, 4]\nclip = "zero-to-one"\njitter = 8\n'
    )
    path = scene_folder / "engine.toml"
    path.write_text(text.replace("[nodes]", f"{table}[nodes]", 1))
    assert load_scene(path).view.engine == GraphicsState("gequal", (1.0, 4.0), "zero-to-one", 8)
    for old, new in (("gequal", "always"), ("[1.0, 4]", "3"), ("jitter = 8", "jitter = -1")):
        path.write_text(text.replace("[nodes]", f"{table.replace(old, new)}[nodes]", 1))
        with pytest.raises(InputError, match="SC505"):
            load_scene(path)


def test_the_manifest_says_what_is_done_here(engine: GraphicsState) -> None:
    said = DEPTH_FUNCTIONS[engine.depth]
    words = {"less": "<", "lequal": "<=", "greater": ">", "gequal": ">="}
    assert engine.function("<") == words[said.less]
    assert engine.function("<=") == words[said.lequal]
    assert engine.empty_depth == said.clear
    assert set(ORIGINALS) == set(DEPTH_FUNCTIONS)

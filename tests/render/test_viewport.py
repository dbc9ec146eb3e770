"""A viewport that is a part of the target, and another in some frames (``--cache viewport``)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.settings import with_settings
from shadercache.compiler import Analysis
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene, load_scene
from shadercache.scene.graphics_state import WHOLE, GraphicsState, Rectangle
from tests.altered import altered
from tests.configured import PROOF, originals, render_variant, rewritten, variant

pytestmark = pytest.mark.xdist_group("gl")

SIZE = (128, 96)
ALGORITHMS = ("1-pass", "2-pass", "3-pass")
CORNER: Rectangle = (0.25, 0.125, 0.75, 0.75)
CHANGING: tuple[Rectangle, ...] = (WHOLE, (0.1, 0.2, 0.6, 0.6), (0.0, 0.0, 0.8, 0.8))


@pytest.fixture(scope="module")
def opened(scene_folder: Path) -> tuple[Scene, Analysis]:
    return open_scene(scene_folder / "objects" / "scene.toml")


def bundle_of(analysis: Analysis, *cached: str) -> Bundle:
    node = analysis.node("main.0-7a71c60a")
    options = with_settings(PROOF, ["ids", *cached])
    emission = rewritten(analysis, node, options, unprofitable=True)
    return Bundle(emission.manifest, emission.files)


def within(scene: Scene, engine: GraphicsState) -> Scene:
    return altered(scene, engine=engine)


@pytest.mark.parametrize("filters", ["filter=bilinear", "filter=lanczos2", "filter=nearest"])
@pytest.mark.parametrize("viewports", [(CORNER,), CHANGING], ids=["a corner", "changing"])
def test_the_laws_hold(
    gpu: Gpu, opened: tuple[Scene, Analysis], viewports: tuple[Rectangle, ...], filters: str
) -> None:
    """Always refreshed it is the original; the algorithms agree; at rest nothing drifts."""
    scene, analysis = opened
    bundle = bundle_of(analysis, "viewport", filters)
    with RenderScene(
        gpu,
        within(scene, GraphicsState(viewports=viewports, hold=2)),
        SIZE,
        "rgba32f",
    ) as world:
        original = render_original(world, originals(world.scene, bundle), range(7))
        with CoverageRunner(world, *originals(world.scene, bundle)) as cover:
            apart = [~cover.ties(frame) for frame in range(7)]
        runs = []
        for algorithm in ALGORITHMS:
            always = render_variant(world, bundle, algorithm, range(7), period=1)
            for frame, image in enumerate(always):
                assert same(image, original[frame], apart[frame]), (algorithm, frame)
            resting = render_variant(world, bundle, algorithm, range(4), period=4, moving=False)
            assert all(same(image, original[0], apart[0]) for image in resting), algorithm
            runs.append(render_variant(world, bundle, algorithm, range(7), period=6))
    for frame, images in enumerate(zip(*runs, strict=True)):
        assert same(images[0], images[1], apart[frame]) and same(images[0], images[2], apart[frame])
    assert not same(runs[0][6], original[6], apart[6]), "values must be reused in motion"


def same(one: np.ndarray, other: np.ndarray, kept: np.ndarray) -> bool:
    return one[kept].tobytes() == other[kept].tobytes()


def test_what_is_outside_of_the_viewport_is_left_alone(
    gpu: Gpu, opened: tuple[Scene, Analysis]
) -> None:
    scene, analysis = opened
    bundle = bundle_of(analysis, "viewport")
    with (
        RenderScene(
            gpu,
            within(scene, GraphicsState(viewports=(CORNER,))),
            SIZE,
            "rgba32f",
        ) as world,
        variant(world, bundle, "2-pass") as runner,
    ):
        image = runner.image(0)
        left, bottom, width, height = world.viewport(0)
        assert (left, bottom, width, height) == (32, 12, 96, 72)
        inside = np.zeros(image.shape[:2], bool)
        inside[bottom : bottom + height, left : left + width] = True
        assert image[inside].any() and not image[~inside].any()
        assert (runner.cache()[~inside][:, 3] == bundle.cache.clear[0][3]).all()


def hits(world: RenderScene, bundle: Bundle, frames: int) -> list[float]:
    found = []
    with variant(world, bundle, "2-pass", period=65535) as runner:
        for frame in range(frames):
            mask = runner.hit_mask(frame)
            found.append((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum())
            runner.draw(frame)
    return found[1:]


def test_payloads_are_found_again_in_another_viewport(
    gpu: Gpu, opened: tuple[Scene, Analysis]
) -> None:
    """Nearly as often as in the same; without the option only where the viewport is the target."""
    scene, analysis = opened
    told, untold = bundle_of(analysis, "viewport"), bundle_of(analysis)
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        whole = hits(world, told, 4)
        assert whole == hits(world, untold, 4)
    with RenderScene(
        gpu,
        within(scene, GraphicsState(viewports=CHANGING)),
        SIZE,
        "rgba32f",
    ) as world:
        changing, lost = hits(world, told, 4), hits(world, untold, 4)
    assert min(changing) > 0.75 * min(whole) > 0.3
    assert max(lost) < 0.5 * min(changing)


def test_without_the_option_no_viewport_is_told_of(opened: tuple[Scene, Analysis]) -> None:
    plain, told = bundle_of(opened[1]), bundle_of(opened[1], "viewport")
    assert not any("viewport" in text for text in plain.files.values())
    assert any("viewport" in text for text in told.files.values())
    assert any("covers the whole target" in text for text in plain.manifest.relies_on)
    assert not any("covers the whole target" in text for text in told.manifest.relies_on)


def test_it_is_read_from_a_scene_file(scene_folder: Path) -> None:
    text = (scene_folder / "scene.toml").read_text()
    table = "[engine]\nviewports = [[0, 0, 1, 1], [0.5, 0, 0.5, 1]]\nviewport_frames = 3\n"
    path = scene_folder / "viewports.toml"
    path.write_text(text.replace("[nodes]", f"{table}[nodes]", 1))
    engine = load_scene(path).view.engine
    assert [engine.viewport(frame, (10, 10)) for frame in (0, 2, 3, 6)] == [
        (0, 0, 10, 10), (0, 0, 10, 10), (5, 0, 5, 10), (0, 0, 10, 10),
    ]  # fmt: skip
    path.write_text(text.replace("[nodes]", f"{table.replace('[0.5', '[0.6')}[nodes]", 1))
    with pytest.raises(InputError, match="SC505"):
        load_scene(path)

"""What is drawn for the page of a tuning: plans and payloads of the torus, small."""

from __future__ import annotations

import io
from base64 import b64decode
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.report.tuning_page.plan_shots import (
    SHOWN,
    DrawnPlan,
    PlanShot,
    original_of,
    payloads_of,
    shots_of,
    shown_frame,
)
from shadercache.report.tuning_page.tuning_page import MOST_SHOTS, page_of

from .conftest import Made, made_tuning
from .test_tuning_page_file import data_of

pytestmark = pytest.mark.xdist_group("gl")

FRAME = 9


@pytest.fixture(scope="module")
def torus(scene_folder: Path) -> Linker:
    return Linker(*open_scene(scene_folder / "scene.toml"))


@pytest.fixture(scope="module")
def drawn(torus: Linker, gpu: Gpu) -> Iterator[RenderScene]:
    with RenderScene(gpu, torus.scene, (64, 48)) as world:
        yield world


@pytest.fixture(scope="module")
def tuned(torus: Linker) -> Made:
    return made_tuning(torus, (0.0005, 0.01), values=1)


def assignment(made: Made, number: int, period: int) -> Assignment:
    return made.plan((number, period)).assignment(made.linker.scene)


def shots(world: RenderScene, made: Made, *parts: tuple[int, int]) -> list[PlanShot]:
    plans = [DrawnPlan((part,), assignment(made, *part)) for part in parts]
    return shots_of(world, made.linker, plans, FRAME, lambda what: None)


def test_a_shot_is_the_frame_beside_the_original(
    drawn: RenderScene, tuned: Made, torus: Linker
) -> None:
    with OriginalRunner(drawn, *torus.originals()) as runner:
        runner.draw(FRAME)
        original = drawn.targets.shown()
    always, seldom = shots(drawn, tuned, (0, 1), (0, 4))
    assert np.array_equal(always.shot.original, original)
    assert np.array_equal(original_of(drawn, torus, FRAME), original)
    assert np.array_equal(always.shot.cached, original) and always.error.rmse == 0.0
    assert always.shot.probe.shares["hit"] == 0.0
    assert not np.array_equal(seldom.shot.cached, original)
    assert 0.0 < seldom.error.rmse < 0.1
    assert 0.5 < seldom.shot.probe.shares["hit"] < 0.8
    assert seldom.shot.probe.shares["refresh"] == pytest.approx(0.25, abs=0.05)
    assert (seldom.plan, seldom.frame) == (((0, 4),), FRAME)


def test_what_cannot_be_drawn_is_left_out(drawn: RenderScene, tuned: Made, torus: Linker) -> None:
    unknown = Configuration(nodes=("none.0-000000",))
    other = Assignment(tuple((part.name, unknown) for part in torus.scene.parts))
    plans = [DrawnPlan(((0, 4),), other), DrawnPlan(((1, 4),), assignment(tuned, 1, 4))]
    found = shots_of(drawn, torus, plans, FRAME, lambda what: None)
    assert [one.plan for one in found] == [((1, 4),)]
    values = {(0, 0): other, (0, 1): assignment(tuned, 0, 4)}
    [(value, pixels)] = payloads_of(drawn, torus, values, FRAME, lambda what: None)
    assert value == (0, 1) and pixels[..., :3].max() > 0


def test_something_moves_in_the_frame_that_is_shown(torus: Linker) -> None:
    scene = torus.scene
    assert shown_frame(scene) == SHOWN
    path = replace(scene.view.camera_path, keys=tuple(SimpleNamespace(frame=n) for n in (0, 20)))
    ending = replace(scene, view=replace(scene.view, camera_path=path))
    assert shown_frame(ending) == 19
    recorded = replace(scene, recording=SimpleNamespace(frames=12))
    assert shown_frame(recorded) == 11


def test_a_page_is_drawn_at_the_size_that_was_tuned(
    drawn: RenderScene, tuned: Made, torus: Linker
) -> None:
    plans = [([[number, 4]], assignment(tuned, number, 4)) for number in (1, 0)]
    steps: list[tuple[int, int]] = []
    page = page_of(
        tuned.found | {"size": [32, 24]},
        drawn,
        torus,
        plans * MOST_SHOTS,
        lambda done, total, what: steps.append((done, total)),
    )
    data = data_of(page)
    assert [shot["plan"] for shot in data["shots"]] == [plan for plan, _ in plans] * 6
    assert set(data["payloads"]) == {"0-0"}
    for uri in data["pictures"].values():
        image = Image.open(io.BytesIO(b64decode(uri.partition(",")[2])))
        assert image.size == (32, 24)
    assert steps == [(at, MOST_SHOTS + 1) for at in range(MOST_SHOTS + 1)]
    assert drawn.size == (64, 48)

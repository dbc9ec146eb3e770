"""Law 5: reuse really happens, and only where it is sound.

Each look-up is judged by itself, from a cache that holds the truth of the frame before; then runs
are judged whose cache is their own, where the errors of successive look-ups add up.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest
from laws.ground_truth import (
    TrueFrame,
    body_mesh,
    body_scene,
    bundle_of,
    due,
    true_frames,
)
from laws.look_ups import BLOCK, LawFive, bundle_values

from shadercache.caching.configuration import CacheFormat
from shadercache.gpu.context import Gpu
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER
from tests.configured import configured, variant

pytestmark = pytest.mark.xdist_group("law5")

SIZE = (256, 256)
FRAMES = range(13)

FORMATS: tuple[CacheFormat, ...] = ("rgba32f", "rgba16f")

BODIES = {
    "dragon, 1 degree": ("dragon", 1.0),
    "dragon, 5 degrees": ("dragon", 5.0),
    "dragon, 5 degrees, beyond the frame": ("dragon", 5.0, 2.5),
    "trashcan, 1 degree": ("trashcan", 1.0),
    "trashcan, 5 degrees": ("trashcan", 5.0),
    "dragon and a sphere before it, 5 degrees": ("dragon", 5.0, 1.0, True),
}
"""Arguments of ``on_stage``."""


@contextmanager
def on_stage(
    gpu: Gpu, name: str, degrees: float, zoom: float = 1.0, sphere: bool = False
) -> Iterator[RenderScene]:
    """The body, ready to be drawn."""
    scene, mesh = body_scene(name, degrees, zoom), body_mesh(name, sphere)
    with RenderScene(gpu, scene, SIZE, "rgba32f", mesh) as world:
        yield world


@pytest.fixture(scope="module", params=list(BODIES.values()), ids=list(BODIES))
def body(gpu: Gpu, request: pytest.FixtureRequest) -> Iterator[tuple[RenderScene, list[TrueFrame]]]:
    with on_stage(gpu, *request.param) as world:
        yield world, true_frames(world, FRAMES)


@pytest.mark.parametrize("form", FORMATS)
def test_every_look_up_is_sound(
    body: tuple[RenderScene, list[TrueFrame]], form: CacheFormat
) -> None:
    found = LawFive(*body, form).findings()
    assert found.hits > 2e5, "too few to speak of 1e-5 of them"
    assert not found.broken, "\n".join([str(found), *found.broken])


@pytest.mark.parametrize("period", [4, NEVER])
def test_errors_do_not_add_up(body: tuple[RenderScene, list[TrueFrame]], period: int) -> None:
    """With floats of 32 bits, so that the rounding of payloads does not add up either."""
    found = LawFive(*body, period=period, carried=True).findings()
    assert not found.broken, "\n".join([str(found), *found.broken])


@pytest.mark.parametrize(
    ("form", "period", "carried"), [("rgba16f", 32, False), ("rgba32f", NEVER, True)]
)
def test_what_is_shown_of_carried_samples_is_sound(
    body: tuple[RenderScene, list[TrueFrame]], form: CacheFormat, period: int, carried: bool
) -> None:
    """Each look-up by itself, in texels with offsets in their lowest bits; and runs."""
    cached = configured(filter="carried")
    found = LawFive(*body, form, period, carried, cached=cached).findings()
    assert not found.broken, "\n".join([str(found), *found.broken])


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("period", [3, 4, 32])
def test_at_rest_all_that_is_not_due_hits(gpu: Gpu, form: CacheFormat, period: int) -> None:
    refresh, hit = (bundle_values()[name] for name in ("refresh", "hit"))
    options = {"period": period, "block": BLOCK, "moving": False}
    with (
        on_stage(gpu, "trashcan", 1.0) as world,
        variant(world, bundle_of("v_position", form), "2-pass", **options) as runner,
    ):
        covered = true_frames(world, [0])[0].covered
        runner.draw(0)
        for frame in range(1, 2 * period):
            mask = runner.hit_mask(frame)
            is_due = due(SIZE, frame % period, period, BLOCK)
            expected = np.where(covered, np.where(is_due, refresh, hit), 0)
            assert np.array_equal(mask, expected)
            runner.draw(frame)


def test_every_block_is_due_once_in_a_period() -> None:
    for period in (1, 3, 4, 32):
        turns = np.sum([due(SIZE, clock, period, BLOCK) for clock in range(period)], axis=0)
        assert (turns == 1).all()
    shares = [due((1024, 1024), clock, 32, BLOCK).mean() for clock in range(32)]
    assert max(shares) < 1.1 / 32

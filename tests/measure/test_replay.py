"""A run that is drawn once more for what costs more than a frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from shadercache.gpu.context import Gpu
from shadercache.measure.measure import measure
from shadercache.measure.measurement import Measurement, MeasureOptions
from shadercache.measure.metrics.texel_age import AgeError
from shadercache.measure.result_files import rows, to_json
from shadercache.measure.subjects import OriginalSubject, VariantSubject
from shadercache.render.bundle import Bundle
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from tests.configured import drawn_by

pytestmark = pytest.mark.xdist_group("gl")

OPTIONS = MeasureOptions(frames=12, curves=0, perceptual=True)


@pytest.fixture(scope="module")
def torus_world(gpu: Gpu, scene: Scene) -> Iterator[RenderScene]:
    with RenderScene(gpu, scene, (128, 96)) as made:
        yield made


@pytest.fixture(scope="module")
def steps() -> list[tuple[int, int, str]]:
    return []


def variants(world: RenderScene, bundle: Bundle, *periods: int) -> list[VariantSubject]:
    return [
        VariantSubject("payload", objects[0].configuration, objects)
        for period in periods
        for objects in [drawn_by(world.scene, bundle, "2-pass", period=period)]
    ]


@pytest.fixture(scope="module")
def measurement(
    torus_world: RenderScene, bundle: Bundle, steps: list[tuple[int, int, str]]
) -> Measurement:
    drawn = [
        *variants(torus_world, bundle, 1, 4, 16),
        OriginalSubject("once more", bundle),
    ]
    return measure(torus_world, [bundle], drawn, OPTIONS, lambda *told: steps.append(told))


def test_the_longer_the_period_the_worse(measurement: Measurement) -> None:
    found = [variant.perceived for variant in measurement.nodes[0].variants]
    fresh, short, long = (one for one in found if one is not None)
    assert fresh.frames == short.frames == long.frames == 2
    assert fresh.ssim == 1.0 and fresh.flip == 0.0 and fresh.flicker == 0.0
    assert fresh.pattern is None and fresh.by_age == (AgeError(0, 0, 1.0, 0.0),)
    assert short.ssim is not None and long.ssim is not None and long.ssim < short.ssim < 1.0
    assert short.flip is not None and long.flip is not None and 0.0 < short.flip < long.flip
    assert short.flicker is not None and long.flicker is not None
    assert 0.0 < short.flicker < 0.1 and 0.0 < long.flicker < 0.1
    assert short.pattern is not None and short.pattern > 0.0


def test_errors_by_age(measurement: Measurement) -> None:
    _, short, long = (variant for variant in measurement.nodes[0].variants)
    for variant in (short, long):
        assert variant.perceived is not None
        ages = variant.perceived.by_age
        assert (ages[0].youngest, ages[0].rmse) == (0, 0.0), "computed in this frame"
        assert all(age.rmse > 0.0 for age in ages[1:] if age.share > 0.01)
        assert sum(age.share for age in ages) == pytest.approx(1.0)
        # What was refreshed is as much as the hit masks say, frame for frame.
        assert ages[0].share == pytest.approx(1.0 - variant.hit_rate, abs=0.05)
    assert short.perceived is not None and long.perceived is not None
    # What moves on to another block in time misses its turn, and that is rare.
    assert sum(age.share for age in short.perceived.by_age if age.oldest <= 4) > 0.9
    assert sum(age.share for age in long.perceived.by_age if age.oldest <= 4) < 0.7
    assert long.perceived.by_age[-1].youngest < OPTIONS.frames


def test_the_original_is_as_it_is(measurement: Measurement) -> None:
    [again] = measurement.groups[0].others
    assert again.perceived is not None
    assert (again.perceived.ssim, again.perceived.flip, again.perceived.flicker) == (1.0, 0.0, 0.0)
    assert (again.perceived.pattern, again.perceived.by_age) == (None, ())


def test_files_have_it(measurement: Measurement) -> None:
    [*_, other] = rows(measurement)
    assert (other["label"], other["ssim"], other["flip"], other["flicker"]) == (
        "once more",
        1.0,
        0.0,
        0.0,
    )
    [group] = to_json(measurement, {})["groups"]
    told = group["nodes"][0]["variants"][0]["perceived"]
    assert told["by_age"] == [{"youngest": 0, "oldest": 0, "share": 1.0, "rmse": 0.0}]
    assert group["others"][0]["perceived"]["ssim"] == 1.0


def test_progress_goes_to_its_end(
    measurement: Measurement, steps: list[tuple[int, int, str]]
) -> None:
    done = [step for step, _, _ in steps]
    assert done == sorted(done) and done[-1] == steps[-1][1] == 2 * (OPTIONS.frames + 1)
    assert "looking at images" in {what for _, _, what in steps}


def test_looking_again_changes_nothing_else(torus_world: RenderScene, bundle: Bundle) -> None:
    without, with_it = (
        measure(torus_world, [bundle], variants(torus_world, bundle, 4), options)
        for options in (replace(OPTIONS, perceptual=False), OPTIONS)
    )
    [once], [twice] = (found.nodes[0].variants for found in (without, with_it))
    assert once.perceived is None and twice.perceived is not None
    assert (once.error, once.hit_rates, once.work) == (twice.error, twice.hit_rates, twice.work)
    assert without.notes == with_it.notes == ()

"""How long is measured: fixed frames, then repetitions until the ratios are known."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain, repeat

import numpy as np
import pytest

from shadercache.gpu.context import Gpu
from shadercache.measure import measure as measuring
from shadercache.measure.measure import measure
from shadercache.measure.measurement import Measurement, MeasureOptions
from shadercache.measure.statistics import (
    FEWEST,
    LOOK_EVERY,
    Ratio,
    StopRule,
    paired_ratio,
    widest,
)
from shadercache.measure.subjects import Subject, VariantSubject
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import GeometryRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from tests.configured import drawn_by

NARROW, WIDE = Ratio(2.0, 1.96, 2.04, 2.0), Ratio(0.5, 0.45, 0.55, 0.5)
OPTIONS = MeasureOptions(frames=6, probe_every=2, curves=0)
EVER = 1e9


def test_the_widest_interval_decides() -> None:
    assert widest([NARROW]) == pytest.approx(0.02)
    assert widest([NARROW, WIDE]) == pytest.approx(0.1)


def test_a_rule_is_met_or_its_time_is_up() -> None:
    rule = StopRule(0.03, 8.0)
    assert rule.is_met(0.03) and not rule.is_met(0.031)
    assert rule.is_over(8.0) and not rule.is_over(7.9)


@pytest.mark.parametrize(
    ("frames", "first"), [(2, 1), (8, 4), (16, 8), (20, 12), (40, 32), (41, 32), (64, 32)]
)
def test_short_runs_compare_at_their_end(frames: int, first: int) -> None:
    assert MeasureOptions(frames).first_compared == first


@pytest.mark.parametrize(
    ("frames", "seen"), [(2, [1]), (8, [4, 5, 6, 7]), (16, [8, 11, 14]), (64, [32, 41, 50, 59])]
)
def test_a_few_images_are_looked_at_of_both_parities(frames: int, seen: list[int]) -> None:
    options = MeasureOptions(frames)
    assert [frame for frame in range(frames) if options.is_perceived(frame)] == seen


def test_looking_often_costs_the_interval_little() -> None:
    """Frames that spread by 10 %, each run ended at the first look that was narrow enough."""
    held = 0
    for seed in range(80):
        ratios = 2.0 * np.exp(np.random.default_rng(seed).normal(0.0, 0.1, 400))
        for frames in range(16, 400, LOOK_EVERY):
            found = paired_ratio(ratios[:frames].tolist(), [1.0] * frames)
            if StopRule().is_met(widest([found])):
                break
        held += found.low <= 2.0 <= found.high
    assert 0.88 * 80 <= held <= 80


class Settling:
    """A clock that draws, and tells of a machine that is noisy at first."""

    name = "settling"

    def __init__(self, noisy: int) -> None:
        self._told = chain((1.0 + 0.37 * (i * i % 7) for i in range(noisy)), repeat(1.0))

    def time(self, draw: Callable[[], None]) -> float:
        draw()
        return next(self._told)


class Noted:
    """What notes the frames it is asked for."""

    label = "noted"

    def __init__(self, bundle: Bundle) -> None:
        self.bundle, self.frames = bundle, list[int]()

    def prepare(self, world: RenderScene) -> None:
        self.runner = GeometryRunner(world, self.bundle)

    def draw(self, frame: int) -> None:
        self.frames.append(frame)
        self.runner.draw(frame)

    def release(self) -> None:
        self.runner.release()


@pytest.fixture(scope="module")
def torus_world(gpu: Gpu, scene: Scene) -> Iterator[RenderScene]:
    with RenderScene(gpu, scene, (32, 24)) as made:
        yield made


def run(world: RenderScene, bundle: Bundle, stop: StopRule | None, *others: Subject) -> Measurement:
    objects = drawn_by(world.scene, bundle, "2-pass", period=4)
    variant = VariantSubject("payload", objects[0].configuration, objects)
    return measure(world, [bundle], [variant, *others], replace(OPTIONS, stop=stop))


@pytest.fixture
def settling(monkeypatch: pytest.MonkeyPatch) -> None:
    # Geometry, original and two subjects a frame, and the parts: some frames of noise.
    monkeypatch.setattr(measuring, "pick_clock", lambda _: Settling(60))


@pytest.mark.usefixtures("settling")
@pytest.mark.xdist_group("gl")
def test_frames_are_repeated_until_the_ratio_is_known(
    torus_world: RenderScene, bundle: Bundle
) -> None:
    noted, rule = Noted(bundle), StopRule(0.01, EVER)
    [group] = run(torus_world, bundle, rule, noted).groups
    reached, [other] = group.reached, group.others
    assert reached.half_width <= 0.01 and not reached.capped
    # Two draws to warm up, then the run over and over, from a reset on.
    drawn = noted.frames[2:]
    assert drawn == [step % OPTIONS.frames for step in range(len(drawn))]
    assert (len(drawn) - OPTIONS.frames) % LOOK_EVERY == 0 < len(drawn) - OPTIONS.frames
    timed = sum(frame > 0 for frame in drawn)
    assert reached.frames == timed == len(other.timing.samples) == len(group.original.samples)
    # A look earlier one of the two was not known well enough.
    [variant] = group.nodes[0].variants
    earlier = sum(frame > 0 for frame in drawn[:-LOOK_EVERY])
    assert earlier > FEWEST
    known = [
        paired_ratio(group.original.samples[:earlier], found.timing.samples[:earlier])
        for found in (variant, other)
    ]
    assert widest(known) > 0.01


@pytest.mark.usefixtures("settling")
@pytest.mark.xdist_group("gl")
def test_no_time_leaves_the_fixed_frames(torus_world: RenderScene, bundle: Bundle) -> None:
    reached = run(torus_world, bundle, StopRule(0.0001, 0.0)).groups[0].reached
    assert reached.capped and reached.frames == OPTIONS.frames - 1
    assert reached.half_width > 0.0001
    assert not run(torus_world, bundle, None).groups[0].reached.capped


@pytest.mark.usefixtures("settling")
@pytest.mark.xdist_group("gl")
def test_repeating_changes_times_alone(torus_world: RenderScene, bundle: Bundle) -> None:
    once = run(torus_world, bundle, None).nodes[0].variants[0]
    often = run(torus_world, bundle, StopRule(0.01, EVER)).nodes[0].variants[0]
    assert len(often.timing.samples) > len(once.timing.samples)
    assert (often.error, often.frame_rmse) == (once.error, once.frame_rmse)
    assert (often.hit_rates, often.work) == (once.hit_rates, once.work)

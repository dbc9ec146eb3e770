"""S7: after a reset a frame is the original's; and a cut that was not told is noticed."""

from __future__ import annotations

import dataclasses
from functools import partial

import numpy as np
import pytest

from shadercache.caching.configuration import Configuration
from shadercache.gpu.clock import pick_clock
from shadercache.gpu.context import Gpu
from shadercache.render.cut_detector import REASONS, ResetReason
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.motion import CameraPath, Key
from tests.altered import altered
from tests.configured import configured, variant

from .criteria import Criteria
from .subjects import ALGORITHMS, Subject, changed, programs, subject

pytestmark = pytest.mark.xdist_group("gl")

MOST_COST = 1.1
"""Of the original's time, for the frame after a reset."""


def disturbed(runner: VariantRunner, made: Subject, reason: ResetReason) -> int:
    """Let happen what the reason names; the frame that is drawn next."""
    drawable = made.world.drawables[0]
    camera = drawable.scene.view.camera
    match reason:
        case "cut":
            return 137
        case "projection change":
            wider = 1.4 * camera.fov_degrees
            drawable.scene = altered(drawable.scene, fov_degrees=wider)
            return 7
        case "lost context":
            shape = runner.cache().shape
            runner.restore(np.full(shape, np.nan, np.float32), 3)
            return 4
    return 4


LOST: tuple[ResetReason, ...] = ("cut", "projection change", "lost context")
OPTIONS = {"plain": Configuration(), "age": configured(age=True)}


@pytest.mark.parametrize("reason", LOST)
@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
def test_the_frame_after_a_reset_is_the_original(
    gpu: Gpu, stress: Criteria, algorithm: str, reason: ResetReason, options: Configuration
) -> None:
    with subject(gpu, "trashcan", cache=options) as made:
        with variant(made.world, made.bundle, algorithm, period=32) as runner:
            for frame in range(4):
                runner.draw(frame)
            frame = disturbed(runner, made, reason)
            runner.reset(reason)
            assert set(runner.work(frame)) == set(runner.pass_names)
            image = runner.image(frame)
            assert runner.resets[-1] == reason
            assert not runner.cuts.suspicions
        wrong = changed(image, made.original(frame)) & made.untied(frame)
        stress.none(f"pixels that are not the original's after a {reason}", int(wrong.sum()))


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_what_is_new_begins_with_a_reset(gpu: Gpu, stress: Criteria, algorithm: str) -> None:
    """First frame, resize, shader reload: other textures, or those that another variant left."""
    scene, bundle, plain = programs("trashcan")
    _, reloaded, _ = programs("trashcan", which=0)
    wrong = 0
    for size in ((96, 96), (70, 130)):
        with RenderScene(gpu, scene, size, "rgba32f") as world:
            made = Subject(world, bundle, plain)
            for variants in (bundle, reloaded):
                with variant(world, variants, algorithm, period=32) as runner:
                    image = runner.image(5)
                    runner.draw(6)
                    assert runner.resets == ["first frame"]
                wrong += int((changed(image, made.original(5)) & made.untied(5)).sum())
    stress.none("pixels that are not the original's after first frame, resize, reload", wrong)


def test_resets_draw_only_passes_that_compute(gpu: Gpu) -> None:
    with subject(gpu, "trashcan") as made:
        for algorithm, idle in (("2-pass", "hit"), ("3-pass", "reuse")):
            with variant(made.world, made.bundle, algorithm, period=32) as runner:
                runner.draw(0)
                assert runner.work(1)[idle] > 0
                runner.reset("cut")
                work = runner.work(1)
                assert work[idle] == 0
                assert all(count > 0 for name, count in work.items() if name != idle)


@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
@pytest.mark.parametrize("algorithm", ["1-pass", "3-pass"])
def test_the_pass_of_two_that_computes_stands_for_a_reset(
    gpu: Gpu, algorithm: str, options: Configuration
) -> None:
    """Image and cache are those of the algorithm's own reset, and of the frame that follows."""
    seen: list[list[np.ndarray[tuple[int, ...], np.dtype[np.float32]]]] = []
    with subject(gpu, "trashcan", cache=options) as made:
        for short in (False, True):
            how = {"period": 32, "short_reset": short}
            with variant(made.world, made.bundle, algorithm, **how) as runner:
                images = []
                for frame in (3, 4):
                    images += [runner.image(frame).copy(), runner.cache().copy()]
                seen.append(images)
        free = made.untied(3) & made.untied(4)
    for own, other in zip(*seen, strict=True):
        assert not (changed(own, other) & free).any()


def test_a_short_reset_draws_one_program(gpu: Gpu) -> None:
    with subject(gpu, "trashcan") as made:
        for algorithm in ALGORITHMS:
            how = {"period": 32, "short_reset": True}
            with variant(made.world, made.bundle, algorithm, **how) as runner:
                drawn = [bound.name for role in runner.roles for bound in role.due if bound]
                assert drawn == ["miss"]


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
def test_what_a_reset_costs(gpu: Gpu, stress: Criteria, scene: str, algorithm: str) -> None:
    """The frame after a reset against the original, drawn in turns as `run` and `bench` draw it.
    Small pictures tell nothing."""
    size, frames = ((512, 512), 60) if stress.deep else ((128, 128), 8)
    found, bundle, plain = programs(scene, mode="plain")
    clock = pick_clock(gpu)
    ratios = []
    with (
        RenderScene(gpu, found, size) as world,
        variant(world, bundle, algorithm, period=32, short_reset=True) as runner,
        OriginalRunner(world, plain) as original,
    ):
        for frame in range(frames):
            base = clock.time(partial(original.draw, frame))
            runner.reset("cut")
            ratios.append(clock.time(partial(runner.draw, frame)) / base)
    median = float(np.median(ratios[2:]))
    what = "time of the frame after a reset, of the original's"
    if stress.deep:
        stress.at_most(what, median, MOST_COST)
    else:
        stress.tell(what, median)
    assert len(runner.resets) == frames + 1


@pytest.mark.parametrize("degrees", [1.0, 5.0])
def test_a_cut_that_was_not_told_is_noticed(gpu: Gpu, stress: Criteria, degrees: float) -> None:
    with subject(gpu, "trashcan") as made:
        (drawable,) = made.world.drawables
        drawable.scene_object = altered(drawable.scene_object, degrees_per_frame=degrees)
        jump = round(160.0 / degrees)
        with variant(made.world, made.bundle, "2-pass", period=32) as runner:
            hits = runner.bundle.mask_values["hit"]
            for frame in [*range(12), *range(jump, jump + 12)]:
                if frame not in (0,):
                    mask = runner.hit_mask(frame)
                    runner.note_hits(frame, float((mask == hits).sum() / max(1, (mask > 0).sum())))
                runner.draw(frame)
            seen = runner.cuts.suspicions
    stress.demand(
        "frames that look like cuts",
        str([s.frame for s in seen]),
        str([jump]),
        [suspicion.frame for suspicion in seen] == [jump],
    )
    assert "reset()" in str(seen[0])


def test_every_reason_is_one(gpu: Gpu) -> None:
    assert len(REASONS) == 6
    with (
        subject(gpu, "trashcan", (32, 32)) as made,
        variant(made.world, made.bundle, "2-pass") as runner,
    ):
        for reason in REASONS:
            runner.reset(reason)
        assert runner.resets[1:] == list(REASONS)


def test_a_cut_that_the_scene_tells_is_no_suspicion(gpu: Gpu) -> None:
    with subject(gpu, "trashcan", (48, 48)) as made:
        scene = made.world.scene
        camera = scene.view.camera
        there = Key(4, (5.0, 2.0, 0.1), camera.target, camera.up, camera.fov_degrees, cut=True)
        here = Key(0, camera.eye, camera.target, camera.up, camera.fov_degrees)
        path = CameraPath(keys=(here, dataclasses.replace(here, frame=3), there))
        made.world.scene = made.world.drawables[0].scene = altered(scene, camera_path=path)
        with variant(made.world, made.bundle, "2-pass", period=32) as runner:
            hits = runner.bundle.mask_values["hit"]
            for frame in range(7):
                mask = runner.hit_mask(frame)
                if frame:
                    runner.note_hits(frame, float((mask == hits).sum() / max(1, (mask > 0).sum())))
                runner.draw(frame)
            assert runner.resets == ["first frame", "cut"]
            assert not runner.cuts.suspicions

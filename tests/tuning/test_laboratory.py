"""What a laboratory draws is what it says."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from shadercache.caching.configuration import Assignment, Configuration, Filter
from shadercache.diagnostics import DiagnosticError
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import NEVER
from shadercache.scene.description import load_scene
from shadercache.tuning.groups import assignment_of, groups_of
from shadercache.tuning.laboratory import Laboratory, Run
from shadercache.tuning.values import pool_of

ALBEDO = "main.16-7891657a"
FRAMES = Run(7, (3, 4, 5, 6))


@pytest.fixture(scope="module")
def linker() -> Linker:
    scene = load_scene(Path(data_path("corpus", "dragon", "scene.toml"))).small
    return Linker(*analyse_scene(scene))


@pytest.fixture(scope="module")
def laboratory(gpu: Gpu, linker: Linker) -> Iterator[Laboratory]:
    with RenderScene(gpu, linker.scene, (96, 64)) as world, Laboratory(world, linker) as made:
        yield made


def chosen(linker: Linker, period: int, **changes: object) -> Assignment:
    base = replace(Configuration((ALBEDO,)), **changes)  # type: ignore[arg-type]
    return linker.assign(base.with_refresh(period))


def test_what_is_always_refreshed_has_no_error_and_no_hits(
    laboratory: Laboratory, linker: Linker
) -> None:
    [drawn] = laboratory.draw([chosen(linker, 1)], replace(FRAMES, hits=True))
    assert max(drawn.errors) < 2e-3  # half floats, rounded to eight bits
    assert drawn.hit_rates == (0.0,) * 4


def test_errors_grow_with_age_and_hits_are_counted_of_the_first(
    laboratory: Laboratory, linker: Linker
) -> None:
    run = Run(12, (1, 4, 11), hits=True)
    never, often = laboratory.draw([chosen(linker, NEVER), chosen(linker, 2)], run)
    assert never.errors[0] < never.errors[1] < never.errors[2]
    assert often.errors[2] < never.errors[2]
    assert min(never.hit_rates) > 0.6 and often.hit_rates == ()
    assert never.worst == max(never.errors) and never.share > 0.0


def test_the_small_picture_is_another(laboratory: Laboratory, linker: Linker) -> None:
    [full] = laboratory.draw([chosen(linker, NEVER)], FRAMES)
    [small] = laboratory.draw([chosen(linker, NEVER)], replace(FRAMES, small=True))
    assert full.errors != small.errors
    assert laboratory.draw([chosen(linker, NEVER)], FRAMES)[0].errors == full.errors


def test_other_frames_and_speeds_are_drawn(laboratory: Laboratory, linker: Linker) -> None:
    runs = (FRAMES, replace(FRAMES, start=40), replace(FRAMES, step=3))
    here, there, faster = (laboratory.draw([chosen(linker, 32)], run)[0].errors for run in runs)
    assert here != there
    assert max(faster) > max(here)


@pytest.mark.parametrize("metric", ["psnr", "flip", "flicker"])
def test_other_metrics_see_the_same_order(
    laboratory: Laboratory, linker: Linker, metric: str
) -> None:
    run = replace(FRAMES, metric=metric)  # type: ignore[arg-type]
    often, never = laboratory.draw([chosen(linker, 1), chosen(linker, NEVER)], run)
    # The first frame that is compared has none before it.
    assert len(often.errors) == (3 if metric == "flicker" else 4)
    assert max(often.errors) < max(never.errors)


def test_what_cannot_be_drawn_is_told(laboratory: Laboratory, linker: Linker) -> None:
    with pytest.raises(DiagnosticError, match="SC026"):
        carried = {"filter": Filter("carried"), "algorithm": "3-pass"}
        laboratory.draw([chosen(linker, 4, **carried)], FRAMES)


def test_no_other_algorithm_is_drawn_in_place_of_one(gpu: Gpu) -> None:
    """An object with a shader of its own would be drawn by another, and its time taken for this."""
    whole = Linker(*analyse_scene(load_scene(Path(data_path("corpus", "colonnade"))).small))
    group = groups_of(whole)[1]
    value = pool_of(group, whole.scene).values[0]
    carried = Configuration(value.ids, "3-pass", filter=Filter("carried"))
    assignment = assignment_of(whole.scene, {group: carried})
    with (
        RenderScene(gpu, whole.scene, (32, 32)) as world,
        Laboratory(world, whole) as made,
        pytest.raises(DiagnosticError, match="SC026"),
    ):
        made.draw([assignment], FRAMES)

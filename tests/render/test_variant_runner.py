"""The runner keeps the laws on a hand-written emission."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import moderngl
import numpy as np
import pytest

from shadercache.gpu.context import Gpu
from shadercache.gpu.programs import MOST_IDLE
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner, PassRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.source import Source
from tests.configured import render_variant, variant

pytestmark = pytest.mark.xdist_group("gl")

ALGORITHMS = ("1-pass", "2-pass", "3-pass")
EXACT = "rgba32f"


def same_bits(one: np.ndarray, other: np.ndarray) -> bool:
    return one.tobytes() == other.tobytes()


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_a_period_of_one_is_the_original(
    world: RenderScene, bundle: Bundle, algorithm: str
) -> None:
    options = {"period": 1, "form": EXACT}
    original = render_original(world, [bundle], range(4))
    variant = render_variant(world, bundle, algorithm, range(4), **options)
    assert all(map(same_bits, original, variant))
    assert not same_bits(original[0], original[1]), "the scene must move"


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_at_rest_nothing_drifts(world: RenderScene, bundle: Bundle, algorithm: str) -> None:
    options = {"period": 8, "form": EXACT, "moving": False}
    original = render_original(world, [bundle], range(12), moving=False)
    variant = render_variant(world, bundle, algorithm, range(12), **options)
    assert all(map(same_bits, original, variant))


def test_the_algorithms_agree(world: RenderScene, bundle: Bundle) -> None:
    options = {"period": 6, "form": EXACT}
    runs = [render_variant(world, bundle, name, range(7), **options) for name in ALGORITHMS]
    original = render_original(world, [bundle], range(7))
    for first, second, third in zip(*runs, strict=True):
        assert same_bits(first, second)
        assert same_bits(first, third)
    assert not same_bits(runs[0][6], original[6]), "values must be reused in motion"


def test_programs_that_differ_in_the_heading_are_one(world: RenderScene, bundle: Bundle) -> None:
    spec = bundle.original
    version, rest = spec.fragment.text.split("\n", 1)

    def program(comment: str) -> object:
        text = f"{version}\n{comment}\n// drawn\n{rest}"
        made = world.programs.acquire(spec.vertex, Source(spec.fragment.name, text))
        world.programs.release(made)
        return made

    first = program("// shadercache: 1-pass, node main.3-0123abcd")
    assert program("// shadercache: 2-pass.hit, node main.4-0123abce") is first
    # A backslash would carry the comment on to the next line.
    assert program("// shadercache: 1-pass, node main.3-0123abcd \\") is not first


def test_half_floats_stay_near(world: RenderScene, bundle: Bundle) -> None:
    original = render_original(world, [bundle], range(6))
    covered = original[5][..., 3] > 0
    for name in ALGORITHMS:
        found = render_variant(world, bundle, name, range(6), period=6)
        exact = render_variant(world, bundle, name, range(6), period=6, form=EXACT)
        assert not same_bits(found[5], exact[5])
        # A rounded depth turns the odd hit into a miss, so a single pixel may be farther off.
        assert np.sqrt(np.square(found[5] - exact[5])[covered].mean()) < 1e-3


def test_without_motion_hits_are_what_is_not_due(world: RenderScene, bundle: Bundle) -> None:
    options = {"period": 4, "form": EXACT, "moving": False}
    values = bundle.mask_values
    refreshed = np.zeros(world.size[::-1], int)
    with variant(world, bundle, "2-pass", **options) as runner:
        runner.draw(0)
        for frame in range(1, 5):
            mask = runner.hit_mask(frame)
            assert set(np.unique(mask)) <= {0, values["hit"], values["refresh"]}
            refreshed += mask == values["refresh"]
            runner.draw(frame)
    assert (refreshed[mask > 0] == 1).all(), "every pixel is refreshed once in a period"
    assert (refreshed[mask == 0] == 0).all()


def test_in_motion_most_are_hits(world: RenderScene, bundle: Bundle) -> None:
    with (
        variant(world, bundle, "2-pass", period=64) as runner,
        CoverageRunner(world, bundle) as coverage,
    ):
        for frame in range(3):
            runner.draw(frame)
        mask = runner.hit_mask(3)
        covered = coverage.coverage(3)
    assert ((mask > 0) == covered).all()
    assert 0.7 < (mask == bundle.mask_values["hit"]).sum() / covered.sum() < 0.99


def test_a_reset_forgets_everything(world: RenderScene, bundle: Bundle) -> None:
    options = {"period": 64, "form": EXACT}
    original = render_original(world, [bundle], [5])[0]
    with variant(world, bundle, "3-pass", **options) as runner:
        for frame in range(5):
            runner.draw(frame)
        runner.reset()
        assert (runner.hit_mask(5) != bundle.mask_values["hit"]).all()
        assert runner.work(5)["reuse"] == 0
        assert same_bits(runner.image(5), original)


def test_looking_ahead_changes_nothing(world: RenderScene, bundle: Bundle) -> None:
    plain = render_variant(world, bundle, "2-pass", range(5), period=5)
    with variant(world, bundle, "2-pass", period=5) as runner:
        for frame in range(5):
            runner.hit_mask(frame)
            runner.work(frame)
            assert same_bits(runner.image(frame), plain[frame])


def test_twins_hold_the_last_frames_values(world: RenderScene, bundle: Bundle) -> None:
    """With the twin fed from the current frame, moving surfaces are looked up in wrong places."""
    vertex = bundle.files["reprojected.vert"].replace(
        "sc_previous_u_modelViewProjection * vec4", "u_modelViewProjection * vec4"
    )
    broken = Bundle(bundle.manifest, {**bundle.files, "reprojected.vert": vertex})
    options = {"period": 64, "form": EXACT}
    original = render_original(world, [bundle], range(6))[5]
    good = render_variant(world, bundle, "1-pass", range(6), **options)[5]
    bad = render_variant(world, broken, "1-pass", range(6), **options)[5]
    assert np.square(bad - original).mean() > 4 * np.square(good - original).mean()


def test_work_counts_fragments(world: RenderScene, bundle: Bundle) -> None:
    masks, work = {}, {}
    for name in ALGORITHMS:
        with variant(world, bundle, name, period=8) as runner:
            runner.draw(0)
            masks[name] = runner.hit_mask(1)
            work[name] = runner.work(1)
    assert (masks["1-pass"] == masks["2-pass"]).all()
    assert (masks["1-pass"] == masks["3-pass"]).all()
    covered = int((masks["1-pass"] > 0).sum())
    hits = int((masks["1-pass"] == bundle.mask_values["hit"]).sum())
    assert work["2-pass"]["hit"] == work["3-pass"]["reuse"] >= hits
    assert work["2-pass"]["miss"] == work["3-pass"]["payload"] >= covered - hits
    assert covered <= work["3-pass"]["shade"] <= work["1-pass"]["all"]


def test_a_run_can_be_taken_up_from_a_cache(world: RenderScene, bundle: Bundle) -> None:
    options = {"period": 8, "form": EXACT}
    with variant(world, bundle, "2-pass", **options) as runner:
        for frame in range(3):
            runner.draw(frame)
        cache = runner.cache()
        image = runner.image(3)
        after = runner.cache()
    with variant(world, bundle, "3-pass", **options) as runner:
        runner.restore(cache, 2)
        assert same_bits(runner.image(3), image)
        assert same_bits(runner.cache(), after)


def test_no_depth_ties_on_a_torus(world: RenderScene, bundle: Bundle) -> None:
    with CoverageRunner(world, bundle) as runner:
        assert runner.coverage(0).mean() > 0.2
        assert not runner.ties(0).any()


def test_programs_are_shared_and_given_back(world: RenderScene, bundle: Bundle) -> None:
    assert world.programs.used == 0
    with (
        variant(world, bundle, "2-pass") as first,
        variant(world, bundle, "2-pass") as second,
    ):
        assert world.programs.used == 2, "equal programs are shared"
        first.draw(0)
        second.draw(0)
    second.release()
    assert world.programs.used == 0


def test_unused_programs_are_kept_up_to_a_limit(world: RenderScene, bundle: Bundle) -> None:
    original = bundle.original
    for number in range(MOST_IDLE + 5):
        fragment = Source("f", f"{original.fragment.text}\n// {number}\n")
        with PassRunner(world, replace(original, fragment=fragment)) as runner:
            runner.draw(0)
    assert world.programs.idle == MOST_IDLE
    assert world.programs.used == 0


def test_nothing_stays_on_the_gpu(
    gpu: Gpu, scene: Scene, bundle: Bundle, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[Any] = []

    def recorded(make: Callable[..., Any]) -> Callable[..., Any]:
        def remember(*args: Any, **more: Any) -> Any:
            made.append(make(*args, **more))
            return made[-1]

        return remember

    kinds = ("texture", "buffer", "framebuffer", "program", "vertex_array", "depth_renderbuffer")
    for kind in kinds:
        make = getattr(moderngl.Context, kind)
        monkeypatch.setattr(moderngl.Context, kind, recorded(make))
    with (
        RenderScene(gpu, scene, (16, 16)) as world,
        CoverageRunner(world, bundle) as coverage,
    ):
        coverage.ties(0)
        for name in ALGORITHMS:
            with variant(world, bundle, name) as runner:
                runner.draw(0)
                runner.hit_mask(1)
                runner.work(1)
                runner.draw(1)
    assert {type(item).__name__ for item in made} == {
        "Texture", "Buffer", "Framebuffer", "Program", "VertexArray", "Renderbuffer"
    }  # fmt: skip
    assert [item for item in made if not isinstance(item.mglo, moderngl.InvalidObject)] == []

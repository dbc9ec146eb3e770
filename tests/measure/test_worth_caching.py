"""Objects with shaders of their own are weighed: where caching gains nothing the original draws."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import pytest

from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure import measure as measuring
from shadercache.measure.measure import measure
from shadercache.measure.measurement import Measurement, MeasureOptions
from shadercache.measure.result_files import to_json
from shadercache.measure.subjects import VariantSubject, subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner
from shadercache.scene.description import load_scene
from tests.configured import configured
from tests.told_clock import ToldClock

pytestmark = pytest.mark.xdist_group("gl")

SIZE = (32, 32)
OPTIONS = MeasureOptions(frames=4)


Opened = tuple[Linker, VariantSubject]


@pytest.fixture(scope="module")
def heroine() -> Opened:
    """The scene's shader; the ground has one of its own, cached too; the sky's is not cached."""
    scene, analysis = analyse_scene(load_scene(data_path("corpus", "heroine")))
    linker = Linker(scene, analysis)
    node = analysis.nodes_of(scene.nodes["surface"])
    chosen = replace(configured(ids=True), nodes=tuple(item.id for item in node))
    [subject] = subjects_of(linker, "surface", [chosen])
    return linker, subject


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[Sequence[float]], None]]:
    def tell(seconds: Sequence[float]) -> None:
        monkeypatch.setattr(measuring, "pick_clock", lambda _: ToldClock(*seconds))

    yield tell


def measured(gpu: Gpu, opened: Opened, options: MeasureOptions) -> Measurement:
    linker, subject = opened
    with RenderScene(gpu, linker.scene, SIZE) as world:
        return measure(world, linker.originals(), [subject], options)


# Weighing takes turns: first without caching the object, then with it.
@pytest.mark.parametrize(("seconds", "uncached"), [((3.0, 2.0), 1), ((2.0, 3.0), 2), ((2.0,), 2)])
def test_an_object_that_gains_nothing_is_drawn_by_its_original(
    gpu: Gpu,
    heroine: Opened,
    clock: Callable[[Sequence[float]], None],
    seconds: Sequence[float],
    uncached: int,
) -> None:
    clock(seconds)
    found = measured(gpu, heroine, OPTIONS)
    [gain] = found.gains
    assert (gain.shader, gain.objects, gain.algorithm) == ("ground.frag", ("ground",), "2-pass")
    assert gain.ratio.median == seconds[0] / seconds[-1]
    assert gain.pays == (uncached == 1)
    [told] = to_json(found, {})["gains"]
    assert (told["shader"], told["ratio"]["median"]) == ("ground.frag", gain.ratio.median)
    assert found.groups[0].skipped is not None
    assert found.groups[0].skipped.uncached == uncached
    [assigned] = found.assignments.values()
    assert sum(chosen is None for _, chosen in assigned.objects) == uncached


def test_nothing_is_weighed_unasked(
    gpu: Gpu, heroine: Opened, clock: Callable[[Sequence[float]], None]
) -> None:
    clock((2.0, 3.0))
    found = measured(gpu, heroine, MeasureOptions(frames=4, weigh=False))
    assert found.gains == ()
    assert found.groups[0].skipped is not None
    assert found.groups[0].skipped.uncached == 1


def test_what_is_left_out_stores_nothing(gpu: Gpu, heroine: Opened) -> None:
    linker, subject = heroine
    with RenderScene(gpu, linker.scene, SIZE) as world:
        kept = []
        for drawn in (subject, subject.with_originals(world, ["ground"])):
            with VariantRunner(world, *drawn.objects) as runner:
                runner.draw(0)
                runner.draw(1)
                kept.append(int((runner.cache()[..., 3] != 0.0).sum()))
    everything, heroine_alone = kept
    assert 0 < heroine_alone < everything

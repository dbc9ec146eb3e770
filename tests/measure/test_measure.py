"""A whole measurement, its result files, its pictures."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from shadercache.caching.algorithms import USUAL
from shadercache.diagnostics import InputError, UsageError
from shadercache.gpu.clock import QueryClock, WallClock, pick_clock
from shadercache.gpu.context import Gpu
from shadercache.measure.measure import measure
from shadercache.measure.measurement import Measurement, MeasureOptions
from shadercache.measure.result_files import (
    environment,
    read_json,
    rows,
    to_csv,
    to_json,
    write_json,
)
from shadercache.measure.shown import picture
from shadercache.measure.subjects import (
    UNKNOWN,
    OriginalSubject,
    PayloadFacts,
    VariantSubject,
)
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import GeometryRunner
from shadercache.render.render_scene import RenderScene
from shadercache.report.contact_sheet import SheetRow, contact_sheet
from shadercache.report.images import (
    LEGEND,
    difference_picture,
    hit_picture,
    write_png,
)
from shadercache.report.plots import plot_error, plot_time
from shadercache.scene.description import Scene
from tests.configured import drawn_by

pytestmark = pytest.mark.xdist_group("gl")

FACTS = {
    "payload": PayloadFacts(static_ratio=0.4),
    "again": PayloadFacts(equal=3, static_ratio=0.5),
    "third": PayloadFacts(static_ratio=0.6),
}
OPTIONS = MeasureOptions(frames=8, error_from=4, probe_every=2, group=4, picture_frame=7)


def subjects(
    world: RenderScene,
    bundle: Bundle,
    label: str,
    algorithms: Sequence[str] = USUAL,
    periods: Sequence[int] = (4,),
) -> list[VariantSubject]:
    """What draws the torus by hand-written programs."""
    return [
        VariantSubject(label, objects[0].configuration, objects, facts=FACTS.get(label, UNKNOWN))
        for period in periods
        for name in algorithms
        for objects in [drawn_by(world.scene, bundle, name, period=period)]
    ]


class Peer:
    """What is no variant and knows nothing of caches, such as another technique."""

    def __init__(self, label: str, bundle: Bundle) -> None:
        self.label, self.bundle = label, bundle
        self.told: list[str | int] = []

    def prepare(self, world: RenderScene) -> None:
        self.told.append("prepare")
        self.runner = GeometryRunner(world, self.bundle)

    def draw(self, frame: int) -> None:
        self.told.append(frame)
        self.runner.draw(frame)

    def release(self) -> None:
        self.told.append("release")
        self.runner.release()


@pytest.fixture(scope="module")
def torus_world(gpu: Gpu, scene: Scene) -> Iterator[RenderScene]:
    with RenderScene(gpu, scene, (128, 96)) as made:
        yield made


@pytest.fixture(scope="module")
def steps() -> list[tuple[int, int, str]]:
    return []


@pytest.fixture(scope="module")
def measurement(
    torus_world: RenderScene, bundle: Bundle, steps: list[tuple[int, int, str]]
) -> Measurement:
    every = subjects(torus_world, bundle, "payload")
    every += subjects(torus_world, bundle, "again", ["2-pass"])
    every += subjects(torus_world, bundle, "third", ["1-pass", "2-pass"])
    return measure(torus_world, [bundle], every, OPTIONS, lambda *told: steps.append(told))


def test_every_node_and_variant_is_measured(measurement: Measurement) -> None:
    found = {
        node.label: [v.configuration.algorithm for v in node.variants] for node in measurement.nodes
    }
    assert found == {
        "payload": ["1-pass", "2-pass", "3-pass"],
        "again": ["2-pass"],
        "third": ["1-pass", "2-pass"],
    }
    assert [len(group.nodes) for group in measurement.groups] == [2, 1]
    assert [node.equal for node in measurement.nodes] == [1, 3, 1]
    assert 0.2 < measurement.covered < 0.7


def test_the_numbers_of_a_variant(measurement: Measurement) -> None:
    for group in measurement.groups:
        assert len(group.original.samples) == OPTIONS.frames - 1
        for node in group.nodes:
            assert node.ratio is not None and node.payload is not None and node.hit is not None
            assert len(node.hit.samples) == 4
            assert len(node.payload.samples) == OPTIONS.frames - OPTIONS.first_compared
            for variant in node.variants:
                assert len(variant.timing.samples) == OPTIONS.frames - 1
                assert variant.timing.minimum > 0
                assert variant.speedup.low <= variant.speedup.median <= variant.speedup.high
                assert 0.5 < variant.hit_rate < 0.8
                assert sum(variant.outcomes.values()) == pytest.approx(1.0)
                assert 0 < variant.error.rmse < 0.02
                assert len(variant.frame_rmse) == OPTIONS.frames - OPTIONS.error_from
                assert variant.floor is not None and variant.efficiency is not None
                assert min(variant.work.values()) > 0


def test_progress_goes_from_start_to_end(
    measurement: Measurement, steps: list[tuple[int, int, str]]
) -> None:
    done = [step for step, _, _ in steps]
    assert done == sorted(done)
    assert steps[0][0] == 0 and steps[-1][0] == steps[-1][1] == 2 * (OPTIONS.frames + 1)


def test_nothing_to_measure(torus_world: RenderScene, bundle: Bundle) -> None:
    with pytest.raises(UsageError, match="SC027"):
        measure(torus_world, [bundle], [], OPTIONS)
    with pytest.raises(UsageError, match="SC026"):
        unknown = subjects(torus_world, bundle, "x", ["4-pass"])
        measure(torus_world, [bundle], unknown, OPTIONS)


def test_periods_originals_and_peers_take_turns_in_one_run(
    torus_world: RenderScene, bundle: Bundle
) -> None:
    """Two periods, the original once more and something foreign: one group, one result."""
    peer = Peer("peer", bundle)
    drawn = [
        *subjects(torus_world, bundle, "payload", ["2-pass"], periods=(2, 8)),
        OriginalSubject("once more", bundle),
        peer,
    ]
    options = MeasureOptions(frames=8, error_from=4, group=4)
    found = measure(torus_world, [bundle], drawn, options)
    [group] = found.groups
    [node] = group.nodes
    assert [v.configuration.refresh.period for v in node.variants] == [2, 8]
    assert [found.name(v.configuration) for v in node.variants] == ["2-pass n2 k4", "2-pass n8 k4"]
    assert node.variants[0].hit_rate < node.variants[1].hit_rate
    assert [(curve.period, curve.block) for curve in node.curves] == [(2, 4), (8, 4)]
    again, foreign = group.others
    assert group.reached.frames == 7 and not group.reached.capped
    assert (again.label, foreign.label) == ("once more", "peer")
    assert again.error.rmse == 0.0 < foreign.error.rmse
    assert peer.told == ["prepare", 0, 0, *range(8), "release"]
    told = [(row["label"], row["period"], row["node"] is None) for row in rows(found)]
    assert told == [
        ("payload", 2, False),
        ("payload", 8, False),
        ("once more", None, True),
        ("peer", None, True),
    ]
    assert len({row["configuration"] for row in rows(found)}) == 3
    assert all(row["rmse"] is not None and row["ssim"] is None for row in rows(found))


def test_the_clock_fits_the_renderer(gpu: Gpu, measurement: Measurement) -> None:
    assert isinstance(pick_clock(gpu), WallClock if gpu.is_software else QueryClock)
    assert measurement.clock == pick_clock(gpu).name
    assert QueryClock(gpu.ctx).time(lambda: None) >= 0.0


def test_json_holds_everything(gpu: Gpu, measurement: Measurement, tmp_path: Path) -> None:
    data = to_json(measurement, environment(gpu))
    write_json(tmp_path / "new" / "r.json", data)
    back = read_json(tmp_path / "new" / "r.json")
    assert back == json.loads(json.dumps(data))
    assert back["environment"]["gl"]["renderer"] == gpu.renderer
    assert back["rank_correlation"] == measurement.rank_correlation
    assert [group["reached"]["frames"] for group in back["groups"]] == [7, 7]
    first = back["groups"][0]["nodes"][0]["variants"][0]
    assert len(first["timing"]["samples"]) == OPTIONS.frames - 1
    assert [item.name for item in (tmp_path / "new").iterdir()] == ["r.json"]


def test_csv_has_a_row_for_each_variant(measurement: Measurement) -> None:
    lines = to_csv(measurement).splitlines()
    assert lines[0].startswith("label,node,algorithm,period,block,configuration,p_over_t,")
    assert "rmse,p99,maximum,psnr_db,ssim,flip,flicker,pattern" in lines[0]
    assert lines[0].endswith("floor_ms,efficiency,bytes_per_pixel")
    assert len(lines) == 1 + 6 == 1 + len(rows(measurement))
    assert {row["period"] for row in rows(measurement)} == {4}
    assert {row["p_over_t_static"] for row in rows(measurement)} == {0.4, 0.5, 0.6}
    assert all(row["tail"] >= 1.0 for row in rows(measurement))


def test_results_that_cannot_be_read_or_written(tmp_path: Path) -> None:
    (tmp_path / "r.json").write_text("{}")
    with pytest.raises(InputError, match="SC023"):
        read_json(tmp_path / "r.json")
    with pytest.raises(InputError, match="SC023"):
        read_json(tmp_path / "none.json")
    with pytest.raises(UsageError, match="SC025"):
        write_json(tmp_path / "r.json" / "x.json", {})


def test_pictures(measurement: Measurement, bundle: Bundle, tmp_path: Path) -> None:
    assert len(measurement.shots) == 6
    shot = measurement.shots[1]
    original, cached = picture(shot.original), picture(shot.cached)
    outcomes = hit_picture(shot.probe.mask, shot.probe.values)
    assert original.shape == cached.shape == outcomes.shape == (96, 128, 3)
    colors = {tuple(color) for color in outcomes.reshape(-1, 3).tolist()}
    assert {LEGEND["hit"][0], LEGEND["refresh"][0], (0, 0, 0)} <= colors
    assert difference_picture(original, original).max() == 0
    assert difference_picture(original, cached).max() > 0
    write_png(tmp_path / "a.png", original)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "a.png")), original)


def test_pictures_stand_upright() -> None:
    pixels = np.zeros((2, 1, 4), np.float32)
    pixels[1, 0] = (2.0, np.nan, 0.5, 1.0)  # the upper row in OpenGL's order
    assert picture(pixels)[0, 0].tolist() == [255, 0, 128]
    mask = np.array([[0], [1]], np.uint8)
    assert tuple(hit_picture(mask, {"hit": 1})[0, 0]) == LEGEND["hit"][0]


def test_the_contact_sheet(measurement: Measurement) -> None:
    sheet_rows = [SheetRow(shot, shot.label, "numbers") for shot in measurement.shots[:2]]
    long = [SheetRow(measurement.shots[0], "word " * 500, "numbers")]
    margin = contact_sheet("Title", long, cell=400)[:, -20:]
    assert (margin == margin[0, 0]).all(), "a long heading ends before the margin"
    one = contact_sheet("Title", sheet_rows[:1], cell=100)
    two = contact_sheet("Title", sheet_rows, cell=100)
    assert two.shape[0] > one.shape[0] + 75 and two.shape[1] == one.shape[1] > 400


def test_plots_are_pictures(measurement: Measurement) -> None:
    for png in (plot_time(measurement), plot_error(measurement)):
        with Image.open(io.BytesIO(png)) as image:
            assert image.size == (1200, 750)

"""One run with everything in it, and the command."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from bench.peers.__main__ import main, outcome_table
from bench.peers.comparison import CACHE, PEERS, Setting, compare, turns
from bench.peers.outcomes import SceneOutcome
from bench.peers.scene_programs import ScenePrograms, color_node
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.measure.measurement import MeasureOptions
from shadercache.scene.description import Demo, load_scene
from tests.bench.peers.small_scene import ring

pytestmark = pytest.mark.xdist_group("gl")


def test_two_frames_are_timed_as_one() -> None:
    assert turns([9.0, 1.0, 2.0, 3.0, 4.0]) == [3.0, 7.0]
    assert turns([1.0, 2.0, 3.0, 4.0]) == [3.0, 7.0]


@pytest.mark.parametrize("frames", [12, 32, 64, 65, 100])
def test_of_what_does_half_its_work_in_a_frame_both_are_looked_at(frames: int) -> None:
    options = MeasureOptions(frames)
    seen = [frame for frame in range(frames) if options.is_perceived(frame)]
    assert 2 <= len(seen) <= 4
    assert {frame % 2 for frame in seen} == {0, 1}


def setting_with_nodes(folder: Path) -> Setting:
    """The ring, of which the colour is a node that the scene shows."""
    setting = ring(folder)
    scene = load_scene(folder)
    node = color_node(setting.linker.analysis).id
    shown = replace(scene, nodes={"all": node}, demo=Demo(("all",), period=8, block=4))
    linker = Linker(*analyse_scene(shown, mapping="surface"))
    return Setting(linker, ScenePrograms.of(linker), frames=8)


def test_all_are_measured_in_one_run(gpu: Gpu, tmp_path: Path) -> None:
    setting = setting_with_nodes(tmp_path)
    outcome, _ = compare(gpu, setting, 32, [*PEERS, CACHE])
    kinds = {point.label: point.kind for point in outcome.points}
    cached = [label for label, kind in kinds.items() if kind == "cache"]
    assert cached == [
        f"all, {way}"
        for way in (
            "2-pass",
            "3-pass",
            "parked",
            "2-pass, carried",
            "2-pass, carried, period 32",
            "3-pass, half rate, period 1",
            "3-pass, half rate, period 2",
            "3-pass, half rate",
        )
    ] + [
        f"colour, 3-pass, {rate} rate{period}"
        for rate in ("half", "quarter")
        for period in (", period 1", ", period 2", "")
    ]
    assert [label for label in kinds if label.startswith("cached colour")] == [
        "cached colour, period 2",
        "cached colour, period 4",
        "cached colour, period 8",
    ]
    assert len(kinds) == len(outcome.points) == 24
    for point in outcome.points:
        assert 0.0 < point.low <= point.ratio <= point.high
        assert 0.0 < point.errors["rmse"] < 0.3
        assert {"flip", "flicker"} <= point.errors.keys()
        assert (point.configuration is not None) == (
            point.kind == "cache" or point.label.startswith("cached colour")
        )
    assert {len(of.samples) for of in (*outcome.points, outcome)} == {7}
    by_label = {point.label: point for point in outcome.points}
    # The colour is the node here, so both ways to cache it make the same picture.
    same = by_label["all, 2-pass"], by_label["cached colour, period 8"]
    assert same[0].errors["rmse"] == same[1].errors["rmse"]
    assert outcome_table(outcome).count("\n") == 25
    assert set(outcome.winners) == {"rmse", "flip", "flicker"}


def test_what_is_not_asked_for_is_not_measured(gpu: Gpu, tmp_path: Path) -> None:
    outcome, _ = compare(gpu, setting_with_nodes(tmp_path), 32, ["half-rate"])
    assert [point.label for point in outcome.points] == ["half frame rate, warped"]


def test_a_scene_that_is_not_reprojected_is_refused(tmp_path: Path) -> None:
    ring(tmp_path)
    scene = load_scene(tmp_path)
    with pytest.raises(InputError, match="mapping is screen"):
        ScenePrograms.of(Linker(*analyse_scene(scene, mapping="screen")))


def test_the_command_writes_what_it_found(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "new" / "out"
    arguments = ["dragon", "--size", "32", "--frames", "4", "--only", "half-bilinear,color"]
    assert main([*arguments, "-o", str(out)]) == 0
    found = msgspec.json.decode((out / "dragon.json").read_bytes(), type=SceneOutcome)
    assert found.scene == "dragon" and found.size == (32, 32) and found.frames == 4
    assert {"date", "gl", "cpu"} <= found.environment.keys()
    printed = capsys.readouterr().out
    assert "half resolution, bilinear" in printed and found.winners["rmse"] in printed
    assert (out / "dragon.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--size", "30"], "--size must be a multiple of 4"),
        (["--size", "0"], "--size must be a multiple of 4"),
        (["--frames", "3"], "--frames must be at least 4"),
        (["--only", "half"], "no peer 'half'; there are half-bilinear"),
    ],
)
def test_wrong_usage(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as left:
        main(arguments)
    assert left.value.code == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("name", ["none.toml", "nothing"])
def test_a_scene_that_is_not_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    assert main([name, "-o", str(tmp_path)]) == 1
    error = capsys.readouterr().err
    assert name in error and "Traceback" not in error
    assert not list(tmp_path.iterdir())

"""Choices, the plan made of them, and what makes two trials the same."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from msgspec import structs

from shadercache.diagnostics import InputError, UsageError
from shadercache.sweep.choices import Choices, check_choices, read_choices
from shadercache.sweep.estimate import plan_seconds, trial_seconds
from shadercache.sweep.plan import IN_TURNS, SceneFile, SweepTrial, plan_scene
from shadercache.sweep.which_trials import chosen, on_each, read_conditions

from .test_store import HERE

SMALL = Choices(scenes=("rings",), size=(64, 64), frames=4)


def planned(rings: SceneFile, **changed: object) -> list[SweepTrial]:
    trials = plan_scene(rings, structs.replace(SMALL, **changed))
    return [replace(trial, machine=HERE) for trial in trials]


def keys(trials: list[SweepTrial]) -> list[str]:
    return [trial.key(one) for trial in trials for one in trial.configurations]


def identities(trials: list[SweepTrial]) -> list[str]:
    return [trial.identity(one) for trial in trials for one in trial.configurations]


def test_every_combination_is_planned_once(rings: SceneFile) -> None:
    trials = planned(
        rings,
        periods=(8, 32),
        blocks=(2, 4),
        formats=("rgba16f", "rgba32f"),
        cache=("", "filter=nearest"),
    )
    payloads = {trial.payload.label for trial in trials}
    assert len(payloads) >= 3
    assert len(keys(trials)) == len(set(keys(trials))) == len(payloads) * 3 * 2 * 2 * 2 * 2
    assert all(len(trial.configurations) <= IN_TURNS for trial in trials)
    one = trials[0]
    assert one.payload.ids == one.configurations[0].nodes
    # The algorithms of one choice are drawn in turns with each other.
    assert [each.algorithm for each in one.configurations[:3]] == ["1-pass", "2-pass", "3-pass"]


def test_a_recording_is_among_the_sources(rings: SceneFile) -> None:
    recording = rings.path.with_name("frames.csv")
    recording.write_text("u_scale\n1\n2\n")
    rings.path.write_text(f'{rings.path.read_text()}\n[recording]\nfile = "frames.csv"\n')
    before = keys(planned(rings))
    assert keys(planned(rings)) == before
    recording.write_text("u_scale\n1\n3\n")
    assert not set(keys(planned(rings))) & set(before)


def test_rates_are_planned(rings: SceneFile) -> None:
    trials = planned(rings, rates=("full", "half"), passes=("3",))
    found = [one.payload_rate for trial in trials for one in trial.configurations]
    assert set(found) == {"full", "half"} and found.count("full") == found.count("half")
    assert len(set(keys(trials))) == len(found)
    # Two passes have no pass of payloads alone, so there is one combination less.
    both = planned(rings, rates=("full", "half"), passes=("2", "3"))
    assert {
        (one.algorithm, one.payload_rate) for trial in both for one in trial.configurations
    } == {
        ("2-pass", "full"),
        ("3-pass", "full"),
        ("3-pass", "half"),
    }
    with pytest.raises(UsageError, match="fraction of the rate"):
        check_choices(structs.replace(SMALL, rates=("half",), passes=("2",)))
    with pytest.raises(UsageError, match="no rates"):
        check_choices(structs.replace(SMALL, rates=()))


def test_one_node_of_each_value(rings: SceneFile) -> None:
    some, every = planned(rings), planned(rings, every_node=True)
    assert len(every) > len(some)
    assert sum(trial.payload.equal for trial in some) == len(every)


def test_places_are_those_of_the_source(rings: SceneFile) -> None:
    lines = rings.path.with_name("rings.frag").read_text().split("\n")
    for trial in planned(rings):
        ((line, column, end_line, end_column),) = trial.payload.places
        assert line == end_line
        assert lines[line - 1][column - 1 : end_column - 1] == trial.payload.text


def test_the_text_of_the_shader_counts(rings: SceneFile) -> None:
    shader = rings.path.with_name("rings.frag")
    text = shader.read_text()
    before = planned(rings)
    shader.write_text(text)
    assert keys(planned(rings)) == keys(before)
    for other in (text + "// a remark\n", text.replace("6.0 * turn", "7.0 * turn")):
        shader.write_text(other)
        assert not set(keys(planned(rings))) & set(keys(before))


@pytest.mark.parametrize("name", ("scene.toml", "torus.npz", "rings.vert"))
def test_every_file_of_the_scene_counts(rings: SceneFile, name: str) -> None:
    before = planned(rings)
    path = rings.path.with_name(name)
    if name == "torus.npz":
        path.write_bytes(path.read_bytes() + b"\0")
    else:
        path.write_text(path.read_text().replace("fov_degrees = 45.0", "fov_degrees = 44.0"))
        path.write_text(path.read_text().replace("* a_normal", "* -a_normal"))
    after = planned(rings)
    assert not set(keys(after)) & set(keys(before))
    assert identities(after) == identities(before)


@pytest.mark.parametrize("changed", ({"size": (64, 32)}, {"frames": 5}, {"periods": (7,)}))
def test_what_was_asked_for_counts(rings: SceneFile, changed: dict[str, object]) -> None:
    assert not set(identities(planned(rings, **changed))) & set(identities(planned(rings)))


def test_how_long_is_timed_does_not_count(rings: SceneFile) -> None:
    assert keys(planned(rings, seconds=1.0, until=9.0)) == keys(planned(rings))


def test_another_machine_is_another_row(rings: SceneFile) -> None:
    trials = planned(rings)
    both = on_each(trials, [HERE, structs.replace(HERE, cores=4), HERE])
    assert len(set(identities(both))) == 2 * len(identities(trials))


def test_conditions(rings: SceneFile) -> None:
    trials = planned(rings, periods=(8, 32))
    words = trials[0].words(trials[0].configurations[0])
    condition = read_conditions(["passes=2,3", "period=8"], words)
    left = chosen(trials, lambda trial, one: condition(trial.words(one)))
    kept = [one for trial in left for one in trial.configurations]
    assert {(one.algorithm, one.refresh.period) for one in kept} == {("2-pass", 8), ("3-pass", 8)}
    assert chosen(trials, lambda trial, one: False) == []
    for text in ("passes", "nothing=1", "=2"):
        with pytest.raises(UsageError, match="SC008"):
            read_conditions([text], words)


def test_the_estimate_grows_with_what_is_drawn(rings: SceneFile) -> None:
    trial = planned(rings)[0]
    assert 0.0 < trial_seconds(trial, 0.01) < trial_seconds(trial, 0.1)
    assert plan_seconds([trial, trial], {rings: 0.01}) == 2.0 * trial_seconds(trial, 0.01)
    assert plan_seconds([trial], {}) == 0.0


def test_choices_of_a_file(tmp_path: Path) -> None:
    path = tmp_path / "choices.toml"
    path.write_text('scenes = ["a"]\nperiods = [8, 16]\nsize = [64, 32]\ncache = ["", "age=on"]\n')
    assert read_choices(path) == Choices(
        scenes=("a",), periods=(8, 16), size=(64, 32), cache=("", "age=on")
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("periods = [0]", "periods"),
        ("blocks = [3]", "blocks"),
        ("period = [3]", "period"),
        ('formats = ["rgba8"]', "formats"),
        ("frames = 1", "frames"),
        ("until = -1", "until"),
        ("periods = 8", "periods"),
        ("periods = [", ""),
        ("x = " + "[" * 5000, "brackets"),
        (b"\xff", ""),
        (None, ""),
    ],
)
def test_bad_files_of_choices(tmp_path: Path, text: str | bytes | None, said: str) -> None:
    path = tmp_path / "choices.toml"
    if text is not None:
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(InputError, match="SC035") as caught:
        read_choices(path)
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("choices", "said"),
    [
        (Choices(passes=("4",)), "'4' is no algorithm"),
        (Choices(periods=()), "no periods"),
        (Choices(blocks=(2, 2)), "one of its blocks twice"),
    ],
)
def test_choices_that_make_no_sense(choices: Choices, said: str) -> None:
    with pytest.raises(UsageError, match=said):
        check_choices(choices)


def test_a_setting_that_is_not_known(rings: SceneFile) -> None:
    with pytest.raises(UsageError, match="SC028"):
        planned(rings, cache=("filter=none",))
    with pytest.raises(UsageError, match="SC010"):
        planned(rings, nodes=("nothing",))


def test_a_node_by_its_text_is_that_node(rings: SceneFile) -> None:
    [by_text] = planned(rings, nodes=("rings( v_position )",), passes=("2",))
    assert by_text.payload.label == "rings( v_position )"
    assert by_text.payload.text == "rings(v_position)"
    [by_id] = planned(rings, nodes=by_text.payload.ids, passes=("2",))
    assert by_text.configurations == by_id.configurations

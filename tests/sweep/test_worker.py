"""Workers that draw, hang, crash and are killed."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from threading import Timer

import pytest

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import InputError
from shadercache.sweep.carry_out import carry_out
from shadercache.sweep.plan import SceneFile, SweepTrial, plan_scene
from shadercache.sweep.results import failure_row
from shadercache.sweep.row import Failure, Row
from shadercache.sweep.store import Store, hash_of
from shadercache.sweep.trial_room import Finished
from shadercache.sweep.worker import Request, Worker, WorkerLostError

from .test_plan import SMALL, planned
from .test_store import HERE

pytestmark = pytest.mark.xdist_group("gl")


@pytest.fixture
def worker() -> Iterator[Worker]:
    with Worker() as opened:
        yield opened


def process_of(worker: Worker) -> int:
    assert worker._child is not None
    return worker._child.process.pid


def test_a_trial_becomes_rows(worker: Worker, rings: SceneFile) -> None:
    trial = planned(rings)[-1]
    finished = worker.carry_out(trial)
    assert [row.words["algorithm"] for row in finished.rows] == ["1-pass", "2-pass", "3-pass"]
    for row in finished.rows:
        result = row.result
        assert result is not None and result.reuse is not None
        assert row.machine == worker.machine()
        assert 0.0 < result.image.rmse < 0.1 and result.times.ratio.low > 0.0
        assert len(result.times.samples.subject) >= trial.scene.frames - 1
        assert 0.3 < result.reuse.hit_rate < 1.0
        assert {"original", "cached", "outcomes", "payload", "thumbnail"} == set(row.pictures)
        assert {"source.frag", "source.vert"} < set(row.texts)
        names = [*row.texts.values(), *row.pictures.values()]
        assert all(hash_of(finished.blobs[name]) == name for name in names)
    texts = finished.rows[1].texts
    assert "sc_cache" in finished.blobs[texts["2-pass.hit.frag"]].decode()


def test_two_runs_differ_in_times_alone(worker: Worker, rings: SceneFile) -> None:
    trial = planned(rings)[0]
    first, second = (worker.carry_out(trial).rows for _ in range(2))
    for one, other in zip(first, second, strict=True):
        assert one.result is not None and other.result is not None
        assert (one.key, one.texts, one.pictures) == (other.key, other.texts, other.pictures)
        assert (one.result.image, one.result.reuse) == (other.result.image, other.result.reuse)


def test_where_the_frames_of_two_passes_go(worker: Worker, rings: SceneFile) -> None:
    trial = planned(rings)[-1]
    asked = replace(trial, limits=replace(trial.limits, profile=True))
    asked, trial = (replace(one, machine=worker.machine()) for one in (asked, trial))
    assert asked.key(trial.configurations[0]) != trial.key(trial.configurations[0])
    for row in worker.carry_out(asked).rows:
        assert row.result is not None
        parts = [part.name for part in row.result.times.profile]
        assert bool(parts) == (row.words["passes"] == "2")
        assert not parts or (parts[0], parts[-1]) == ("clears", "not explained")


def test_a_variant_that_cannot_be_is_a_row(worker: Worker, rings: SceneFile) -> None:
    trial = planned(rings)[0]
    bad = replace(trial.configurations[0], nodes=("main.1-nothing",))
    rows = worker.carry_out(replace(trial, configurations=(bad, trial.configurations[1]))).rows
    assert [row.failure and row.failure.kind for row in rows] == [None, "refused"]
    assert rows[1].failure is not None and rows[1].failure.code == "SC011"


def test_why_an_algorithm_does_not_fit(worker: Worker, rings: SceneFile) -> None:
    """The first object is not cached, and has no variants that could tell."""
    fragment = rings.path.with_name("rings.frag")
    fragment.write_text(
        fragment.read_text().replace("in vec3", "struct { float a; } g;\nin vec3", 1)
    )
    with rings.path.open("a") as scene:
        scene.write('[[objects]]\nname = "plain"\ncached = false\n[[objects]]\nname = "cached"\n')
    trial = planned(rings)[-1]
    (row,) = worker.carry_out(replace(trial, configurations=trial.configurations[:1])).rows
    assert row.failure is not None and row.failure.code == "SC026"
    assert "struct without a name" in row.failure.message


def test_rates_are_those_of_the_algorithm_that_has_them(worker: Worker, rings: SceneFile) -> None:
    """Three passes alone have a pass for payloads; the others are not planned."""
    [row] = worker.carry_out(planned(rings, rates=("half",))[-1]).rows
    assert (row.words["algorithm"], row.words["rate"]) == ("3-pass", "half")
    assert row.result is not None


def test_an_original_that_the_driver_rejects(worker: Worker, rings: SceneFile) -> None:
    trial = planned(rings)[0]
    vertex = rings.path.with_name("rings.vert")
    vertex.write_text(vertex.read_text().replace("mat3(u_model)", "mat3(u_missing)"))
    with pytest.raises(InputError):
        worker.carry_out(trial)


def test_a_worker_that_is_killed_is_lost_and_replaced(rings: SceneFile, worker: Worker) -> None:
    trial = planned(rings)[0]
    machine = worker.machine()
    Timer(0.3, os.kill, (process_of(worker), signal.SIGKILL)).start()
    with pytest.raises(WorkerLostError) as caught:
        while True:
            worker.carry_out(trial)
    assert caught.value.failure.kind == "crashed"
    assert worker.machine() == machine


def test_what_a_driver_prints_is_no_answer() -> None:
    code = """
import os
from shadercache.sweep import worker

class Room:
    def __init__(self, say):
        os.write(1, b"driver 1.0")

    def machine(self):
        return "here"

worker.TrialRoom = Room
worker.serve()
"""
    asked = pickle.dumps(Request("machine"))
    done = subprocess.run(
        [sys.executable, "-c", code], input=asked, capture_output=True, check=True
    )
    assert (pickle.loads(done.stdout), done.stderr) == (("answer", "here"), b"driver 1.0")


def test_a_shader_that_hangs(rings: SceneFile) -> None:
    shader = rings.path.with_name("rings.frag")
    loop = "for (int i = 0; i < 65535; i++) for (int j = 0; j < 65535; j++)"
    body = f"{loop} color += 1e-9 * sin(color.yzx + float(i + j));\n    o_color"
    shader.write_text(shader.read_text().replace("o_color =", f"{body} =", 1))
    trial = replace(plan_scene(rings, SMALL)[0], machine=HERE)
    with Worker(patience=3.0) as worker, pytest.raises(WorkerLostError) as caught:
        worker.machine()
        worker.carry_out(trial)
    assert caught.value.failure.kind == "hung"
    assert not caught.value.original_drawn


class Fragile:
    """A worker whose driver crashes at some algorithms, and has no original of some scenes."""

    def __init__(self, *crashing: str, hopeless: tuple[SceneFile, ...] = ()) -> None:
        self.crashing, self.hopeless = crashing, hopeless
        self.asked: list[list[str]] = []

    def carry_out(self, trial: SweepTrial) -> Finished:
        names = [one.algorithm for one in trial.configurations]
        self.asked.append(names)
        crash = Failure("crashed", "SC606", "it died")
        if trial.file in self.hopeless or any(name in self.crashing for name in names):
            raise WorkerLostError(crash, original_drawn=trial.file not in self.hopeless)
        done = Failure("refused", "done", "in place of a result")
        return Finished(tuple(failure_row(trial, one, done) for one in trial.configurations), {})


def outcomes(rows: list[Row]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for row in rows:
        assert row.failure is not None
        found.setdefault(row.failure.code, []).append(
            Configuration.from_json(row.configuration).algorithm
        )
    return found


def test_what_crashes_is_found_one_by_one(rings: SceneFile, tmp_path: Path) -> None:
    trials = planned(rings)[:2]
    fragile = Fragile("2-pass")
    heard: list[Row] = []
    with Store(tmp_path / "sweep.db", create=True) as store:
        carry_out(trials, fragile, store, heard.append)  # type: ignore[arg-type]
        assert store.rows() == heard
    assert fragile.asked[:4] == [["1-pass", "2-pass", "3-pass"], ["1-pass"], ["2-pass"], ["3-pass"]]
    assert outcomes(heard) == {"done": ["1-pass", "3-pass"] * 2, "SC606": ["2-pass"] * 2}


def test_a_scene_whose_original_crashes_is_given_up(rings: SceneFile, tmp_path: Path) -> None:
    other = replace(rings, mapping="surface")
    trials = [trial for file in (rings, other) for trial in planned(file)[:2]]
    fragile, heard = Fragile(hopeless=(rings,)), list[Row]()
    with Store(tmp_path / "sweep.db", create=True) as store:
        carry_out(trials, fragile, store, heard.append)  # type: ignore[arg-type]
    assert len(fragile.asked) == 3  # its second trial is not tried
    found = outcomes(heard)
    assert {code: len(names) for code, names in found.items()} == {"SC606": 6, "done": 6}

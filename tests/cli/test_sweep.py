"""``shadercache sweep`` from the command line."""

from __future__ import annotations

import json
import shutil
import sqlite3
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import pytest

from shadercache.sweep.store import Store

from .conftest import Shell

pytestmark = pytest.mark.xdist_group("gl")


class Undisturbed(NamedTuple):
    options: list[str]
    store: Path
    seconds: float


SHADERS = Path(__file__).parent.parent / "sweep" / "shaders"
QUICK = ("--size", "48", "--frames", "4", "--seconds", "0")


def rings(scene_folder: Path, folder: Path) -> Path:
    shutil.copytree(scene_folder, folder)
    shutil.copytree(SHADERS, folder, dirs_exist_ok=True)
    file = folder / "scene.toml"
    text = file.read_text().replace("emission/original", "rings").partition("[nodes]")[0]
    file.write_text(text)
    return file


@pytest.fixture
def scene_file(scene_folder: Path, tmp_path: Path) -> Path:
    return rings(scene_folder, tmp_path / "rings")


@pytest.fixture(scope="module")
def undisturbed(scene_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Undisturbed:
    """A sweep that nothing happens to."""
    from bench.killed_sweep import command

    folder = tmp_path_factory.mktemp("sweep")
    options = [str(rings(scene_folder, folder / "rings")), *QUICK, "--period", "8"]
    begun = time.monotonic()
    subprocess.run(command(options, folder / "whole.db"), check=True)
    return Undisturbed(options, folder / "whole.db", time.monotonic() - begun)


@pytest.fixture
def node(shell: Shell, scene_file: Path) -> str:
    nodes = shell("nodes", scene_file.with_name("rings.frag"), "--json", "--offered").nodes
    return next(one["id"] for one in nodes if one["text"] == "rings(v_position)")


def test_a_sweep_goes_on_where_it_was(
    shell: Shell, scene_file: Path, node: str, tmp_path: Path
) -> None:
    store = tmp_path / "sweep.db"
    sweep = ("sweep", scene_file, "--nodes", node, *QUICK, "-o", store)
    first = shell(*sweep, "--period", "8", "--passes", "2")
    assert (first.status, first.out.splitlines()[-1]) == (
        0,
        f"written to {store}: 1, of which failures: 0",
    )
    more = shell(*sweep, "--period", "8,16", "--passes", "2,3", "--export", tmp_path / "rows.json")
    assert more.out.splitlines()[-1] == f"written to {store}: 3, of which failures: 0"
    again = shell(*sweep, "--period", "8,16", "--passes", "2,3")
    assert "nothing to do" in again.out
    forced = shell(*sweep, "--period", "8,16", "--force", "--where", "passes=2")
    assert forced.out.splitlines()[-1] == f"written to {store}: 2, of which failures: 0"
    rows = json.loads((tmp_path / "rows.json").read_text())["rows"]
    assert len(rows) == 4 and all(row["outcome"]["type"] == "result" for row in rows)


def test_only_the_plan(shell: Shell, scene_file: Path, tmp_path: Path) -> None:
    store = tmp_path / "sweep.db"
    outcome = shell("sweep", scene_file, *QUICK, "-o", store, "--dry-run")
    assert outcome.status == 0 and not store.exists()
    assert "about" in outcome.out or "less than a minute" in outcome.out
    assert outcome.out.splitlines()[1].split()[0] == "torus"


def test_a_scene_that_changed(shell: Shell, scene_file: Path, node: str, tmp_path: Path) -> None:
    store = tmp_path / "sweep.db"
    sweep = ("sweep", scene_file, "--nodes", node, *QUICK, "-o", store, "--passes", "2")
    shell(*sweep)
    assert "nothing to do" in shell(*sweep, "--stale").out
    scene_file.write_text(scene_file.read_text().replace("fov_degrees = 45.0", "fov_degrees = 40"))
    outcome = shell(*sweep, "--stale")
    assert "1 row is stale: the scene" in outcome.out
    assert outcome.out.splitlines()[-1] == f"written to {store}: 1, of which failures: 0"
    with Store(store) as opened:
        assert len(opened.rows(stale=True)) == 1
    assert "stale" not in shell(*sweep).out


def test_choices_of_a_file(shell: Shell, scene_file: Path, node: str, tmp_path: Path) -> None:
    choices = tmp_path / "choices.toml"
    choices.write_text(
        f'scenes = ["{scene_file}"]\nnodes = ["{node}"]\npasses = ["2"]\nsize = [48, 32]\n'
        "frames = 4\nseconds = 0\n"
    )
    store = tmp_path / "sweep.db"
    outcome = shell("sweep", "--choices", choices, "-o", store)
    assert outcome.out.splitlines()[-1] == f"written to {store}: 1, of which failures: 0"
    with Store(store) as opened:
        assert opened.rows()[0].scene.size == (48, 32)
    both = shell("sweep", "--choices", choices, "--period", "8", "-o", store)
    assert both.status == 2 and "SC003" in both.err


def test_an_original_that_cannot_be_drawn_is_a_row(
    shell: Shell, scene_file: Path, node: str, tmp_path: Path
) -> None:
    scene_file.write_text(scene_file.read_text().replace('"torus.npz"', '"missing.npz"', 1))
    (scene_file.parent / "missing.npz").write_bytes(b"no mesh")
    store = tmp_path / "sweep.db"
    outcome = shell("sweep", scene_file, "--nodes", node, *QUICK, "-o", store)
    assert outcome.status == 0
    assert f"written to {store}: 3, of which failures: 3" in outcome.out
    assert "rejected" in outcome.out and "SC51" in outcome.out


@pytest.mark.parametrize(
    ("options", "status", "said"),
    [
        ((), 2, "SC003"),
        (("--nodes", "nothing"), 2, "SC010"),
        (("--period", "0"), 2, "SC008"),
        (("--format", "rgba8"), 2, "SC008"),
        (("--passes", "4"), 2, "SC008"),
        (("--cache", "filter=none"), 2, "SC028"),
        (("--until", "-1"), 2, "SC003"),
        (("--size", "0"), 2, "SC007"),
        (("--where", "period"), 2, "SC008"),
        (("--export", "rows.txt"), 2, "SC008"),
        (("--choices", "missing.toml"), 1, "SC035"),
        (("--cluster", "local:0"), 2, "SC036"),
    ],
)
def test_bad_requests(
    shell: Shell, scene_file: Path, tmp_path: Path, options: tuple[str, ...], status: int, said: str
) -> None:
    target = (scene_file,) if options else ()
    outcome = shell("sweep", *target, *options, "-o", tmp_path / "sweep.db")
    assert (outcome.status, said in outcome.err) == (status, True), outcome.err
    # A condition can be read once there are trials, and the store is open then.
    assert not (tmp_path / "sweep.db").exists() or options[0] == "--where"


def test_a_store_that_is_none(shell: Shell, scene_file: Path, tmp_path: Path) -> None:
    path = tmp_path / "theirs.db"
    with sqlite3.connect(path) as theirs:
        theirs.execute("CREATE TABLE mine (name TEXT)")
    theirs.close()
    outcome = shell("sweep", scene_file, *QUICK, "-o", path)
    assert outcome.status == 1 and "another program" in outcome.err
    missing = shell("sweep", "-o", tmp_path / "none.db", "--export", tmp_path / "rows.csv")
    assert missing.status == 1 and "SC033" in missing.err


@pytest.mark.slow
def test_a_sweep_that_is_killed_loses_nothing(undisturbed: Undisturbed, tmp_path: Path) -> None:
    from bench.killed_sweep import command, compare, kill_often, read

    killed = command(undisturbed.options, tmp_path / "killed.db")
    assert kill_often(killed, undisturbed.seconds, kills=3, seed=1) > 0
    subprocess.run(killed, check=True)
    assert len(read(undisturbed.store)) >= 9
    assert compare(read(undisturbed.store), read(tmp_path / "killed.db")) == []


@pytest.mark.slow
def test_a_cluster_of_two(undisturbed: Undisturbed, tmp_path: Path) -> None:
    """Of its two processes one is killed in the middle."""
    pytest.importorskip("distributed")
    from bench.killed_sweep import compare, read

    options, spread = undisturbed.options, tmp_path / "spread.db"
    code = f"""
import os, signal, sys
from shadercache import cluster
from shadercache.cli.app import main
from shadercache.sweep import crew

spread = crew.spread

def with_a_loss(client, work, tasks):
    killed = False
    for found in spread(client, work, tasks):
        if not killed:
            first = next(iter(client.scheduler_info()["workers"].values()))
            client.run(os.getpid)
            pids = client.run(os.getpid)
            os.kill(next(iter(pids.values())), signal.SIGKILL)
            killed = True
        yield found

if __name__ == "__main__":
    crew.spread = with_a_loss
    sys.exit(main(["sweep", *{options!r}, "-o", {str(spread)!r}, "--cluster", "local:2"]))
"""
    script = tmp_path / "lossy.py"
    script.write_text(code)
    subprocess.run([sys.executable, str(script)], check=True)
    assert compare(read(undisturbed.store), read(spread)) == []


@pytest.mark.slow
def test_verdicts_of_a_cluster_are_those_of_one_process(shell: Shell, scene_file: Path) -> None:
    pytest.importorskip("distributed")
    options = ("verify", scene_file, "--all", "--proof-only", "--json")
    one = shell(*options, "-j", "1").json
    many = shell(*options, "--cluster", "local:2").json
    assert one["checked"] >= 3
    assert {**one, "environment": None} == {**many, "environment": None}

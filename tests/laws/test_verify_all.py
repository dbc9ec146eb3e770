"""``./dev verify-all`` keeps what it found, says what is broken, and goes on where it stopped."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
import verify_all

from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.scene.description import load_scene
from shadercache.verify.parallel import VerifiedScene
from shadercache.verify.verdict import Difference, Verdict

pytestmark = pytest.mark.xdist_group("laws-trashcan")

Heard = Callable[[Verdict], None]


class Renderer:
    """Stands in for the verifier's processes: gives every node a verdict, or stops half way."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.stops_after: int | None = None
        self.broken: set[str] = set()

    def __call__(self, scene: VerifiedScene, nodes: Sequence[str], jobs: int, heard: Heard) -> None:
        for count, node in enumerate(nodes):
            if count == self.stops_after:
                raise KeyboardInterrupt
            self.asked.append(node)
            found = Difference(0.5, 0.25, 0.12345) if node in self.broken else Difference()
            heard(Verdict(node, "main", "a + b", True, laws={"always": {"2-pass": found}}))


@pytest.fixture
def renderer(monkeypatch: pytest.MonkeyPatch) -> Renderer:
    made = Renderer()
    monkeypatch.setattr(verify_all, "verify_in_parallel", made)
    return made


def run(folder: Path, *arguments: str) -> tuple[int, dict[str, Any]]:
    """Exit status and result file of the trash can's run."""
    status = verify_all.main(["--scene", "trashcan", "-o", str(folder), *arguments])
    return status, json.loads((folder / "verify-trashcan.json").read_text(encoding="utf-8"))


def test_every_legal_node_has_a_row(tmp_path: Path, renderer: Renderer) -> None:
    status, found = run(tmp_path)
    assert status == 0
    assert [row["id"] for row in found["nodes"]] == renderer.asked
    assert found["counts"]["legal"] == found["counts"]["verified"] == len(renderer.asked) >= 60
    assert found["nodes"][0] == {"id": renderer.asked[0], "path": "main"}
    assert found["law_1"] == "exact"
    assert found["environment"]["gl"]["renderer"]


def test_of_scenes_with_several_objects_each_offered_value_is_taken_once() -> None:
    scene, analysis = analyse_scene(load_scene(data_path("corpus", "heroine")))
    chosen = verify_all.nodes_of(scene, analysis)
    values = {analysis.groups[node] for node in analysis.nodes if node.offered}
    assert all(node.offered for node in chosen)
    assert len(chosen) == len({analysis.groups[node] for node in chosen}) == len(values)


def test_an_interrupted_run_is_taken_up(tmp_path: Path, renderer: Renderer) -> None:
    renderer.stops_after = 7
    status, found = run(tmp_path)
    assert status == 130
    assert found["counts"]["verified"] == len(found["nodes"]) == 7
    renderer.stops_after = None
    status, found = run(tmp_path, "--resume")
    assert status == 0
    assert len(renderer.asked) == len(set(renderer.asked)) == found["counts"]["legal"]


def test_without_resume_all_starts_anew(tmp_path: Path, renderer: Renderer) -> None:
    run(tmp_path, "--limit", "3")
    _, found = run(tmp_path, "--limit", "3")
    assert renderer.asked[:3] == renderer.asked[3:]
    assert found["counts"]["verified"] == 3


@pytest.mark.parametrize("text", ["", "{", "[]", '{"fingerprint": "another"}'])
def test_other_results_are_not_taken_over(tmp_path: Path, renderer: Renderer, text: str) -> None:
    (tmp_path / "verify-trashcan.json").write_text(text)
    status, found = run(tmp_path, "--resume", "--limit", "2")
    assert status == 0
    assert found["counts"]["verified"] == len(renderer.asked) == 2


def test_a_broken_node_is_told_with_its_figures(
    tmp_path: Path, renderer: Renderer, capsys: pytest.CaptureFixture[str]
) -> None:
    run(tmp_path, "--limit", "1")
    node = renderer.asked[0]
    renderer.broken = {node}
    status, found = run(tmp_path, "--limit", "2")
    assert status == 1
    assert found["nodes"][0]["broken"] == {"law 2 (2-pass)": [0.5, 0.25, 0.123]}
    assert found["counts"]["broken"] == 1
    told = capsys.readouterr()
    assert f"BROKEN: {node}" in told.out
    assert f"{node} (main): law 2 (2-pass)" in told.err
    assert run(tmp_path, "--resume", "--limit", "1")[0] == 1, "it stays broken"


def test_rows_hold_what_is_not_as_it_should_be() -> None:
    inexact = Difference(1.23456e-7, float("inf"), 0.5)
    verdict = Verdict("main.1-00", "main", "text", False, plain={"1-pass": inexact})
    verdict.refused["1-pass"] = "the reason"
    verdict.failure = "error: it does not compile"
    assert verify_all.row_of(verdict) == {
        "id": "main.1-00",
        "path": "main",
        "unprofitable": True,
        "without": ["1-pass"],
        "text": "text",
        "broken": {},
        "failure": "error: it does not compile",
        "plain": [1.23e-7, None, 0.5],
    }


def test_machine_names(monkeypatch: pytest.MonkeyPatch) -> None:
    about = {"gl": {"renderer": "llvmpipe (LLVM 15.0.6, 256 bits)"}, "cores": 2}
    monkeypatch.delenv("MACHINE", raising=False)
    assert verify_all.machine_name(about) == "llvmpipe-2-cores"
    monkeypatch.setenv("MACHINE", "workbench")
    assert verify_all.machine_name(about) == "workbench"


def test_real_nodes(tmp_path: Path) -> None:
    status, found = run(tmp_path, "--limit", "2", "-j", "2")
    assert status == 0
    assert found["counts"]["exact in proof mode"] == 2

"""Each experiment from end to end, small; its file, and the page of all."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from bench.papers.claims import CLAIMS, ELSEWHERE, NOT_BUILT
from bench.papers.experiment import Experiment, Options
from bench.papers.page import page_text
from bench.papers.result import load, stands, store
from bench.papers.scene_nodes import distinct_nodes
from bench.papers.suite import EXPERIMENTS, run
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path

pytestmark = pytest.mark.xdist_group("gl")

ROOT = Path(__file__).resolve().parents[3]
SMALL = Options(64, quick=True)


@pytest.mark.parametrize("experiment", EXPERIMENTS, ids=lambda one: str(one.name))
def test_an_experiment_runs_and_is_read_back(
    gpu: Gpu, experiment: Experiment[Any], tmp_path: Path
) -> None:
    result = run(gpu, experiment, SMALL)
    path = tmp_path / "result.json"
    store(path, result)
    again = load(path, experiment)
    assert again is not None and again.data == result.data
    assert [verdict.claim for verdict in again.verdicts] == [one.claim for one in result.verdicts]
    written = json.loads(path.read_text())
    assert written["environment"]["date"] and written["gl"]["renderer"]
    assert experiment.name in again.text
    for verdict in again.verdicts:
        assert CLAIMS[verdict.claim].sentence in again.text and verdict.numbers in again.text
    for name in experiment.draw(again.data):
        pixels = np.asarray(Image.open(io.BytesIO((tmp_path / f"{name}.png").read_bytes())))
        assert np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0).shape[0] > 10
    assert stands(path, SMALL, result.about)
    assert not stands(path, Options(96, quick=True), result.about)
    assert not stands(path, SMALL, {**result.about, "gl": {"renderer": "another"}})


def test_what_cannot_be_read_is_measured_again(tmp_path: Path) -> None:
    path, experiment = tmp_path / "result.json", EXPERIMENTS[0]
    assert load(path, experiment) is None
    for text in ("{", "[]", '{"schema_version": 1, "data": {}, "options": {}}'):
        path.write_text(text)
        assert load(path, experiment) is None


def test_the_page_has_every_claim(tmp_path: Path) -> None:
    text = page_text(tmp_path / "PAPERS.md", [], tmp_path)
    for claim in (*CLAIMS.values(), *(claim for claim, _ in ELSEWHERE), *NOT_BUILT):
        assert claim.sentence in text
    assert "quick" not in text


def test_one_path_stands_for_an_expression() -> None:
    scene, analysis = open_scene(data_path("corpus", "dragon", "scene.toml"))
    nodes = distinct_nodes(scene, analysis)
    offered = [node for node in analysis.nodes if node.offered]
    assert sum(node.stands_for for node in nodes) == len(offered)
    assert len({node.id for node in nodes}) == len(nodes) < len(offered) / 5
    assert set(scene.nodes.values()) <= {node.id for node in nodes}
    assert [node.ratio for node in nodes] == sorted(node.ratio for node in nodes)


def test_the_command_resumes(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "bench.papers", "--quick", "--only", "AGES", "-o", tmp_path]

    def told(*more: str) -> str:
        done = subprocess.run(
            [*command, *more], cwd=ROOT, capture_output=True, text=True, check=True
        )
        return done.stdout

    assert "N8" in told()
    written = (tmp_path / "ages.json").read_bytes()
    assert "stands in" in told("--resume")
    assert (tmp_path / "ages.json").read_bytes() == written
    page = (tmp_path / "PAPERS.md").read_text()
    assert "From a quick run" in page and "`./dev papers --only AGES`" in page


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["--size", "3"], 2, "no edge from 16 to 8192"),
        (["--only", "FIG7"], 2, "FIG7"),
        (["--quick", "--only", "AGES", "-o", "made/folder"], 2, "SC025"),
    ],
)
def test_bad_input_is_told(tmp_path: Path, arguments: list[str], status: int, words: str) -> None:
    (tmp_path / "made").touch()
    command = [sys.executable, "-m", "bench.papers", *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode == status
    assert words in done.stderr and "Traceback" not in done.stderr

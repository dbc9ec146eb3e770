"""No pass does work that only a dropped parameter or a pointless return kept alive."""

from __future__ import annotations

from contextlib import closing
from itertools import combinations
from pathlib import Path
from random import Random

import pytest
from analysis.test_shared_work import can_be_cached, compare
from laws.random_sets import random_sets
from reports.in_scene import analysed, scene_of

from shadercache.gpu.context import Gpu
from shadercache.verify.verifier import Verifier
from tests.cases.cases import analysed as analysed_case

FOLDER = Path(__file__).with_name("idle_work")
PATHS = [pytest.param(path, id=path.stem) for path in sorted(FOLDER.glob("*.frag"))]

PAIRS = 30
"""Of each shader at random."""

TOLD = {
    "return_in_loop": ("wave.18-e9f099ee", "wave.1-879c29e4"),
    "sampler_parameters": ("blend.8-f4a86dc0", "wave.1-786f143f"),
    "hidden_state": ("step_by.4-ad73691d", "wave.1-32417f21"),
    "hidden_state, the other way": ("wave.4-57f14c6b", "wave.12-6fb67194"),
}


@pytest.mark.parametrize(("case", "ids"), TOLD.items(), ids=TOLD)
def test_pairs_that_cost_more_than_was_told(case: str, ids: tuple[str, ...]) -> None:
    analysis = analysed_case(case.split(",")[0])
    compare(analysis, *(node for id in ids for node in analysis.nodes if node.id == id))


@pytest.mark.parametrize("path", PATHS)
def test_pairs_cost_what_is_told(path: Path) -> None:
    analysis = analysed(path)
    pairs = list(combinations([node for node in analysis.nodes if node.legal], 2))
    for pair in Random(path.stem).sample(pairs, min(PAIRS, len(pairs))):
        if can_be_cached(analysis, pair):
            compare(analysis, *pair)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("path", PATHS)
def test_laws_2_to_4(path: Path, gpu: Gpu, cases_folder: Path) -> None:
    analysis = analysed(path)
    legal = [node for node in analysis.nodes if node.legal]
    sets, _ = random_sets(analysis, legal, Random(path.stem), 2)
    with closing(Verifier(gpu, (scene_of(path, cases_folder), analysis), (40, 40))) as verifier:
        verdicts = [verifier.check(nodes, plain=False) for nodes in sets]
    assert not {item.text: item.failure or item.broken for item in verdicts if item.broken}

"""What a node costs on one path, put together from walks that other paths share."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.costs.shared_work import SharedWorkTable
from shadercache.analysis.effect_table import EffectTable
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from tests.cases.cases import sources
from tests.cases.test_cases import CACHEABLE
from tests.generated.dialects import DIALECTS
from tests.generated.suite import quick_shader

CORPUS = Path(__file__).parents[2] / "corpus"
SCENES = sorted(path.relative_to(CORPUS) for path in CORPUS.glob("*/*.frag"))
MOST = 400
"""Nodes of one shader; a walk of the whole shader for each takes long."""


def check(analysis: Analysis) -> int:
    """Every node costs what a walk of the whole shader says; how many were compared."""
    program = analysis.program
    table, costs = EffectTable(program.module), CostTable(program.facts)
    overlaps = SharedWorkTable(analysis.candidates.instances, table, costs, program.colors)
    nodes = [node for node in analysis.nodes if node.legal]
    for node in nodes[:: 1 + len(nodes) // MOST]:
        assert overlaps.parts([node]) == overlaps.parts_of_set([node]), (node.path, node.text)
    return len(nodes)


@pytest.mark.parametrize("unroll", [False, True])
@pytest.mark.parametrize("name", CACHEABLE)
def test_cases(name: str, unroll: bool) -> None:
    check(analyse(*sources(name), ReadOptions(unroll=unroll)))


@pytest.mark.parametrize("path", SCENES, ids=str)
def test_corpus(path: Path) -> None:
    text = (CORPUS / path).read_text(encoding="utf-8")
    assert check(analyse(Source(path.name, text))) > 10


@pytest.mark.parametrize("number", range(60))
@pytest.mark.slow
def test_generated_shaders(number: int) -> None:
    shader = quick_shader(sorted(DIALECTS)[number % len(DIALECTS)], number)
    try:
        analysis = analyse(Source("made.frag", shader.text))
    except InputError:
        return
    check(analysis)

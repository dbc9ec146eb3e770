"""What payload and shading have in common, against the passes that are emitted."""

from __future__ import annotations

from pathlib import Path

import pytest
from laws.slices import day_slice, seed
from shaders import analysed as analysed_body
from shaders import find

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.cost import FETCH, CostTable
from shadercache.ast import nodes as n
from shadercache.compiler import Analysis, analyse
from shadercache.emit.assemble import Shader
from shadercache.emit.fragment import FragmentEmitter
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.sema.check import check
from shadercache.source import Source
from shadercache.transform.precisions import with_precisions
from tests.cases.cases import analysed
from tests.cases.test_cases import CACHEABLE

BODY = """
    vec3 at = v_position * noise(v_position * 2.0);
    float once = noise(at + 1.0);
    o_color = vec4(at * once, 1.0);
"""
NOISE = (
    "float noise(vec3 p) { return sin(p.x * 3.0) * cos(p.y * 5.0) + sin(p.z * 7.0 + cos(p.x)); }"
)
AT, ONCE = "v_position * noise(v_position * 2.0)", "noise(at + 1.0)"

PADDING = 20.0
"""What packing and unpacking a payload of seven channels costs at most."""


def test_what_both_passes_need_is_told() -> None:
    analysis = analysed_body(BODY, NOISE)
    once, at = (analysis.parts(find(analysis, text, "main")) for text in (ONCE, AT))
    assert once.overlap == at.payload > 0.0
    assert once.payload + once.remainder - once.whole == once.overlap
    assert at.overlap == 0.0


def test_what_travels_along_is_not_computed_twice() -> None:
    analysis = analysed_body(BODY, NOISE)
    both = analysis.parts(*(find(analysis, text, "main") for text in (ONCE, AT)))
    assert both.overlap == 0.0
    assert both.payload < both.whole


@pytest.mark.parametrize("name", CACHEABLE)
def test_no_pass_costs_more_than_is_told(name: str) -> None:
    analysis = analysed(name)
    for node in day_slice([node for node in analysis.nodes if node.legal], seed(), 6):
        _compare(analysis, node)


@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
def test_no_pass_of_the_corpus_costs_more_than_is_told(scene: str) -> None:
    path = Path(__file__).parents[2] / "corpus" / scene / f"{scene}.frag"
    analysis = analyse(Source(path.name, path.read_text(encoding="utf-8")))
    for node in day_slice([node for node in analysis.nodes if node.legal], seed(), 12):
        _compare(analysis, node)


def _compare(analysis: Analysis, node: Candidate) -> None:
    """No pass costs more than the original and its look-ups; one pass also what is done twice."""
    parts = analysis.parts(node)
    assert parts.payload <= parts.whole and parts.remainder <= parts.whole
    emitter = FragmentEmitter(analysis.program, node)
    assert _cost(emitter.payload_only()) <= parts.payload + PADDING
    assert _cost(emitter.shade()) <= parts.remainder + 2 * FETCH + PADDING
    assert _cost(emitter.hit()) <= parts.remainder + PADDING
    assert _cost(emitter.miss()) <= parts.whole + PADDING
    # Fetches that one pass moves ahead compute where to look once more.
    if emitter.unfit_for_one_pass() is None and not emitter.fetches:
        assert _cost(emitter.one()) <= parts.whole + parts.overlap + PADDING


def _cost(shader: Shader) -> float:
    """The static cost of an emitted shader, the look-up in the cache of the last frame apart."""
    text = print_module(with_precisions(shader.module))
    module = parse(Source("pass.frag", text))
    costs = CostTable(check(module, Source("pass.frag", text), "fragment"))
    functions = {item.name: item for item in module.decls if isinstance(item, n.FunctionDef)}
    look_up = functions.get("sc_look_up")
    return costs.function(functions["main"]) - (costs.function(look_up) if look_up else 0.0)

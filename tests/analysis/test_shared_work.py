"""What payload and shading have in common, against the passes that are emitted."""

from __future__ import annotations

from pathlib import Path

import pytest
from laws.slices import amount, day_slice, seed
from shaders import analysed as analysed_body
from shaders import find

from shadercache.analysed import carrying, overlap_notes
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.cost import FETCH, CostTable
from shadercache.analysis.value_numbering import one_of_each
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.caching.algorithms import algorithm
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder, unfit
from shadercache.emit.one_pass import shade_or_reuse
from shadercache.emit.printer import print_module
from shadercache.emit.three_passes import payload_only, shade
from shadercache.emit.two_passes import hit, miss
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.versions.state_precisions import with_precisions
from shadercache.valid.validate import validate
from tests.cases.cases import analysed
from tests.cases.test_cases import CACHEABLE
from tests.configured import configured

BODY = """
    vec3 at = v_position * noise(v_position * 2.0);
    float once = noise(at + 1.0);
    o_color = vec4(at * once, 1.0);
"""
NOISE = (
    "float noise(vec3 p) { return sin(p.x * 3.0) * cos(p.y * 5.0) + sin(p.z * 7.0 + cos(p.x)); }"
)
AT, ONCE = "v_position * noise(v_position * 2.0)", "noise(at + 1.0)"

PAIRS = amount(2, 8)

PADDING = 28.0
"""What packing and unpacking a payload of seven channels costs at most, and marking its depth: 25
for a truth and four floats that some fragments lack."""


def test_what_both_passes_need_is_told() -> None:
    analysis = analysed_body(BODY, NOISE)
    once, at = (analysis.shared_work.parts((find(analysis, text, "main"),)) for text in (ONCE, AT))
    assert once.overlap == at.payload > 0.0
    assert once.payload + once.remainder - once.whole == once.overlap
    assert at.overlap == 0.0


@pytest.mark.slow
def test_no_walk_goes_down_a_whole_chain() -> None:
    """There are as many walks as the chain has links."""
    analysis = analysed_body(f"o_color = vec4({' + '.join(['v_uv.x'] * 11_000)});")
    legal = [node for node in analysis.nodes if node.legal]
    assert len(legal) > 20_000
    for node in legal:
        parts = analysis.shared_work.parts((node,))
        assert (parts.payload, parts.overlap) == (node.cost, 0.0)


def test_what_travels_along_is_not_computed_twice() -> None:
    analysis = analysed_body(BODY, NOISE)
    both = analysis.shared_work.parts([find(analysis, text, "main") for text in (ONCE, AT)])
    assert both.overlap == 0.0
    assert both.payload < both.whole


def test_what_saves_most_is_carried_along() -> None:
    analysis = analysed_body(BODY, NOISE)
    once, at = find(analysis, ONCE, "main"), find(analysis, AT, "main")
    (note,) = overlap_notes(analysis, [once])
    assert note.code == "SC423" and at.id in note.message
    assert carrying(analysis, [once]) == (once, at)
    assert carrying(analysis, [at]) == (at,) and not overlap_notes(analysis, [at])
    assert carrying(analysis, [once, at]) == (once, at)


def test_what_does_not_fit_is_not_carried() -> None:
    body = BODY.replace("vec3 at", "mat2 wide = mat2(once(v_position)); vec3 at").replace(
        "float once = noise(at + 1.0);", "mat2 wide = mat2(noise(at + 1.0));"
    )
    body = body.replace("mat2 wide = mat2(once(v_position)); ", "")
    body = body.replace("at * once", "at * wide[0].x").replace(", 1.0);", ", wide[1].y);")
    analysis = analysed_body(body, NOISE)
    wide = find(analysis, "mat2(noise(at + 1.0))", "main")
    carried = carrying(analysis, [wide])
    assert [node.text for node in carried] == [wide.text, AT]  # 4 + 3 channels
    both = carrying(analysis, [*carried])
    assert both == carried


@pytest.mark.parametrize("name", CACHEABLE)
@pytest.mark.slow
def test_no_pass_of_a_set_costs_more_than_is_told(name: str) -> None:
    analysis = analysed(name)
    nodes = list(one_of_each((n for n in analysis.nodes if n.legal), analysis.groups))
    for one, other in zip(
        day_slice(nodes, seed(), PAIRS), day_slice(nodes, seed() + 1, PAIRS), strict=False
    ):
        if can_be_cached(analysis, (one, other)):
            compare(analysis, one, other)


@pytest.mark.parametrize("name", CACHEABLE)
def test_no_pass_costs_more_than_is_told(name: str) -> None:
    analysis = analysed(name)
    for node in day_slice([node for node in analysis.nodes if node.legal], seed(), amount(3, 8)):
        compare(analysis, node)


@pytest.mark.parametrize("scene", ["dragon", "trashcan"])
@pytest.mark.slow
def test_no_pass_of_the_corpus_costs_more_than_is_told(scene: str) -> None:
    path = Path(__file__).parents[2] / "corpus" / scene / f"{scene}.frag"
    analysis = analyse(Source(path.name, path.read_text(encoding="utf-8")))
    for node in day_slice([node for node in analysis.nodes if node.legal], seed(), 12):
        compare(analysis, node)


def can_be_cached(analysis: Analysis, nodes: tuple[Candidate, ...]) -> bool:
    """Do the nodes fit together?"""
    try:
        analysis.require_all(nodes, unprofitable=True)
    except InputError:
        return False
    return True


def compare(analysis: Analysis, *nodes: Candidate) -> None:
    """No pass costs more than the original and its look-ups; one pass also what is done twice."""
    parts, prefix = analysis.shared_work.parts(nodes), analysis.program.prefix
    assert parts.payload <= parts.whole and parts.remainder <= parts.whole
    # What a guard compares is no part of any slice.
    builder = PassBuilder(analysis.program, nodes, configured(guard="off"))
    assert _cost(payload_only(builder), prefix) <= parts.payload + PADDING
    assert _cost(shade(builder), prefix) <= parts.remainder + 2 * FETCH + PADDING
    assert _cost(hit(builder), prefix) <= parts.remainder + PADDING
    assert _cost(miss(builder), prefix) <= parts.whole + PADDING
    # Fetches that one pass moves ahead compute where to look once more.
    if unfit(builder, algorithm("1-pass")) is None and not builder.fetches:
        assert _cost(shade_or_reuse(builder), prefix) <= parts.whole + parts.overlap + PADDING


def _cost(shader: Shader, prefix: str) -> float:
    """The static cost of an emitted shader, the look-up in the cache of the last frame apart."""
    text = print_module(with_precisions(shader.module, Memo()))
    module = parse(Source("pass.frag", text))
    costs = CostTable(validate(module, Source("pass.frag", text), "fragment"))
    functions = {item.name: item for item in module.decls if isinstance(item, n.FunctionDef)}
    look_up = functions.get(f"{prefix}look_up")
    return costs.function(functions["main"]) - (costs.function(look_up) if look_up else 0.0)


def test_the_static_ratio_of_a_set_is_that_of_its_payload_pass() -> None:
    analysis = analysed_body(BODY, NOISE)
    once, at = find(analysis, ONCE, "main"), find(analysis, AT, "main")
    assert analysis.static_ratio((once,)) == once.ratio
    both = analysis.static_ratio((once, at))
    assert both == analysis.shared_work.parts((once, at)).payload / analysis.shared_work.whole
    assert 0.9 * max(once.ratio, at.ratio) < both <= 1.0

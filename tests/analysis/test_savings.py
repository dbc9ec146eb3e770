"""What caching a value would save, and which values are worth telling apart."""

from __future__ import annotations

import pytest
from shaders import analysed, find

from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.costs.savings import LOOK_UP, SECOND_TEXEL, look_up_cost
from shadercache.caching.configuration import Configuration
from shadercache.compiler import rewrite
from shadercache.source import Source
from shadercache.valid.read import read

FUNCTIONS = """
float wave(vec3 p) { return sin(p.x) * cos(p.y) * sin(p.z * 3.0) * exp(p.x) * pow(p.y, p.z); }
"""
BODY = """
vec3 n = normalize(v_normal);
float a = wave(v_position + n);
vec4 b = vec4(wave(v_position.zyx), a, 0.0, 1.0);
o_color = b * dot(n, v_position);
"""


@pytest.mark.parametrize(
    ("text", "cost"),
    [("a", LOOK_UP), ("vec4(wave(v_position.zyx), a, 0.0, 1.0)", LOOK_UP + SECOND_TEXEL)],
)
def test_a_look_up_costs_what_its_code_costs(text: str, cost: float) -> None:
    """By the same static costs, counted in the program that shades hits."""
    analysis = analysed(BODY, FUNCTIONS)
    node = find(analysis, text)
    emitted = rewrite(analysis, [Configuration((node.id,), "2-pass")]).files["2-pass.hit.frag"]
    module, facts = read(Source("hit.frag", emitted))
    main = next(part for part in module.decls if getattr(part, "name", "") == "main")
    whole = CostTable(facts).of(main)
    look_up = whole - analysis.shared_work.parts((node,)).remainder
    assert look_up_cost(node.type.components_or_one) == cost
    assert look_up == pytest.approx(cost, rel=0.03)


def test_what_shading_computes_again_is_not_saved() -> None:
    analysis = analysed(BODY, FUNCTIONS)
    node, work = find(analysis, "wave(v_position + n)"), analysis.shared_work
    saving, parts = analysis.savings.of(node), work.parts((node,))
    assert saving.share * work.whole == pytest.approx(node.cost - parts.overlap - LOOK_UP)
    assert saving.twice * work.whole == pytest.approx(parts.overlap) and parts.overlap > 0.0
    assert saving.equal == 3, "the call, what it returns, the one read of 'a'"


def test_one_of_each_value_is_ranked() -> None:
    analysis = analysed(BODY, FUNCTIONS)
    ranked = [saving.node for saving in analysis.savings.ranked()]
    assert len({analysis.groups[node] for node in ranked}) == len(ranked)
    assert {analysis.groups[node] for node in ranked} == {
        analysis.groups[node] for node in analysis.nodes if node.offered
    }


def test_what_changes_with_less_is_told_beside_what_is_alike() -> None:
    analysis = analysed("o_color = vec4(wave(v_position) * u_time + u_time);", FUNCTIONS)
    ranked = analysis.savings.ranked()
    told = analysis.savings.telling(ranked, lambda node: node.inputs & {"u_time"}, 10)
    assert [one.node.text for one in told][:2] == [
        "wave(v_position) * u_time + u_time",
        "wave(v_position)",
    ]
    told = analysis.savings.telling(ranked, lambda node: frozenset(), 10)
    assert "wave(v_position)" not in [one.node.text for one in told]
    assert len(analysis.savings.telling(ranked, lambda node: node.inputs, 1)) == 1

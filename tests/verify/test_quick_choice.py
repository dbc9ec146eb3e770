"""Which values a quick verification checks."""

from __future__ import annotations

from shaders import analysed

from shadercache.analysis.value_numbering import one_of_each
from shadercache.verify.quick_choice import quick_choice

FUNCTIONS = """
float wave(vec3 p) { return sin(p.x) * cos(p.y) * sin(p.z * 3.0) * exp(p.x) * pow(p.y, p.z); }
"""
BODY = """
float sum = 0.0;
sum += wave(v_position * 0.5) + wave(v_position * 1.5) + wave(v_position * 2.5);
sum += wave(v_position * 3.5) + wave(v_position * 4.5) + wave(v_position * 5.5);
bool high = exp(sin(v_position.x) * cos(v_position.y)) > 1.0;
if (high) { sum += wave(v_normal); }
o_color = vec4(vec3(sum, wave(v_normal * 2.0), 0.0) * exp(v_normal), 1.0);
"""


def test_every_type_and_place_is_among_them_and_the_dearest() -> None:
    analysis = analysed(BODY, FUNCTIONS)
    nodes = list(one_of_each((n for n in analysis.nodes if n.offered), analysis.groups))
    chosen = quick_choice(analysis.savings, nodes, 12)
    assert len(chosen) == 12 < len(nodes)
    assert chosen == [node for node in nodes if node in chosen], "in their order"
    assert {node.type.name for node in chosen} == {node.type.name for node in nodes}
    assert any(node.unsure for node in chosen)
    assert any(node.instance and node.instance.parent for node in chosen)
    dearest = max(nodes, key=lambda node: analysis.savings.of(node).share)
    assert dearest in chosen


def test_of_few_all_are_taken() -> None:
    analysis = analysed(BODY, FUNCTIONS)
    nodes = [node for node in analysis.nodes if node.offered]
    assert quick_choice(analysis.savings, nodes, len(nodes)) == nodes
    assert len(quick_choice(analysis.savings, nodes, 3)) == 3

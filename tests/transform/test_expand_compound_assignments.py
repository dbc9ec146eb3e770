"""Compound assignments, spelled out for the analysis: which nodes there are."""

from __future__ import annotations

from tests.shaders import analysed, find

DECLARATIONS = """
struct Sum { vec3 light; float parts[3]; };
float wave(float x) { return sin(x) * cos(x + 1.0) * sin(x * 2.0); }
float writes(out float x) { x = 1.0; return 0.5; }
int cheap() { return 1; }
float g;
float changes_g() { g = 2.0; return 1.0; }
"""


def test_partial_sums_are_nodes() -> None:
    analysis = analysed(
        """
    float c = wave(v_position.x);
    c += wave(v_position.y);
    c += wave(v_position.z);
    o_color = vec4(c, wave(v_position.x) + wave(v_position.y), 0.0, 1.0);
    """,
        DECLARATIONS,
    )
    first, second = (find(analysis, f"c += wave(v_position.{x})") for x in "yz")
    assert first.offered and second.offered
    assert 1.9 < second.cost / find(analysis, "wave(v_position.x)").cost < 3.5
    same = find(analysis, "wave(v_position.x) + wave(v_position.y)")
    assert analysis.groups[first] is analysis.groups[same]
    assert analysis.groups[second] is not analysis.groups[same]


def test_numbers_in_ids_are_those_of_the_users_expressions() -> None:
    analysis = analysed(
        "v_sum.x += wave(2.0); o_color = v_sum * wave(v_uv.x);", "vec4 v_sum;" + DECLARATIONS
    )
    main = [node for node in analysis.nodes if node.path == "main"]
    numbers = [int(node.id.partition(".")[2].partition("-")[0]) for node in main]
    assert numbers == list(range(len(main)))
    assert [node.text for node in main[:4]] == [
        "v_sum.x += wave(2.0)",
        "v_sum.x",
        "v_sum",
        "wave(2.0)",
    ]

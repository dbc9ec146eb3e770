"""Names of nodes: ids, texts, places, and sets of these."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import Severity, UsageError
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

TEXT = """#version 330
in vec3 v_position;
uniform float u_time;
out vec4 o_color;
float wave(vec3 p) { return sin(p.x) * cos(p.y) * sin(p.z * 3.0); }
void main() {
    float a = wave(v_position) + wave(v_position.zyx);
    float b = wave(v_position) * 2.0, c = exp(sin(v_position.x + u_time)) * cos(v_position.y);
    float d = a
        + b; // of two lines
    for (int i = 0; i < 3; i++) d += 1.0;
    o_color = vec4(sqrt(d), c, a + b, wave(v_position + /* some */ 1.0));
}
"""


@pytest.fixture(scope="module")
def shader() -> Analysis:
    return analyse(Source("x.frag", TEXT))


def told(error: UsageError) -> str:
    return error.diagnostics[0].render()


def texts(nodes: tuple[Candidate, ...]) -> list[str]:
    return [node.text for node in nodes]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("wave(v_position)", "wave(v_position)"),
        ("wave( v_position\n)", "wave(v_position)"),
        ("wave(v_position+1.0)", "wave(v_position + /* some */ 1.0)"),
        ("wave(v_position /* here */ + 1.0)", "wave(v_position + /* some */ 1.0)"),
        (":7", "wave(v_position) + wave(v_position.zyx)"),
        (":7:34", "wave(v_position.zyx)"),
        (":7:36", "wave(v_position.zyx)"),
        (":8:15", "wave(v_position) * 2.0"),
        (":9", "a + b"),
        ("a + b", "a + b"),
        ("a+b", "a + b"),
    ],
)
def test_one_node(shader: Analysis, name: str, text: str) -> None:
    [node] = shader.nodes_of(name)
    assert node.text == text and node.offered
    assert shader.nodes_of(node.id) == (node,)


def test_equal_values_are_one_and_the_first_is_meant(shader: Analysis) -> None:
    same = [node for node in shader.nodes if node.text == "wave(v_position)"]
    assert len(same) == 2 and shader.groups[same[0]] is shader.groups[same[1]]
    assert shader.nodes_of("wave(v_position)") == (same[0],)


@pytest.mark.parametrize(
    ("names", "found"),
    [
        ("wave(v_position)+c", ["wave(v_position)", "c"]),
        (
            "wave(v_position + 1.0) + :8:43",
            [
                "wave(v_position + /* some */ 1.0)",
                "exp(sin(v_position.x + u_time)) * cos(v_position.y)",
            ],
        ),
        ("a + b + c", ["a + b", "c"]),
        ("c+a+b", ["c", "a + b"]),
        ("both+c", ["wave(v_position)", "a + b", "c"]),
        ("sum+c", ["wave(v_position) + wave(v_position.zyx)", "c"]),
    ],
)
def test_sets(shader: Analysis, names: str, found: list[str]) -> None:
    named = {"both": "wave(v_position)+a + b", "sum": ":7"}
    assert texts(shader.nodes_of(names, named)) == found


def test_a_line_of_two_values_lists_them(shader: Analysis) -> None:
    with pytest.raises(UsageError) as caught:
        shader.node(":8")
    first, *others = caught.value.diagnostics
    assert first.code == "SC012" and "':8' means 2 different values of x.frag" in first.message
    assert {note.severity for note in others} == {Severity.NOTE}
    places = [note.render().splitlines()[0] for note in others]
    assert [place.split(": ")[0] for place in places] == ["x.frag:8:15", "x.frag:8:43"]
    ids = [shader.node(where).id for where in (":8:15", ":8:43")]
    assert all(
        node in place and "path main" in place for node, place in zip(ids, places, strict=True)
    )


def test_a_text_on_several_paths_lists_them(shader: Analysis) -> None:
    with pytest.raises(UsageError) as caught:
        shader.node("sin(p.x)")
    first, *others = caught.value.diagnostics
    assert "means 3 different values" in first.message and len(others) == 3
    assert "main > wave@1" in others[0].message


def test_what_is_refused_is_found_to_be_told_why(shader: Analysis) -> None:
    node = shader.node(":11:33")
    assert not node.legal and node.text == "d += 1.0"


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("wav(v_position)", "did you mean 'wave(v_position)'"),
        ("wave(v_position", "did you mean 'wave(v_position)'"),
        ("albedos", "did you mean 'albedo'"),
        ("nothing at all", "'shadercache nodes x.frag --all' lists the nodes"),
        (":2", "no value at ':2'"),
        (":2", "the nearest lines with some are 5, 7, 8"),
        (":999999999999999999999:1", "no value at"),
        (":0", "no value at"),
        (":", "no node ':'"),
        ("", "no node ''"),
        ("+", "lacks an id beside a '+'"),
        ("c+", "lacks an id beside a '+'"),
        ("c+wave(x+y)", "no node 'wave(x+y)'"),
        ("c+)", "no node ')'"),
        ("main.99-12", "no node 'main.99-12'"),
    ],
)
def test_what_is_not_there(shader: Analysis, name: str, said: str) -> None:
    with pytest.raises(UsageError) as caught:
        shader.nodes_of(name, {"albedo": ":7"})
    assert said in told(caught.value)


def test_lines_are_those_of_the_shader_itself(tmp_path: Path) -> None:
    (tmp_path / "far.glsl").write_text(
        "\n\nfloat far(vec3 p) { return sin(p.x) * cos(p.y) * exp(p.z); }\n"
    )
    text = TEXT.replace("float wave", '#include "far.glsl"\nfloat wave', 1).replace(
        "sqrt(d)", "far(v_position)"
    )
    reading = ReadOptions(include_folders=(tmp_path,))
    analysis = analyse(Source("x.frag", text), None, reading)
    with pytest.raises(UsageError, match="no value at ':3'"):
        analysis.node(":3")
    assert analysis.node("far(v_position)").offered

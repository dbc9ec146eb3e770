"""``shadercache nodes`` in one look: the values that save most, and what to do next."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from shadercache.paths import data_path

from .conftest import SHADERS, Shell

MIXED = SHADERS / "mixed.frag"
DRAGON = data_path("corpus", "dragon", "dragon.frag")
PAIR = DRAGON, "--vert", DRAGON.with_suffix(".vert")


def values(told: str) -> list[list[str]]:
    """The lines of each value."""
    return [block.splitlines() for block in told.rstrip().split("\n\n")[1:-1]]


def underlined(value: list[str]) -> str:
    """The text that the caret and its tildes stand under."""
    line, marks = value[1:3]
    return line[marks.index("^") : len(marks)]


def test_at_most_ten_values_each_with_its_line_underlined(shell: Shell) -> None:
    outcome = shell("nodes", *PAIR)
    assert (outcome.status, outcome.err) == (0, "")
    told = values(outcome.out)
    assert len(told) == 10
    assert "marble(v_position)" in map(underlined, told)
    for value in told:
        assert re.match(r"\S+dragon\.frag:\d+:\d+( to \d+:\d+)?: saves \d+%", value[0])


def test_what_saves_most_comes_first(shell: Shell) -> None:
    shares = [int(share) for share in re.findall(r": saves (\d+)%", shell("nodes", *PAIR).out)]
    assert shares == sorted(shares, reverse=True)


def test_of_alike_values_one_is_shown(shell: Shell) -> None:
    """Of the ten values around 'light' one; 'marble' as well, for it changes with less."""
    texts = [underlined(value) for value in values(shell("nodes", *PAIR, "--scene", "dragon").out)]
    assert texts[:3] == [
        "sqrt(1.0 - exp2(-2.0 * light))",
        "albedo * (sky + lamps)",
        "marble(v_position)",
    ]


def test_what_changes_a_value_by_the_scene(shell: Shell) -> None:
    first, second, third, *_ = values(shell("nodes", *PAIR, "--scene", "dragon").out)
    assert first[3].split(" and ") == [
        "        view: changes with the light (u_light)",
        "the view (u_eye, u_model)",
    ]
    assert second[3].endswith("the light (u_light) and the view (u_model)"), "through v_normal"
    assert third[3] == "        surface: stays the same on the surface (v_position)"


def test_what_a_value_depends_on_through_the_vertex_shader(shell: Shell) -> None:
    lone = next(value for value in values(shell("nodes", DRAGON).out) if "albedo *" in value[1])
    assert lone[3].startswith(
        "        surface: depends on varyings v_normal, v_position; uniforms u_light;"
    )
    pair = next(value for value in values(shell("nodes", *PAIR).out) if "albedo *" in value[1])
    assert pair[3].endswith("; in the vertex shader u_model")


def test_one_sentence_counts_and_says_what_is_next(shell: Shell, tmp_path: Path) -> None:
    last = shell("nodes", *PAIR, "--scene", "dragon").out.splitlines()[-1]
    listed = shell("nodes", *PAIR, "--json").nodes
    offered = [node for node in listed if node["offered"]]
    groups = {node["group"] for node in offered}
    assert last.startswith(
        f"{len(offered)} nodes of {len(groups)} different values are offered, "
        f"{len(listed) - len(offered)} are refused (--all lists them); next: shadercache rewrite "
    )
    words = last.partition("next: shadercache ")[2].split()
    marble = next(node["id"] for node in listed if node["text"] == "marble(v_position)")
    assert words[words.index("--node") + 1] == marble, "the one that changes with least"
    words[words.index("out")] = str(tmp_path / "out")
    assert shell(*words).status == 0


def test_how_a_shader_is_read_is_in_what_is_next(shell: Shell) -> None:
    last = shell("nodes", MIXED, "-D", "A=1", "--unroll").out.splitlines()[-1]
    assert f"rewrite {MIXED} -D A=1 --unroll --node " in last


def test_values_of_equal_cost_that_share_nothing_are_both_shown(shell: Shell) -> None:
    texts = [underlined(value) for value in values(shell("nodes", MIXED).out)]
    assert texts[0] == "vec3(veins, drift, veins * drift) * lit"
    assert {"wave(v_position, 0.0)", "wave(v_position, u_time)"} <= set(texts)


def test_where_no_look_up_pays_three_are_shown(shell: Shell, fragment: Path) -> None:
    told = shell("nodes", fragment).out
    assert [value[0].split(": ")[1] for value in values(told)] == [
        "a look-up costs more than it"
    ] * 3
    assert "by static costs none is worth a look-up; to measure one all the same: " in told


def test_where_nothing_is_offered_the_commonest_reasons_are_told(shell: Shell) -> None:
    text = b"""#version 330
uniform float u_time;
out vec4 o_color;
void main() { o_color = vec4(sin(u_time), 1.0, 2.0, cos(u_time)); }
"""
    outcome = shell("nodes", "-", "--mapping", "surface", stdin=text)
    assert outcome.status == 0
    assert outcome.out.startswith(
        "None of the 9 nodes may be cached (mapping: surface): 5 for SC303:"
    )
    assert "2 for SC302: a value is a constant; the driver folds it" in outcome.out
    assert outcome.out.count("\n") == 1


def test_a_shader_without_values(shell: Shell) -> None:
    text = b"#version 330\nin vec3 v;\nout vec4 o_color;\nvoid main() {}\n"
    assert "There is nothing to cache" in shell("nodes", "-", stdin=text).out


@pytest.mark.parametrize("options", [("--all",), ("--offered",), ("--sort", "ratio")])
def test_tables_are_printed_on_request(shell: Shell, fragment: Path, options: list[str]) -> None:
    told = shell("nodes", fragment, *options).out
    assert told.startswith("id ") and "mapping: surface" in told
    count = len(shell("nodes", fragment, *options, "--json").nodes)
    assert len(told.split("\n\n")[0].splitlines()) == count + 1

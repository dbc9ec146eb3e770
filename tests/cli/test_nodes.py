"""``shadercache nodes``: table, JSON, and shaders that cannot be read."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from shadercache.cli.list_nodes import HEADER
from shadercache.paths import data_path

from .conftest import Shell


def test_the_table_has_a_line_for_every_node(shell: Shell, fragment: Path) -> None:
    table = shell("nodes", fragment, "--all").out.split("\n\n")[0].splitlines()
    listed = shell("nodes", fragment, "--json").nodes
    assert table[0].split() == list(HEADER)
    assert [line.split()[0] for line in table[1:]] == [node["id"] for node in listed]


def test_a_node_is_told_in_full(shell: Shell, fragment: Path, rings: str) -> None:
    nodes = {node["id"]: node for node in shell("nodes", fragment, "--json").nodes}
    node = nodes[rings]
    assert node["type"] == "float"
    assert node["offered"] and node["refusal"] is None
    assert node["inputs"] == ["u_wood", "v_position"]
    assert 0.0 < node["ratio"] < 1.0
    line = fragment.read_text().splitlines()[node["line"] - 1]
    assert line[node["column"] - 1 : node["end_column"] - 1] == node["text"]


def test_every_node_is_offered_or_refused_with_a_reason(shell: Shell, fragment: Path) -> None:
    for node in shell("nodes", fragment, "--json").nodes:
        assert node["offered"] == (node["refusal"] is None)
        if node["refusal"]:
            assert node["refusal"]["code"].startswith("SC3")
            assert node["refusal"]["sentence"]


def test_offered_leaves_out_the_rest(shell: Shell, fragment: Path) -> None:
    nodes = shell("nodes", fragment, "--offered", "--json").nodes
    assert nodes and all(node["offered"] for node in nodes)


def test_sorted_by_ratio(shell: Shell, fragment: Path) -> None:
    ratios = [n["ratio"] for n in shell("nodes", fragment, "--sort=ratio", "--json").nodes]
    assert ratios == sorted(ratios)


def test_the_summary_counts_and_explains_the_codes(shell: Shell, fragment: Path) -> None:
    summary = shell("nodes", fragment, "--all").out.split("\n\n")[1].splitlines()
    count, offered = (int(summary[0].split()[i]) for i in (0, 2))
    assert count == offered + sum(int(line.split()[0]) for line in summary[1:])
    assert any("SC302: is a constant" in line for line in summary)


def test_stdin(shell: Shell, fragment: Path) -> None:
    outcome = shell("nodes", "-", "--all", stdin=fragment.read_bytes())
    assert outcome.out == shell("nodes", fragment, "--all").out
    told = shell("nodes", "-", stdin=fragment.read_bytes()).out
    assert "<stdin>:20:20: " in told and "shadercache rewrite - --node" in told


def test_a_byte_order_mark_and_dos_lines_are_welcome(shell: Shell, fragment: Path) -> None:
    dos = b"\xef\xbb\xbf" + fragment.read_bytes().replace(b"\n", b"\r\n")
    outcome = shell("nodes", "-", stdin=dos)
    assert (outcome.status, outcome.err) == (0, "")


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("missing.frag", "No such file or directory"),
        (".", "Is a directory"),
        ("", "Is a directory"),
        ("/dev/null/x", "Not a directory"),
        ("nu\0ll", "embedded null byte"),
    ],
)
def test_a_file_that_cannot_be_read(shell: Shell, name: str, reason: str) -> None:
    outcome = shell("nodes", name)
    assert (outcome.status, outcome.out) == (1, "")
    assert outcome.err == f"error: cannot read {name}: {reason} [SC001]\n"


def test_text_in_another_encoding(shell: Shell, tmp_path: Path) -> None:
    shader = tmp_path / "latin.frag"
    shader.write_bytes("#version 330\n// für\nvoid main() {}\n".encode("latin-1"))
    outcome = shell("nodes", shader)
    assert outcome.status == 1
    assert f"{shader}:2:5: error: not UTF-8 text" in outcome.err
    assert "(byte 0xfc) [SC001]" in outcome.err


def test_a_syntax_error_has_a_place_and_a_caret(shell: Shell) -> None:
    outcome = shell("nodes", "-", stdin=b"#version 330\nvoid main() { float x = ; }\n")
    assert outcome.status == 1
    assert outcome.err.startswith("<stdin>:2:25: error: ")
    assert "[SC1" in outcome.err
    assert "\n      |                         ^" in outcome.err


def test_type_errors_are_told_all_at_once(shell: Shell) -> None:
    text = b"#version 330\nout vec4 c;\nvoid main() { float x = y; c = z; }\n"
    outcome = shell("nodes", "-", "--diagnostics=json", stdin=text)
    assert outcome.status == 1
    assert outcome.err.count('"code": "SC2') == 2


@pytest.mark.parametrize("text", [b"", b"\0\0\0", b"#version 330\n", b"void", b"\xff" * 9])
def test_nonsense_is_rejected_without_a_traceback(shell: Shell, text: bytes) -> None:
    outcome = shell("nodes", "-", stdin=text)
    assert outcome.status == 1
    assert "error: " in outcome.err and "Traceback" not in outcome.err


def test_what_a_node_depends_on_by_kind(shell: Shell, fragment: Path, rings: str) -> None:
    nodes = shell("nodes", fragment, "--json").nodes
    node = next(node for node in nodes if node["id"] == rings)
    assert node["depends_on"] == {"varyings": ["v_position"], "textures": ["u_wood"]}
    assert "changes_with" not in node


def test_what_changes_with_the_light(shell: Shell) -> None:
    dragon = data_path("corpus", "dragon")
    outcome = shell("nodes", dragon / "dragon.frag", "--scene", "dragon", "--json")
    found = {json.dumps(node["changes_with"]) for node in outcome.nodes}
    assert {"{}", '{"light": ["u_light"]}', '{"view": ["u_eye"], "light": ["u_light"]}'} <= found
    table = shell("nodes", dragon / "dragon.frag", "--scene", "dragon", "--all").out
    assert "changes with" in table.splitlines()[0] and "light: u_light" in table


def test_groups_name_the_node_that_stands_for_them(shell: Shell, fragment: Path) -> None:
    nodes = {node["id"]: node for node in shell("nodes", fragment, "--json").nodes}
    assert all(nodes[node["group"]]["group"] == node["group"] for node in nodes.values())
    assert len({node["group"] for node in nodes.values()}) < len(nodes)
    for node in nodes.values():
        assert nodes[node["group"]]["offered"] or not node["offered"]


def test_only_values_of_uniforms_have_a_text_for_the_cpu(shell: Shell, fragment: Path) -> None:
    nodes = shell("nodes", fragment, "--json").nodes
    told = {node["refusal"]["code"] for node in nodes if node["on_cpu"] is not None}
    assert told <= {"SC303"}


LOOPS = """#version 330
in vec2 v_uv;
out vec4 o_color;
float wave(float x) { return sin(x) * cos(x + 1.0) * sin(x * 2.0); }
void main() {
    float sum = 0.0;
    for (int i = 0; i < 3; i++) sum += wave(v_uv.x + float(i));
    for (int i = 0; i < 3; i++) { if (sum > 2.0) break; sum *= 1.1; }
    o_color = vec4(sum);
}
"""


def test_loops_are_unrolled_on_request(shell: Shell) -> None:
    plain = shell("nodes", "-", "--json", stdin=LOOPS.encode())
    assert plain.err == ""
    sums = [node for node in plain.nodes if node["text"].startswith("sum +=")]
    assert [node["refusal"]["code"] for node in sums] == ["SC301"]
    outcome = shell("nodes", "-", "--unroll", "--json", stdin=LOOPS.encode())
    sums = [node for node in outcome.nodes if node["text"].startswith("sum +=")]
    assert [node["path"] for node in sums] == ["main [i=0]", "main [i=1]", "main [i=2]"]
    assert all(node["offered"] for node in sums)
    assert "8:5: note: this loop is not unrolled: there is a break" in outcome.err


SCREEN = """#version 330
in vec3 v_position;
out vec4 o_color;
float wave(vec3 p) { return sin(p.x * 3.1) * cos(p.y * 2.3) + pow(abs(p.z), 1.3); }
void main() { o_color = vec4(wave(dFdx(v_position)), wave(v_position), 0.0, 1.0); }
"""


def test_values_of_the_screen_are_offered_on_request(shell: Shell) -> None:
    plain = shell("nodes", "-", stdin=SCREEN.encode()).out
    assert "as values of the screen, which --approximate may offer); " in plain
    nodes = {n["text"]: n for n in shell("nodes", "-", "--json", stdin=SCREEN.encode()).nodes}
    faced, still = nodes["wave(dFdx(v_position))"], nodes["wave(v_position)"]
    assert (faced["class"], still["class"]) == ("screen", "surface")
    assert faced["refusal"]["code"] == "SC312" and still["offered"]
    asked = shell("nodes", "-", "--approximate", stdin=SCREEN.encode()).out
    assert "        screen (exact at rest): depends on " in asked
    assert "--approximate --node " in asked.splitlines()[-1]
    table = shell("nodes", "-", "--approximate", "--all", stdin=SCREEN.encode()).out
    row = next(line for line in table.splitlines() if line.endswith("wave(dFdx(v_position))"))
    assert "  offered  screen " in row

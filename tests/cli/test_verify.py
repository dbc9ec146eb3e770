"""``shadercache verify``: one node of each value, or every node where that is asked for."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from shadercache.verify.quick_choice import MOST

from .conftest import Shell

pytestmark = pytest.mark.xdist_group("gl")

FRAGMENT = """#version 330
in vec3 v_position;
out vec4 f_color;
float wave(vec3 p) { return sin(p.x * 3.1) * cos(p.y * 2.3) + pow(abs(p.z), 1.3); }
void main() {
    float a = wave(v_position);
    float b = (wave(v_position));
    f_color = vec4(a, a * b, b, 1.0);
}
"""
VERTEX = """#version 330
in vec3 a_position;
uniform mat4 u_mvp;
out vec3 v_position;
void main() {
    v_position = a_position;
    gl_Position = u_mvp * vec4(a_position, 1.0);
}
"""
SCENE = """
name = "square"
fragment = "square.frag"
vertex = "square.vert"
mesh = "square.npz"
[attributes]
a_position = "position"
[camera]
eye = [0.0, 0.0, 3.0]
fov_degrees = 45.0
near = 1.0
far = 10.0
[motion]
axis = [0.0, 1.0, 0.0]
degrees_per_frame = 1.0
[uniforms]
u_mvp = "model-view-projection"
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """A square that turns."""
    corners = np.array([(-1, -1, 0.1), (1, -1, 0.2), (1, 1, 0.3), (-1, 1, 0.4)], np.float32)
    index = np.array([(0, 1, 2), (0, 2, 3)], np.uint32)
    np.savez(tmp_path / "square.npz", position=corners, index=index)
    (tmp_path / "square.frag").write_text(FRAGMENT)
    (tmp_path / "square.vert").write_text(VERTEX)
    path = tmp_path / "square.toml"
    path.write_text(SCENE)
    return path


def test_one_node_of_each_value_is_checked(shell: Shell, scene: Path, tmp_path: Path) -> None:
    output = tmp_path / "verdicts.json"
    done = shell("verify", scene, "-j", 1, "-o", output)
    assert done.status == 0, done.err
    report = json.loads(output.read_text())
    assert report["equal_to_checked"] >= 3
    assert f"{report['equal_to_checked']} more nodes have the value of one of these" in done.out
    assert "plain mode changes bits for" in done.out
    texts = [node["text"] for node in report["nodes"]]
    assert len(texts) == report["checked"]
    assert texts.count("wave(v_position)") == 1


def test_the_algorithms_that_are_named(shell: Shell, scene: Path, tmp_path: Path) -> None:
    output = tmp_path / "verdicts.json"
    asked = ("--passes", "2,parked", "--proof-only", "--unprofitable")
    done = shell("verify", scene, "-j", 1, *asked, "-o", output)
    assert done.status == 0, done.err
    nodes = json.loads(output.read_text())["nodes"]
    assert {name for node in nodes for name in node["always"]} == {"2-pass", "parked"}
    assert shell("verify", scene, "--passes", "4").status == 2


def test_what_was_not_measured_is_not_told(shell: Shell, scene: Path) -> None:
    done = shell("verify", scene, "-j", 1, "--proof-only")
    assert done.status == 0, done.err
    assert "laws 2-4" in done.out
    assert "plain mode changes" not in done.out


def test_every_node_is_checked_where_that_is_asked_for(shell: Shell, scene: Path) -> None:
    done = shell("verify", scene, "-j", 1, "--every-node", "--proof-only", "--json")
    assert done.status == 0, done.err
    report = done.json
    assert report["equal_to_checked"] == 0
    assert [node["text"] for node in report["nodes"]].count("wave(v_position)") == 2


def test_ages_are_told_where_they_are_kept(shell: Shell, scene: Path) -> None:
    outcome = shell("verify", scene, "--proof-only", "--cache", "age=on")
    assert outcome.status == 0, outcome.err
    assert "law 7: the oldest payload was" in outcome.out
    assert "law 7" not in shell("verify", scene, "--proof-only").out


def test_a_verdict_names_what_is_not_finite(shell: Shell) -> None:
    reports = Path(__file__).parent.parent / "reports" / "not_finite"
    path = reports / "o20_not_finite_but_absorbed.frag"
    how = ("--mapping", "screen", "--proof-only", "-j", 1)
    told = shell("verify", path, *how, "--cache", "guard=clamp")
    assert told.status == 1
    found = ": the payload is NaN in 4,608 of 9,216 pixels, the first of them at (48, 0)"
    assert f"{found}; guard=clamp" in told.out
    right = shell("verify", path, *how)
    assert right.status == 0, right.out
    assert f"{found}\n" in right.out, "also where it does no harm"


MANY = """#version 330
uniform vec2 u_resolution;
uniform float u_time;
out vec4 o_color;
float wave(vec2 p) { return exp(sin(p.x * 3.1)) * cos(p.y * 2.3) + pow(abs(p.x), 1.3); }
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float sum = 0.0;
SUMS
    if (p.x > 0.5) sum += wave(p.yx * 7.0);
    vec3 tint = vec3(wave(p), wave(p * 3.5), sum);
    o_color = vec4(tint * wave(p + 2.5), pow(p.x - 0.75, 2.0));
}
"""


@pytest.fixture
def many(tmp_path: Path) -> Path:
    """A shader of more values than a quick verification checks."""
    sums = "\n".join(f"    sum += wave(p * {number}.5);" for number in range(12))
    path = tmp_path / "many.frag"
    path.write_text(MANY.replace("SUMS", sums))
    return path


def test_a_quick_verification_says_what_it_leaves_out(shell: Shell, many: Path) -> None:
    how = ("verify", many, "--mapping", "screen", "--passes", "1", "--proof-only", "-j", 1)
    done = shell(*how)
    assert done.status == 0, done.err
    line = next(line for line in done.out.splitlines() if "not checked" in line)
    assert line.endswith(
        "more values are not checked: these are the dearest, and one of each type and kind of "
        "place (--all checks all)"
    )
    offered = [node for node in shell("nodes", many, "--json").nodes if node["offered"]]
    values = {node["group"] for node in offered}
    report = shell(*how, "--json").json
    assert report["checked"] == MOST and report["left_out"] == len(values) - MOST
    assert int(line.split()[0]) == report["left_out"]
    texts = {node["text"] for node in report["nodes"]}
    assert {"sum += wave(p.yx * 7.0)", "tint * wave(p + 2.5)"} <= texts, "a branch, a vec3"


def test_a_shader_without_a_value_to_check_is_told_so(shell: Shell, tmp_path: Path) -> None:
    path = tmp_path / "plain.frag"
    path.write_text("#version 330\nout vec4 o_color;\nvoid main() { o_color = vec4(0.5); }\n")
    done = shell("verify", path, "--mapping", "screen")
    assert done.status == 0 and "no value is offered, so laws 2-4 say nothing" in done.out


@pytest.mark.parametrize("option", ["--all", "--every-node"])
def test_everything_is_checked_on_request(shell: Shell, many: Path, option: str) -> None:
    how = ("--mapping", "screen", "--passes", "1", "--proof-only", "-j", 1, "--json")
    report = shell("verify", many, option, *how).json
    offered = [node for node in shell("nodes", many, "--json").nodes if node["offered"]]
    assert report["left_out"] == 0
    assert report["checked"] + report["equal_to_checked"] == len(offered)


def test_the_pixel_of_what_is_not_finite_is_told(shell: Shell, tmp_path: Path) -> None:
    path = tmp_path / "odd.frag"
    path.write_text(
        "#version 330\nuniform vec2 u_resolution;\nout vec4 o_color;\nvoid main() {\n"
        "    vec2 p = gl_FragCoord.xy;\n"
        "    float odd = p == vec2(7.5, 3.5) ? sqrt(-p.x) : pow(p.x, 0.3) * exp2(p.y);\n"
        "    o_color = vec4(min(odd, 1.0), 0.0, 0.0, 1.0);\n}\n"
    )
    done = shell("verify", path, "--mapping", "screen", "--node", ":6", "--proof-only", "-j", 1)
    assert done.status == 0, done.out
    assert ": the payload is NaN in 1 of 9,216 pixels, the first of them at (7, 3)" in done.out


def test_of_values_of_the_screen_the_laws_and_the_error_are_told(
    shell: Shell, scene: Path, tmp_path: Path
) -> None:
    text = FRAGMENT.replace(
        "float b = (wave(v_position))", "float b = wave(dFdx(v_position) * 9.0)"
    )
    (tmp_path / "square.frag").write_text(text)
    asked = ("--node", "wave(dFdx(v_position) * 9.0)", "--proof-only", "-j", 1)
    assert shell("verify", scene, *asked).status == 1
    done = shell("verify", scene, *asked, "--approximate")
    assert done.status == 0, done.out
    told = "1 of them are values of the screen: laws 2-4 are judged for these as for all others"
    assert told in done.out
    assert "no law bounds how far their reuse is off in motion: here, at a period of 4" in done.out
    (node,) = shell("verify", scene, *asked, "--approximate", "--json").json["nodes"]
    assert node["approximate"] and set(node["moving"]) == {"1-pass", "2-pass", "3-pass"}
    assert "values of the screen" not in shell("verify", scene, "--proof-only", "-j", 1).out

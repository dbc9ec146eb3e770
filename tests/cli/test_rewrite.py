"""``shadercache rewrite``: what it writes, and what it refuses."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from shaders import analysed

from shadercache.analysis import node_ids

from .conftest import Shell


def listing(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_all_variants_with_their_manifest(
    shell: Shell, fragment: Path, rings: str, tmp_path: Path
) -> None:
    out = tmp_path / "new" / "out"
    outcome = shell("rewrite", fragment, "--node", rings, "-o", out)
    assert (outcome.status, outcome.err) == (0, "")
    manifest = json.loads((out / "manifest.json").read_text())
    assert [item["algorithm"] for item in manifest["variants"]] == ["1-pass", "2-pass", "3-pass"]
    drawn = [manifest["original"], manifest["payload"], manifest["debug"]]
    drawn += [item for variant in manifest["variants"] for item in variant["passes"]]
    files = {item[stage] for item in drawn for stage in ("vertex", "fragment")}
    assert listing(out) == sorted(files | {"manifest.json"})
    assert listing(tmp_path / "new") == ["out"]


def test_options_reach_the_manifest(
    shell: Shell, fragment: Path, rings: str, tmp_path: Path
) -> None:
    options = ("--passes", 2, "--format", "rgba32f", "--mode", "proof")
    shell("rewrite", fragment, "--node", rings, *options, "-o", tmp_path)
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    assert [item["algorithm"] for item in manifest["variants"]] == ["2-pass"]
    assert manifest["cache"]["format"] == "rgba32f"
    assert manifest["mode"] == "proof"


def test_into_a_folder_that_exists(
    shell: Shell, fragment: Path, rings: str, tmp_path: Path
) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    (tmp_path / "manifest.json").write_text("old")
    assert shell("rewrite", fragment, "--node", rings, "-o", tmp_path).status == 0
    assert (tmp_path / "notes.txt").read_text() == "mine"
    assert json.loads((tmp_path / "manifest.json").read_text())["schema_version"] == 3


@pytest.mark.parametrize(
    "names",
    [
        ("rings(v_position)",),
        ("rings( v_position )",),
        (":20:25",),
        ("rings(v_position)+length(at.xz) * 20.0 + texture(u_wood, at.xy).r",),
        ("rings(v_position)", "length(at.xz)*20.0 + texture(u_wood, at.xy).r"),
    ],
)
def test_nodes_by_their_text_and_place(
    shell: Shell, fragment: Path, tmp_path: Path, names: tuple[str, ...]
) -> None:
    given = [word for name in names for word in ("--node", name)]
    outcome = shell("rewrite", fragment, *given, "-o", tmp_path)
    if len(names) > 1 or "+" in names[0]:
        assert outcome.status == 1 and "is not needed where the rest" in outcome.err
        return
    told = json.loads((tmp_path / "manifest.json").read_text())["nodes"]
    wanted = "rings(v_position) * lit" if names[0].startswith(":") else "rings(v_position)"
    assert [node["text"] for node in told] == [wanted]


def test_two_nodes_are_not_taken_for_their_sum(
    shell: Shell, several: tuple[Path, dict[str, str]], tmp_path: Path
) -> None:
    path, _ = several
    sides = SUM.split(" + ")
    given = [word for side in sides for word in ("--node", side)]
    assert shell("rewrite", path, *given, "-o", tmp_path / "two").status == 0
    assert shell("rewrite", path, "--node", SUM, "-o", tmp_path / "one").status == 0
    texts = [
        [node["text"] for node in json.loads((folder / "manifest.json").read_text())["nodes"]]
        for folder in (tmp_path / "two", tmp_path / "one")
    ]
    assert texts == [sides, [SUM]]


def test_a_name_of_several_values_lists_them(shell: Shell, fragment: Path, tmp_path: Path) -> None:
    fragment = tmp_path / "two.frag"
    fragment.write_text(
        "#version 330\nin vec3 v;\nout vec4 o;\n"
        "float f(vec3 p) { return exp(sin(p.x * 3.0)) * exp(p.y); }\n"
        "void main() { o = vec4(f(v), f(v.yzx), 1.0, 1.0); }\n"
    )
    fragment.with_suffix(".vert").write_text(
        "#version 330\nin vec3 a;\nout vec3 v;\nuniform mat4 m;\n"
        "void main() { v = a; gl_Position = m * vec4(a, 1.0); }\n"
    )
    outcome = shell("rewrite", fragment, "--node", "exp(p.y)+f(v)", "-o", tmp_path / "out")
    assert outcome.status == 2
    outcome = shell("rewrite", fragment, "--node", ":4", "-o", tmp_path / "out")
    assert (outcome.status, outcome.out) == (2, "")
    assert "error: ':4' means 2 different values of" in outcome.err
    assert outcome.err.count("two.frag:4:26: note: f.") == 2
    assert "on the path main > f@1 [SC012]" in outcome.err and "main > f@2" in outcome.err


@pytest.mark.parametrize("fragment_from_stdin", [True, False])
def test_one_shader_may_come_from_stdin(
    shell: Shell, fragment: Path, rings: str, tmp_path: Path, fragment_from_stdin: bool
) -> None:
    vertex = fragment.with_suffix(".vert")
    pair = ("-", "--vert", vertex) if fragment_from_stdin else (fragment, "--vert", "-")
    stdin = (fragment if fragment_from_stdin else vertex).read_bytes()
    outcome = shell("rewrite", *pair, "--node", rings, "-o", tmp_path, stdin=stdin)
    assert (outcome.status, outcome.err) == (0, "")


@pytest.mark.parametrize(
    ("args", "status", "code"),
    [
        (("{frag}", "--node", "main.999-00000000"), 2, "SC010"),
        (("{frag}", "--node", "{other}"), 2, "SC011"),
        (("{frag}", "--node", "{constant}"), 1, "SC302"),
        (("{frag}", "--node", "{cheap}"), 1, "SC308"),
        (("-", "--node", "{rings}"), 2, "SC005"),
        (("-", "--vert", "-", "--node", "{rings}"), 2, "SC005"),
        (("{frag}", "--vert", "missing.vert", "--node", "{rings}"), 1, "SC001"),
        (("{frag}", "--vert", "{frag}", "--node", "{rings}"), 1, "SC"),
        (("{frag}", "--node", "{rings}", "--passes", "4"), 2, "SC003"),
    ],
)
def test_bad_requests_write_nothing(
    shell: Shell,
    fragment: Path,
    rings: str,
    tmp_path: Path,
    args: tuple[str, ...],
    status: int,
    code: str,
) -> None:
    nodes = shell("nodes", fragment, "--json").nodes
    refused = {node["refusal"]["code"]: node["id"] for node in nodes if node["refusal"]}
    names = {
        "frag": fragment,
        "rings": rings,
        "other": rings.rpartition("-")[0] + "-00000000",
        "constant": refused["SC302"],
        "cheap": refused["SC308"],
    }
    filled = [arg.format_map(names) for arg in args]
    out = tmp_path / "out"
    outcome = shell("rewrite", *filled, "-o", out, stdin=fragment.read_bytes())
    assert (outcome.status, outcome.out) == (status, "")
    assert f"[{code}" in outcome.err
    assert listing(tmp_path) == []


def test_a_cheap_node_is_rewritten_on_request(shell: Shell, fragment: Path, tmp_path: Path) -> None:
    nodes = shell("nodes", fragment, "--json").nodes
    cheap = [n["id"] for n in nodes if n["refusal"] and n["refusal"]["unprofitable"]]
    outcome = shell("rewrite", fragment, "--node", cheap[0], "--unprofitable", "-o", tmp_path)
    assert (outcome.status, outcome.err) == (0, "")


@pytest.mark.parametrize(
    ("place", "reason"),
    [
        ("/dev/null/out", "/dev/null: it is a file, not a folder"),
        ("/dev/null", "/dev/null: it is a file, not a folder"),
        ("/proc/out", "No such file or directory"),
        ("", "the name of the folder is empty"),
    ],
)
def test_an_output_folder_that_cannot_be_written(
    shell: Shell, fragment: Path, rings: str, place: str, reason: str
) -> None:
    outcome = shell("rewrite", fragment, "--node", rings, "-o", place)
    assert (outcome.status, outcome.out) == (2, "")
    assert outcome.err.startswith("error: cannot write")
    assert reason in outcome.err and "[SC002]" in outcome.err


SET = """#version 330 core
uniform sampler2D u_wood;
uniform vec3 u_light;
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;

float rings(vec3 at) {
    return 0.5 + 0.5 * sin(length(at.xz) * 20.0 + sin(at.y * 3.0) * cos(at.x * 5.0));
}
void main() {
    vec4 wood = texture(u_wood, v_position.xy) * rings(v_position);
    vec2 wide = vec2(rings(v_position.yzx), rings(v_normal));
    vec3 tone = wood.rgb * rings(v_position.zxy) + rings(v_normal.yzx);
    float fine = tone.x > 0.5 ? wide.x : rings(v_normal.zyx);
    o_color = vec4(tone * wide.y * fine, wood.a);
}
"""


@pytest.fixture
def several(shell: Shell, fragment: Path, tmp_path: Path) -> tuple[Path, dict[str, str]]:
    """A shader with many values worth caching, and their ids by their texts."""
    path = tmp_path / "set.frag"
    path.write_text(SET)
    path.with_suffix(".vert").write_text(fragment.with_suffix(".vert").read_text())
    nodes = shell("nodes", path, "--json").nodes
    return path, {node["text"]: node["id"] for node in reversed(nodes)}


WIDE, TONE = "rings(v_position.yzx)", "rings(v_position.zxy)"
SUM = "wood.rgb * rings(v_position.zxy) + rings(v_normal.yzx)"


@pytest.mark.parametrize("joined", [True, False])
def test_several_nodes_are_one_set(
    shell: Shell, several: tuple[Path, dict[str, str]], tmp_path: Path, joined: bool
) -> None:
    path, ids = several
    pair = ids[WIDE], ids["wood"]
    nodes = ("--node", "+".join(pair)) if joined else ("--node", pair[0], "--node", pair[1])
    out = tmp_path / "out"
    outcome = shell("rewrite", path, *nodes, "-o", out)
    assert outcome.status == 0 and "error" not in outcome.err
    assert "note: payload and shading both compute 25% of the shader; with 'wood.a'" in outcome.err
    manifest = json.loads((out / "manifest.json").read_text())
    assert [node["id"] for node in manifest["nodes"]] == list(pair)
    channels = [{"cache": "x"}, {"cache": "yz", "second": "xy"}]
    assert [node["channels"] for node in manifest["nodes"]] == channels


def test_what_is_shared_is_carried_along(
    shell: Shell, several: tuple[Path, dict[str, str]], tmp_path: Path
) -> None:
    path, ids = several
    out = tmp_path / "out"
    outcome = shell(
        "rewrite", path, "--node", ids[WIDE], "--node", ids["wood"], "--carry", "-o", out
    )
    assert (outcome.status, outcome.err) == (0, "")
    manifest = json.loads((out / "manifest.json").read_text())
    assert [node["text"] for node in manifest["nodes"]] == [WIDE, "wood", "wood.a"]


def test_a_value_that_comes_and_goes_is_noted(
    shell: Shell, several: tuple[Path, dict[str, str]], tmp_path: Path
) -> None:
    path, ids = several
    nodes = ("--node", ids[TONE], "--node", ids["rings(v_normal.zyx)"])
    outcome = shell("rewrite", path, *nodes, "-o", tmp_path / "out")
    assert outcome.status == 0
    assert "note: 'rings(v_normal.zyx)' is not computed in every fragment" in outcome.err
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text())
    assert [node["conditional"] for node in manifest["nodes"]] == [False, True]


@pytest.mark.parametrize(
    ("nodes", "status", "said"),
    [
        ((TONE, TONE), 1, "is in the set twice [SC415]"),
        ((TONE, "rings(v_position.zxy)*"), 2, "has no node '"),
        ((SUM, "tone"), 1, "'tone' ("),
        (("wood", "tone", WIDE), 1, "the set needs 4 + 3 + 1 = 8 channels"),
        ((TONE, SUM), 1, "'rings(v_position.zxy)' ("),
        ((WIDE, "vec2(rings(v_position.yzx), rings(v_normal))"), 1, "is not needed where the rest"),
        ((WIDE, "u_wood"), 1, "[SC305]"),
        ((WIDE, "v_normal.yzx"), 1, "[SC308]"),
        ((WIDE, ""), 2, "lacks an id beside a '+' [SC010]"),
    ],
)
def test_sets_that_cannot_be(
    shell: Shell,
    several: tuple[Path, dict[str, str]],
    tmp_path: Path,
    nodes: tuple[str, ...],
    status: int,
    said: str,
) -> None:
    path, ids = several
    wanted = "+".join(ids.get(text, text) for text in nodes)
    outcome = shell("rewrite", path, "--node", wanted, "-o", tmp_path / "out")
    assert (outcome.status, outcome.out) == (status, "")
    assert said in outcome.err
    assert not (tmp_path / "out").exists()


def test_a_node_of_an_unrolled_loop(shell: Shell, tmp_path: Path) -> None:
    shader = tmp_path / "loop.frag"
    shader.write_text(
        "#version 330\nin vec3 v_position;\nout vec4 o_color;\nvoid main() {\n"
        "    float sum = 0.0;\n"
        "    for (int i = 0; i < 4; i++) sum += sin(v_position.x * exp(float(i))) * cos(sum);\n"
        "    o_color = vec4(sum);\n}\n"
    )
    line = ["rewrite", shader, "--vert", Path(__file__).parent / "shaders" / "small.vert"]
    nodes = shell("nodes", shader, "--unroll", "--json").nodes
    node = next(item["id"] for item in nodes if item["path"] == "main [i=2]" and item["offered"])
    out = tmp_path / "out"
    assert shell(*line, "--node", node, "--unroll", "-o", out).status == 0
    assert "for (" in (out / "original.frag").read_text()
    assert "for (" not in (out / "2-pass.miss.frag").read_text()
    refused = shell(*line, "--node", node, "-o", out)
    assert refused.status == 2 and "add --unroll" in refused.err


def test_an_id_that_is_short_for_several_nodes(
    shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(node_ids, "SHORT", 1)
    calls = " + ".join(f"wave(v_uv.x * {i}.0)" for i in range(100))
    wave = "float wave(float x) { return sin(x * 3.0) * cos(exp(x)) + sin(x); }"
    analysis = analysed(f"o_color = vec4({calls});", wave)
    files = analysis.fragment, analysis.vertex_source
    for source in files:
        (tmp_path / source.name).write_text(source.text)
    pair = tmp_path / files[0].name, "--vert", tmp_path / files[1].name
    digits = 2 * node_ids.LONG
    node = next(n for n in analysis.nodes if n.offered and len(n.id.rpartition("-")[2]) > digits)
    outcome = shell("rewrite", *pair, "--node", node.id[:-digits], "-o", tmp_path / "out")
    assert outcome.status == 2 and "[SC012]" in outcome.err and node.id in outcome.err
    assert not (tmp_path / "out").exists()
    outcome = shell("rewrite", *pair, "--node", node.id, "-o", tmp_path / "out")
    assert outcome.status == 0
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text())
    assert [item["id"] for item in manifest["nodes"]] == [node.id]


def test_a_value_of_the_screen(shell: Shell, tmp_path: Path) -> None:
    shader, out = tmp_path / "face.frag", tmp_path / "out"
    face = "normalize(cross(dFdx(v_position), dFdy(v_position)))"
    shader.write_text(
        "#version 330\nin vec3 v_position;\nout vec4 o_color;\n"
        f"void main() {{\n    o_color = vec4({face}, 1.0);\n}}\n"
    )
    line = ["rewrite", shader, "--vert", Path(__file__).parent / "shaders" / "small.vert"]
    refused = shell(*line, "--node", face, "-o", out)
    assert refused.status == 1 and "[SC312]" in refused.err
    assert "hint: with --approximate it may be cached" in refused.err
    assert shell(*line, "--node", face, "--approximate", "-o", out).status == 0
    manifest = json.loads((out / "manifest.json").read_text())
    assert manifest["nodes"][0]["approximate"] is True
    relied = [text for text in manifest["relies_on"] if text.startswith("little motion")]
    assert len(relied) == 1 and f"'{face}' depends on where" in relied[0]
    rate = shell(*line, "--node", face, "--approximate", "--rate", "half", "-o", out)
    assert rate.status == 1 and "a smaller picture shows otherwise" in rate.err

"""Commands on a full-screen shader, which has no scene."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from .conftest import Shell

SHADERS = Path(__file__).parent.parent / "laws" / "full_screen"
CLOUDS = (SHADERS / "clouds.frag", "--dialect", "shadertoy")
SCROLL = SHADERS / "scroll.frag"

gl = pytest.mark.xdist_group("gl")


@pytest.fixture
def static(shell: Shell) -> str:
    """The id of a node that does not change with time."""
    nodes = shell("nodes", *CLOUDS, "--json").nodes
    return next(node["id"] for node in nodes if node["text"] == "fbm(5.0 * uv)")


def test_nodes_say_which_mapping_is_taken(shell: Shell, static: str) -> None:
    table = shell("nodes", *CLOUDS, "--offered").out
    assert "\nmapping: screen, a value is reused at the same pixel" in table
    outcome = shell("nodes", *CLOUDS, "--json")
    assert outcome.json["mapping"] == "screen"
    told = {node["id"]: node["exact_while_unchanged"] for node in outcome.nodes}
    assert told[static] == ["iResolution"]
    flat = shell("nodes", *CLOUDS, "--mapping", "surface", "--json")
    assert flat.json["mapping"] == "surface"
    assert not any(node["offered"] for node in flat.nodes)
    assert "exact_while_unchanged" not in flat.nodes[0]


def test_rewrite_without_a_vertex_shader(shell: Shell, static: str, tmp_path: Path) -> None:
    outcome = shell("rewrite", *CLOUDS, "--node", static, "-o", tmp_path)
    assert (outcome.status, outcome.err) == (0, "")
    assert outcome.out.endswith("(mapping: screen)\n")
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    assert manifest["mapping"] == {"kind": "screen", "exact_while_unchanged": ["iResolution"]}
    assert manifest["draw"]["vertices"] == 3
    assert manifest["relies_on"][-1].endswith("while these do not change: iResolution")
    assert "gl_VertexID" in (tmp_path / "1-pass.vert").read_text()


def test_rewrite_for_the_users_mapping(shell: Shell, tmp_path: Path) -> None:
    nodes = shell("nodes", SCROLL, "--mapping", "user", "--json").nodes
    rings = next(node["id"] for node in nodes if node["text"] == "rings")
    outcome = shell("rewrite", SCROLL, "--mapping", "user", "--node", rings, "-o", tmp_path)
    assert (outcome.status, outcome.err) == (0, "")
    assert json.loads((tmp_path / "manifest.json").read_text())["mapping"] == {"kind": "user"}
    assert "scPreviousClip" in (tmp_path / "3-pass.reuse.frag").read_text()


@gl
def test_verify_without_a_scene(shell: Shell, static: str) -> None:
    outcome = shell("verify", *CLOUDS, "--node", static, "--proof-only", "-j", 1)
    assert outcome.status == 0, outcome.out
    assert "law 1: holds" in outcome.out and outcome.out.endswith("mapping: screen\n")
    assert "laws 2-4: 1 of 1 nodes exact in proof mode" in outcome.out


@gl
def test_run_and_bench_without_a_scene(shell: Shell, static: str, tmp_path: Path) -> None:
    small = ("--size", "48x32", "-o", tmp_path)
    outcome = shell("run", *CLOUDS, "--node", static, "--frame", 3, *small)
    assert outcome.status == 0, outcome.err
    assert list(tmp_path.glob("*.png")) and outcome.out.startswith("mapping: screen\n")
    options = ("--nodes", static, "--passes", "2", "--frames", 3, "--seconds", 1)
    outcome = shell("bench", *CLOUDS, *options, *small, "--json")
    assert outcome.status == 0, outcome.err
    assert outcome.json["scene"] == "clouds"
    assert outcome.json["options"]["stop"] == {"half_width": 0.03, "seconds": 1.0}


@gl
def test_what_is_perceived_is_measured_when_asked(
    shell: Shell, static: str, tmp_path: Path
) -> None:
    small = ("--size", "48x32", "--frames", 4, "--until", 0, "-o", tmp_path)
    asked = ("bench", *CLOUDS, "--nodes", static, "--passes", "2", *small)
    outcome = shell(*asked, "--perceptual")
    assert outcome.status == 0, outcome.err
    heading = next(line for line in outcome.out.splitlines() if line.startswith("node "))
    assert heading.split()[-4:] == ["SSIM", "FLIP", "flicker", "pattern"]
    told = json.loads((tmp_path / "clouds.json").read_text())
    [variant] = told["groups"][0]["nodes"][0]["variants"]
    # A screen-sized value of a scene that rests: each pixel is as old as its turn is ago.
    ages = variant["perceived"]["by_age"]
    assert ages[0]["rmse"] == 0.0 and sum(age["share"] for age in ages) == pytest.approx(1.0)
    assert ages[-1]["oldest"] <= 4
    assert "SSIM" not in shell(*asked).out


@gl
def test_where_a_frame_goes_is_told_when_asked(shell: Shell, static: str, tmp_path: Path) -> None:
    small = ("--size", "48x32", "--frames", 4, "--until", 0, "-o", tmp_path)
    asked = ("bench", *CLOUDS, "--nodes", static, "--passes", "3", "--period", "2,8", *small)
    outcome = shell(*asked, "--profile")
    assert outcome.status == 0, outcome.err
    tables = outcome.out.split("where a frame of 2-pass goes: ")[1:]
    assert [table.split(", ")[1] for table in tables] == ["period 2", "period 8"]
    profiles = json.loads((tmp_path / "clouds.json").read_text())["profiles"]
    for profile, table in zip(profiles, tables, strict=True):
        names = [part["name"] for part in profile["parts"]]
        assert "look-up" in names and all(f"\n{name} " in table for name in names)
    assert "where a frame" not in shell(*asked).out


@gl
def test_periods_and_blocks_are_measured_beside_each_other(
    shell: Shell, static: str, tmp_path: Path
) -> None:
    small = ("--size", "48x32", "--frames", 4, "--until", 0, "-o", tmp_path)
    refreshes = ("--passes", "1,2", "--period", "2,8", "--block", "2,4")
    outcome = shell("bench", *CLOUDS, "--nodes", static, *refreshes, *small, "--json")
    assert outcome.status == 0, outcome.err
    [group] = outcome.json["groups"]
    found = [variant["configuration"] for variant in group["nodes"][0]["variants"]]
    told = [(item["refresh"]["period"], item["refresh"]["block"]) for item in found]
    assert told == [(n, k) for n in (2, 8) for k in (2, 4) for _ in range(2)]
    assert [item["algorithm"] for item in found[:2]] == ["1-pass", "2-pass"]
    names = {path.name for path in tmp_path.iterdir()}
    assert {"clouds.json", "clouds.csv", "clouds-time.png", "clouds-hits.png"} <= names


FETCHED = """#version 330
uniform vec2 u_resolution;
uniform sampler2D u_map;
out vec4 c;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    vec3 a = vec3(0.0);
    if (p.x > 0.25) {
        a = sin(texture(u_map, p * 3.0).rgb * 3.0) * cos(p.y * 7.0);
    }
    c = vec4(a * p.x, 1.0);
}
"""


@gl
def test_an_algorithm_that_does_not_fit_is_told(shell: Shell, tmp_path: Path) -> None:
    path = tmp_path / "fetched.frag"
    path.write_text(FETCHED)
    nodes = shell("nodes", path, "--json").nodes
    node = next(item["id"] for item in nodes if item["offered"] and "sin(" in item["text"])
    small = ("--size", "32x32", "-o", tmp_path / "out")
    told = shell("run", path, "--node", node, "--passes", "1", "--frame", 2, *small)
    assert told.status == 2 and "[SC026]" in told.err and "2-pass, 3-pass" in told.err
    told = shell("bench", path, "--nodes", node, "--passes", "1", "--frames", 3, *small)
    assert told.status == 2 and "[SC027]" in told.err
    assert "hint: " in told.err and "has no 1-pass: " in told.err


SOLID = "#version 330\nin vec3 v;\nout vec4 c;\nvoid main() { c = vec4(WAVE); }\n"
SOLID = SOLID.replace("WAVE", "sin(v.x) * cos(v.y) * sin(v.z + 3.0 * cos(v.x)) * sin(v.y)")
DERIVING = """#version 330
uniform vec2 u_size;
out vec4 c;
vec4 scPreviousClip() { return dFdx(gl_FragCoord); }
void main() { c = vec4(sin(gl_FragCoord.x) * sin(gl_FragCoord.y)); }
"""


@pytest.mark.parametrize(
    ("args", "status", "code"),
    [
        (("nodes", *CLOUDS, "--mapping", "air"), 2, "SC003"),
        (("nodes", *CLOUDS, "--mapping", "user"), 1, "SC420"),
        (("verify", *CLOUDS, "--mapping", "surface"), 2, "SC006"),
        (("bench", *CLOUDS, "--mapping", "surface"), 2, "SC006"),
        (("run", *CLOUDS, "--mapping", "surface", "--node", "x"), 2, "SC006"),
        (("run", *CLOUDS, "--node", "x"), 2, "SC010"),
        (("bench", *CLOUDS, "--mesh", "a.npz"), 2, "SC008"),
        (("verify", "missing.frag"), 2, "SC006"),
        (("verify", "{solid}"), 2, "SC005"),
        (("verify", "{solid}", "--mapping", "screen"), 1, "SC406"),
        (
            ("rewrite", "{solid}", "--mapping", "screen", "--node", "{sine}", "-o", "out"),
            1,
            "SC406",
        ),
        (("rewrite", *CLOUDS, "--mapping", "surface", "--node", "x", "-o", "out"), 2, "SC005"),
        (("nodes", "{deriving}", "--mapping", "user"), 1, "SC421"),
        (("verify", "{deriving}", "--mapping", "user"), 1, "SC421"),
    ],
)
def test_bad_requests(
    shell: Shell, tmp_path: Path, args: tuple[object, ...], status: int, code: str
) -> None:
    for name, text in (("solid", SOLID), ("deriving", DERIVING)):
        (tmp_path / f"{name}.frag").write_text(text)
    nodes = shell("nodes", tmp_path / "solid.frag", "--json").nodes
    names = {
        "solid": tmp_path / "solid.frag",
        "deriving": tmp_path / "deriving.frag",
        "sine": next(node["id"] for node in nodes if node["offered"]),
    }
    outcome = shell(*(str(arg).format_map(names) for arg in args))
    assert (outcome.status, outcome.out) == (status, ""), outcome.err
    assert f"[{code}" in outcome.err


def test_a_scene_beside_is_that_of_the_shader_it_names(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "other.frag").write_text(SOLID)
    (tmp_path / "toy.frag").write_text(CLOUDS[0].read_text())
    (tmp_path / "scene.toml").write_text(
        'name = "o"\nfragment = "other.frag"\nmapping = "screen"\n'
    )
    outcome = shell("run", tmp_path / "toy.frag", "--dialect", "shadertoy", "--node", "x")
    assert "[SC010]" in outcome.err, "the shader itself is meant"
    outcome = shell("verify", tmp_path / "other.frag")
    assert "[SC406]" in outcome.err, "the scene is meant, which is full-screen"

"""``shadercache check``: the summary, the diagnostics, stages, dialects and what cannot be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from .conftest import Shell

GOOD = "#version 330\nout vec4 o;\nvoid main() { o = vec4(1.0); }\n"
BAD = "#version 330\nout vec4 o;\nvoid main() {\n    o = vec3(1.0);\n    o = nothing;\n}\n"
VERTEX = "#version 330\nin vec3 p;\nvoid main() { gl_Position = vec4(p, 1.0); }\n"
TOY = "void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(p / iResolution.xy, iTime, 1.0);\n}\n"


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with shaders, as the working folder."""
    texts = {"good.frag": GOOD, "bad.frag": BAD, "good.vert": VERTEX, "toy.glsl": TOY}
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_good_files(shell: Shell, write: Path) -> None:
    outcome = shell("check", "good.frag", "good.vert")
    assert (outcome.status, outcome.out, outcome.err) == (0, "2 files: 2 ok\n", "")


def test_every_mistake_of_every_file_is_told(shell: Shell, write: Path) -> None:
    (write / "other.frag").write_text(BAD)
    outcome = shell("check", "bad.frag", "good.frag", "other.frag")
    assert outcome.status == 1
    assert outcome.out == "3 files: 1 ok, 2 with 4 errors\n"
    told = [line for line in outcome.err.splitlines() if ": error: " in line]
    places = [line.split(":")[:2] for line in told]
    assert places == [[name, line] for name in ("bad.frag", "other.frag") for line in "45"]


def test_mistakes_in_front_of_a_missing_semicolon_are_told(shell: Shell, write: Path) -> None:
    (write / "broken.frag").write_text(BAD.replace("}", "    o = vec4(1.0)\n}"))
    outcome = shell("check", "broken.frag")
    assert outcome.out == "1 file: 1 with 3 errors\n"
    told = [line for line in outcome.err.splitlines() if ": error: " in line]
    assert [line.split(":")[1] for line in told] == ["4", "5", "6"]


def test_one_bad_file(shell: Shell, write: Path) -> None:
    assert shell("check", "bad.frag").out == "1 file: 1 with 2 errors\n"


def test_a_file_that_cannot_be_read_does_not_end_the_run(shell: Shell, write: Path) -> None:
    outcome = shell("check", "gone.frag", "good.frag")
    assert (outcome.status, outcome.out) == (1, "2 files: 1 ok, 1 with 1 error\n")
    assert "cannot read gone.frag" in outcome.err and "[SC001]" in outcome.err


def test_warnings_are_told_and_reject_nothing(shell: Shell, write: Path) -> None:
    (write / "odd.frag").write_text(GOOD.replace("void", "float a__b;\nvoid"))
    outcome = shell("check", "odd.frag")
    assert (outcome.status, outcome.out) == (0, "1 file: 1 ok, 1 warning\n")
    assert "odd.frag:3:7: warning: " in outcome.err


def test_json_has_everything_and_stderr_nothing(shell: Shell, write: Path) -> None:
    outcome = shell("check", "--json", "bad.frag", "good.vert")
    assert (outcome.status, outcome.err) == (1, "")
    assert {key: outcome.json[key] for key in ("ok", "errors", "warnings")} == {
        "ok": 1,
        "errors": 2,
        "warnings": 0,
    }
    bad, good = outcome.json["files"]
    assert (bad["file"], bad["stage"], bad["ok"]) == ("bad.frag", "fragment", False)
    assert [item["line"] for item in bad["diagnostics"]] == [4, 5]
    assert (good["stage"], good["ok"], good["diagnostics"]) == ("vertex", True, [])


def test_diagnostics_as_json_lines(shell: Shell, write: Path) -> None:
    outcome = shell("check", "bad.frag", "--diagnostics=json")
    assert all(line.startswith('{"file": "bad.frag"') for line in outcome.err.splitlines())


@pytest.mark.parametrize(
    "name", ["a.vert", "a.vs", "a.vsh", "a.vert.glsl", "a.frag", "a.fs", "a.fsh", "a.glsl", "a"]
)
def test_the_suffix_tells_the_stage(shell: Shell, write: Path, name: str) -> None:
    vertex = name.removesuffix(".glsl").endswith((".vert", ".vs", ".vsh"))
    (write / name).write_text(VERTEX)
    assert shell("check", name).status == (0 if vertex else 1)
    assert shell("check", "--stage=vertex", name).status == 0
    assert shell("check", "--stage=fragment", name).status == 1


def test_stdin(shell: Shell, write: Path) -> None:
    outcome = shell("check", "-", stdin=BAD.encode())
    assert outcome.out == "1 file: 1 with 2 errors\n"
    assert "<stdin>:5:9: error: " in outcome.err


@pytest.mark.parametrize(("dialect", "status"), [("glsl", 1), ("shadertoy", 0), ("auto", 0)])
def test_a_file_of_shadertoy(shell: Shell, write: Path, dialect: str, status: int) -> None:
    assert shell("check", "toy.glsl", "--dialect", dialect).status == status


def test_nodes_and_rewrite_know_dialects_too(shell: Shell, write: Path) -> None:
    nodes = shell("nodes", "toy.glsl", "--dialect=auto", "--json").nodes
    assert [node["line"] for node in nodes if node["text"].startswith("p / iRes")] == [2]
    outcome = shell("rewrite", "toy.glsl", "--vert", "good.vert", "--node=x", "-o", "out")
    assert "SC010" not in outcome.err
    outcome = shell(
        *("rewrite", "toy.glsl", "--vert", "good.vert", "--node=x", "-o", "out", "--dialect=auto")
    )
    assert "SC010" in outcome.err


@pytest.mark.parametrize(
    ("args", "word"),
    [
        (("-D", "1x"), "'1x'"),
        (("-D", "=1"), "-D: ''"),
        (("-D", "A 1"), "-D NAME=VALUE"),
        (("-D", "A=1\nB"), "more than one line"),
        (("-D", "__LINE__=1"), "'__LINE__' belongs to the language"),
        (("-U", "defined"), "'defined' belongs to the language"),
        (("-U", "a-b"), "'a-b'"),
        (("-I", "nowhere"), "there is no such folder"),
        (("-I", "good.frag"), "is not a folder"),
    ],
    ids=str,
)
@pytest.mark.parametrize("command", ["check", "nodes"])
def test_wrong_options(
    shell: Shell, write: Path, command: str, args: tuple[str, str], word: str
) -> None:
    outcome = shell(command, "good.frag", *args)
    assert outcome.status == 2
    assert "[SC008]" in outcome.err and word in outcome.err

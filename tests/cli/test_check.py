"""``shadercache check``: the summary, the diagnostics, stages, dialects and what cannot be read."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from shadercache.valid.reference_compiler import find_compiler

from .conftest import Outcome, Shell

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


FEEDBACK = (
    "#version 450\n#define OFFSET 2\nlayout(xfb_offset = OFFSET) out vec4 a;\n"
    "void main() {\n    int x = 1.5;\n    gl_Position = vec4(1.0);\n}\n"
)


@pytest.fixture
def asks(write: Path) -> Path:
    """The same folder, on a machine that has the reference compiler."""
    if find_compiler() is None:
        pytest.skip("glslangValidator is not installed")
    return write


def told(outcome: Outcome) -> list[tuple[int, str]]:
    """Line and code of each error."""
    return [
        (int(line.split(":")[1]), line[line.rindex("[") + 1 : -1])
        for line in outcome.err.splitlines()
        if ": error: " in line
    ]


def test_the_reference_compiler_is_asked_as_well(shell: Shell, asks: Path) -> None:
    (asks / "feedback.vert").write_text(FEEDBACK)
    outcome = shell("check", "feedback.vert", "good.frag")
    assert (outcome.status, told(outcome)) == (1, [(3, "SC240"), (5, "SC210")])
    outcome = shell("check", "--no-glslang", "feedback.vert")
    assert (outcome.status, told(outcome)) == (1, [(5, "SC210")])


def test_it_reads_what_the_parser_reads(shell: Shell, asks: Path) -> None:
    counter = "layout(binding = B) uniform atomic_uint n;\nlayout(offset = 3, binding = B) "
    (asks / "counters.glsl").write_text(f"{counter}uniform atomic_uint m;\n")
    (asks / "main.frag").write_text(
        '#version 450\n#extension GL_GOOGLE_include_directive : enable\n#include "counters.glsl"\n'
        "void main() {}\n"
    )
    outcome = shell("check", "main.frag", "-D", "B=0")
    assert told(outcome) == [(2, "SC240")] and "counters.glsl:2:" in outcome.err
    outcome = shell("check", "-", "-D", "B=0", stdin=(asks / "main.frag").read_bytes())
    assert [code for _, code in told(outcome)] == ["SC123"]
    outcome = shell("check", "-", "--stage=vertex", stdin=FEEDBACK.encode())
    assert told(outcome) == [(3, "SC240"), (5, "SC210")]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("webgl.frag", "precision mediump float;\nvoid main() { gl_FragColor = vec4(1.0); }\n"),
        ("toy.frag", TOY),
        ("empty.frag", "#version 330\n"),
        ("limit.frag", GOOD.replace("out", "layout(binding = 999) uniform sampler2D s; out")),
        ("word.frag", GOOD.replace("out", "float float16_t; out").replace("330", "450")),
    ],
)
def test_what_is_accepted_stays_accepted(shell: Shell, asks: Path, name: str, text: str) -> None:
    (asks / name).write_text(text.replace("330", "450") if "binding" in text else text)
    assert shell("check", "--dialect=auto", name).status == 0


@pytest.mark.parametrize("script", ["kill -SEGV $$", "exit 1", "echo nonsense; exit 2"])
def test_a_compiler_that_crashes_is_no_error(
    shell: Shell, write: Path, monkeypatch: pytest.MonkeyPatch, script: str
) -> None:
    tool = write / "glslangValidator"
    tool.write_text(f"#!/bin/sh\n{script}\n")
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", f"{write}:{os.environ['PATH']}")
    assert shell("check", "good.frag", "good.vert").status == 0


def test_one_file_that_crashes_it_hides_no_other(
    shell: Shell, asks: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (asks / "feedback.vert").write_text(FEEDBACK)
    tool = asks / "glslangValidator"
    tool.write_text(
        f'#!/bin/sh\ngrep -q CRASH "$@" && kill -SEGV $$\nexec {find_compiler()} "$@"\n'
    )
    tool.chmod(0o755)
    (asks / "crash.frag").write_text(GOOD.replace("void", "float CRASH; void"))
    monkeypatch.setenv("PATH", f"{asks}:{os.environ['PATH']}")
    outcome = shell("check", "feedback.vert", "crash.frag", "good.frag")
    assert told(outcome) == [(3, "SC240"), (5, "SC210")]


def test_no_compiler_is_no_error(
    shell: Shell, write: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(write))
    assert shell("check", "good.frag").status == 0

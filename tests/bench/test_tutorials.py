"""The programs of a tutorial: which vertex shader goes with which fragment shader, what becomes of
them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bench.tutorials.__main__ import main
from bench.tutorials.programs import programs_of

pytestmark = pytest.mark.xdist_group("gl")

VERTEX = """#version 330 core
in vec3 aPos;
out vec3 place;
uniform mat4 projection, view, model;
void main() { place = aPos; gl_Position = projection * view * model * vec4(aPos, 1.0); }
"""
WAVES = """#version 330 core
in vec3 place;
out vec4 color;
void main() { color = vec4(sin(place * 9.0) * cos(place.zxy * 7.0), 1.0); }
"""
RED = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0, 0.0, 0.0, 1.0); }\n"
BROKEN = "#version 330 core\nout vec4 color;\nvoid main() { color = red; }\n"
PAGE = """<script id="vs-draw" type="x-shader/x-vertex">
#version 300 es
in vec2 pos;
void main() { gl_Position = vec4(pos, 0.0, 1.0); }
</script>
<script id="fs-draw" type="x-shader/x-fragment">
#version 300 es
precision highp float;
out vec4 color;
void main() { color = vec4(1.0); }
</script>
"""


def laid_out(folder: Path) -> Path:
    texts = {
        "a/waves.vs": VERTEX,
        "a/waves.fs": WAVES,
        "a/again.fs": WAVES,
        "b/plain.vs": VERTEX.replace("place", "other"),
        "b/named.vs": VERTEX + "// by the program\n",
        "b/red.fs": RED,
        "b/main.cpp": 'Shader red("named.vs", "red.fs");',
        "c/lines.vs": VERTEX,
        "c/lines.gs": "",
        "c/lines.fs": WAVES,
        "c/broken.fs": BROKEN,
        "d/page.html": PAGE,
    }
    for name, text in texts.items():
        path = folder / name
        path.parent.mkdir(exist_ok=True, parents=True)
        path.write_text(text)
    return folder


def test_pairs(tmp_path: Path) -> None:
    programs = {program.name: program for program in programs_of(laid_out(tmp_path))}
    assert list(programs) == [
        *("d/page.html#fs-draw", "a/again.fs", "b/red.fs", "c/broken.fs", "c/lines.fs")
    ]
    # What hands on all that is read goes with a shader that has no name to go by.
    again = programs["a/again.fs"]
    assert again.vertex == VERTEX and again.also == 1
    assert (programs["b/red.fs"].vertex or "").endswith("// by the program\n")
    assert "gl_Position = vec4(pos" in (programs["d/page.html#fs-draw"].vertex or "")
    assert [name for name, program in programs.items() if program.between] == ["c/lines.fs"]


def test_outcomes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, result = laid_out(tmp_path / "shaders"), tmp_path / "result.json"
    arguments = [str(folder), "-o", str(result), "--work", str(tmp_path / "work")]
    assert main(arguments) == 0
    rows = {row["name"]: row for row in json.loads(result.read_text())["programs"]}
    assert {name: row["kind"] for name, row in rows.items()} == {
        "a/again.fs": "exact",
        "b/red.fs": "nothing to cache",
        "c/broken.fs": "glslang rejects it",
        "c/lines.fs": "left out",
        "d/page.html#fs-draw": "nothing to cache",
    }
    assert rows["b/red.fs"]["told"] == ["SC302 is a constant; the driver folds it"]
    assert rows["a/again.fs"]["scene"] == "ring"
    text = capsys.readouterr().out
    assert "that glslang takes: 3\nexact, of those that glslang takes: 33.33%" in text
    assert "exact, of those with a value that may be cached: 100.00%" in text
    # Nothing is done twice.
    assert main([*arguments, "--resume"]) == 0
    assert capsys.readouterr().err == ""

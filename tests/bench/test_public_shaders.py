"""``./dev corpus``: collections from folders, comparison of types and images, figures."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path

import pytest

from bench.public_shaders import drawing
from bench.public_shaders.drawing import Picture, draw_all, plain_vertex
from bench.public_shaders.reading import Row, Verdict, examine, failures, figures, judge, table
from bench.public_shaders.shaders import (
    Shader,
    evenly,
    evenly_by_folder,
    folder_shaders,
    shaders_of,
)
from bench.public_shaders.typing import shape_of, type_differences
from shadercache.source import Source
from shadercache.valid.read import read
from tests.glslang import needs_glslang

MAIN = "void main() { }\n"
FRAGMENT = """#version 330
struct Light { vec3 color; float falloff[2]; };
in vec3 v_normal;
flat in ivec2 v_cell;
in Extra { vec2 uv; Light light; } extra[2];
uniform sampler2D u_map;
uniform float u_gain;
layout(location = 0) out vec4 o_color;
layout(location = 1) out uvec2 o_cell;
void main() {
    vec3 n = v_normal;
    n *= u_gain;
    o_color = texture(u_map, extra[1].uv) + vec4(n, extra[0].light.falloff[1]);
    o_cell = uvec2(v_cell);
}
"""


# --- collections ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "text", "stages"),
    [
        ("a.vert", "", "vertex"),
        ("a.vsh", "", "vertex"),
        ("a.fs", "", "fragment"),
        ("vertex.glsl", "", "vertex"),
        ("sky_fs.glsl", "", "fragment"),
        ("sky.frag.glsl", "", "fragment"),
        ("vertex_utils.frag", "", "fragment"),
        ("both.glsl", "#ifdef VERTEX\n#elif defined(FRAGMENT)\n#endif\n", "vertex fragment"),
        ("lone.glsl", MAIN, "fragment"),
        ("library.glsl", "float half(float x) { return 0.5 * x; }", ""),
        ("blur.comp.glsl", MAIN, ""),
        ("blur.glsl", "layout(local_size_x = 8) in;\n" + MAIN, ""),
    ],
    ids=lambda value: str(value)[:20],
)
def test_stages_of_a_file(name: str, text: str, stages: str) -> None:
    assert " ".join(shader.stage for shader in shaders_of(name, text)) == stages


def test_the_macro_of_a_stage_stands_behind_the_version() -> None:
    vertex, _ = shaders_of("x.glsl", "#version 130\n#ifdef VERTEX\n#endif\n// FRAGMENT\n")
    assert vertex.text.startswith("#version 130\n#define VERTEX 1\n#ifdef")


def test_a_folder_with_included_files(tmp_path: Path) -> None:
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib" / "noise.glsl").write_text('float noise;\n#include "noise.glsl"\n')
    (tmp_path / "a.frag").write_text('#include "lib/noise.glsl"\n#include "missing"\nint a;\n')
    (tmp_path / "copy.frag").write_text((tmp_path / "a.frag").read_text())
    (tmp_path / "b.frag").write_text("#include <noise.glsl>\nint b;\n")
    found = folder_shaders(tmp_path, [tmp_path / "lib"])
    assert [shader.file for shader in found] == [
        f"{tmp_path.name}/{name}.frag.frag" for name in "ab"
    ]
    assert found[0].text.split() == ["float", "noise;", "#include", '"missing"', "int", "a;"]
    assert found[1].text.split() == ["float", "noise;", "int", "b;"]


def test_sections_of_a_test_of_piglit(tmp_path: Path) -> None:
    text = "[require]\nGLSL >= 1.30\n[vertex shader]\nint v;\n"
    text += "[fragment shader]\n#version 120\nint f;\n[fragment shader]\nint g;\n[test]\ndraw\n"
    (tmp_path / "x.shader_test").write_text(text)
    (tmp_path / "y.shader_test").write_text("GLSL ES >= 3.00\n[vertex shader]\nint w;\n")
    (tmp_path / "z.shader_test").write_text("[vertex shader]\nint z;\n")
    script = Path(drawing.__file__).with_name("sections.awk")
    subprocess.run(["awk", "-f", script, *sorted(tmp_path.iterdir())], check=True)
    texts = {shader.name: shader.text for shader in folder_shaders(tmp_path)}
    assert texts == {
        f"{tmp_path.name}/{name}": text
        for name, text in {
            "x.shader_test.2.frag": "#version 130\nint g;\n",
            "x.shader_test.frag": "#version 120\nint f;\n",
            "x.shader_test.vert": "#version 130\nint v;\n",
            "y.shader_test.vert": "#version 300 es\nint w;\n",
            "z.shader_test.vert": "#version 110\nint z;\n",
        }.items()
    }


def test_choosing_by_folder() -> None:
    shaders = [Shader(f"{at % 2}/{at}", "fragment", f"int a{at};") for at in range(10)]
    assert [shader.name for shader in evenly_by_folder(shaders, 2)] == ["0/0", "0/6", "1/1", "1/7"]
    assert len(evenly_by_folder(shaders, None)) == 10


def test_choosing() -> None:
    shaders = [Shader(f"{number}", "fragment", "int a;") for number in range(10)]
    assert [shader.name for shader in evenly(shaders, 4)] == list("0369")
    assert evenly(shaders, None) == shaders


# --- types ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("temp float", "float"),
        (" in mediump 3-component vector of int", "ivec3"),
        ("out 4-component vector of float FragColor", "vec4"),
        ("layout( column_major std140) uniform 4X3 matrix of float", "mat4x3"),
        ("temp 2X2 matrix of double", "dmat2"),
        ("uniform 2-element array of 3-element array of highp sampler2D", "sampler2D[2][3]"),
        ("temp structure{ global 2-element array of float b}", "struct"),
        ("global 2-element array of structure{ global float b}", "struct[2]"),
    ],
)
def test_types_in_the_words_of_the_judge(words: str, name: str) -> None:
    assert shape_of(words) == name


@needs_glslang
def test_types_agree_or_not(tmp_path: Path) -> None:
    ours = read(Source("x", FRAGMENT))
    verdict, tree = judge(Shader("x", "fragment", FRAGMENT), tmp_path)
    assert verdict == Verdict("")
    assert type_differences(tree, *ours) == ""
    # The judge is shown another text than we are.
    other = FRAGMENT.replace("vec3 n = v_normal", "vec2 n = v_normal.xy").replace("(n,", "(n, 0.0,")
    other = other.replace("uvec2 o_cell", "uvec3 o_cell").replace(
        "uvec2(v_cell)", "uvec3(v_cell, 1)"
    )
    difference = type_differences(judge(Shader("y", "fragment", other), tmp_path)[1], *ours)
    assert "'o_cell' is uvec3, with us uvec2" in difference
    assert "'vec2': 2" in difference


@needs_glslang
def test_what_is_found_of_a_shader(tmp_path: Path) -> None:
    good = "#version 330\nout vec4 o;\nvoid main() { o = vec4(1.0); }\n"
    row = examine(tmp_path, Shader("good", "fragment", good))
    assert dict.fromkeys(row.problems.values()) == {"": None}
    assert list(row.problems) == ["accepted", "typed", "taken again", "by glslang", "stable"]
    assert row.printed is not None
    row = examine(tmp_path, Shader("bad", "fragment", good.replace("vec4(1.0)", "c")))
    assert row.problems == {"rejected": "", "same line": ""}
    assert [verdict.line for verdict in row.verdicts] == [3, 3]
    assert row.verdicts[1].error == "'c' : undeclared identifier"
    assert row.printed is None


# --- images ---------------------------------------------------------------------------------------


def test_the_plain_vertex_shader_is_valid_and_feeds_every_input() -> None:
    module, facts = read(Source("test.frag", FRAGMENT))
    text = plain_vertex(module, facts, FRAGMENT)
    read(Source("test.vert", text), "vertex")
    assert text.count(" = ") == 1 + 2 + 2 * 4  # gl_Position, two inputs, two blocks of four.


@pytest.mark.parametrize(
    ("version", "declaration", "use"),
    [
        ("100", "precision mediump float; varying vec2 v;", "gl_FragColor = vec4(v, 0.0, 1.0);"),
        ("110", "varying vec2 v;", "gl_FragColor = vec4(v, gl_TexCoord[0].xy);"),
        ("300 es", "precision highp float; in vec2 v; out vec4 o;", "o = vec4(v, 0.0, 1.0);"),
        ("460", "in vec2 v; out vec4 o;", "o = vec4(v, 0.0, 1.0);"),
    ],
)
@pytest.mark.xdist_group("gl")
def test_images_are_drawn_and_compared(version: str, declaration: str, use: str) -> None:
    text = f"#version {version}\n{declaration}\nvoid main() {{ {use} }}\n"
    changed = text.replace("0.0", "0.1").replace(".xy)", ".yx)")
    shader = Shader("x", "fragment", text)
    same, other, broken = draw_all([(shader, text), (shader, changed), (shader, "no GLSL")], 1)
    assert (same.same, same.varied) == (True, True), same.why
    assert other.same is False
    assert "differ" in other.why
    assert broken.same is False
    assert broken.why.startswith("our print: ")


def _drawn_or_dead(pair: tuple[Shader, str]) -> Picture:
    if pair[1] == "dies":
        os.kill(os.getpid(), signal.SIGSEGV)
    return Picture(True)


def test_a_child_that_dies_costs_one_picture() -> None:
    shader = Shader("x", "fragment", FRAGMENT)
    texts = ("lives", "dies", "lives", "dies")
    found = draw_all([(shader, text) for text in texts], 1, _drawn_or_dead)
    assert [picture.same for picture in found] == [True, None, True, None]
    assert found[1].why == "the driver hangs or crashes"


@pytest.mark.xdist_group("gl")
def test_a_shader_that_the_driver_refuses_is_not_drawn() -> None:
    shader = Shader(
        "x", "fragment", "#version 330\nout vec4 o;\nvec4 f();\nvoid main() { o = f(); }"
    )
    (picture,) = draw_all([(shader, shader.text)], 1)
    assert picture.same is None
    assert picture.why


# --- figures --------------------------------------------------------------------------------------


def test_figures_and_failures() -> None:
    shader = Shader("x", "fragment", "")
    fine = dict.fromkeys(("accepted", "typed", "taken again", "by glslang", "stable"), "")
    taken, no = Verdict(""), Verdict("no", 3)
    undeclared = Verdict("SC201 'c' is not declared", 3)
    rows = [
        Row(shader, fine | {"same image": ""}, (taken, taken), "", Picture(True, True)),
        Row(shader, fine | {"same image": "7 pixels differ"}, (taken, taken), "", Picture(False)),
        Row(shader, fine | {"typed": "assigned {}"}, (taken, taken), "", Picture(None, why="'f'")),
        Row(shader, fine | {"by glslang": "no"}, (taken, taken)),
        Row(shader, dict.fromkeys(fine, undeclared.error), (undeclared, taken)),
        Row(shader, {"rejected": "", "same line": ""}, (undeclared, no)),
        Row(shader, {"rejected": "", "same line": "another line"}, (undeclared, Verdict("no", 2))),
        Row(shader, {"rejected": "we accept what glslang rejects"}, (taken, no)),
    ]
    assert figures(rows) == {
        "accepted": (4, 5),
        "typed": (3, 5),
        "taken again": (4, 5),
        "by glslang": (3, 5),
        "stable": (4, 5),
        "same image": (1, 2),
        "all of it": (1, 5),
        "rejected": (2, 3),
        "same line": (1, 2),
    }
    assert {title: len(places) for title, places in failures(rows).items()} == {
        "same image: … pixels differ": 1,
        "typed: assigned {}": 1,
        "by glslang: no": 1,
        "accepted: SC… … is not declared": 1,
        "same line: another line": 1,
        "rejected: we accept what glslang rejects": 1,
    }
    assert "x.frag:3 | another line | SC201 'c' is not declared | no" in str(failures(rows))
    assert "80.00%" in table({"mine": rows})

"""``./dev corpus``: collections from folders, comparison of types and images, figures."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import pytest

from bench.public_shaders.drawing import Picture, draw_all, output_formats
from bench.public_shaders.judge import Verdict, judge
from bench.public_shaders.plain_vertex import plain_vertex
from bench.public_shaders.reading import outcome_of
from bench.public_shaders.report import Row, failures, figures, table
from bench.public_shaders.shaders import (
    Shader,
    distinct,
    evenly,
    evenly_by_folder,
    folder_shaders,
    shaders_of,
)
from bench.public_shaders.typing import compare_types, shape_of
from shadercache.source import Source
from shadercache.valid.read import read

needs_judge = pytest.mark.skipif(
    shutil.which("glslangValidator") is None, reason="glslangValidator is the judge"
)

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


def test_sections_of_a_test_of_piglit() -> None:
    text = "[require]\nGLSL >= 1.30\n[vertex shader]\nint v;\n"
    text += "[fragment shader]\n#version 120\nint f;\n[fragment shader]\nint g;\n[test]\ndraw\n"
    found = list(shaders_of("piglit/a/x.shader_test", text))
    assert [shader.file for shader in found] == [
        f"piglit/a/x.shader_test{end}" for end in (".vert", ".frag", ".2.frag")
    ]
    assert [shader.text for shader in found] == [
        "#version 130\nint v;\n",
        "#version 120\nint f;\n",
        "#version 130\nint g;\n",
    ]
    assert not list(shaders_of("x.shader_test", text + "[shader include]\n"))


def test_choosing_by_folder() -> None:
    shaders = [Shader(f"{at % 2}/{at}", "fragment", f"int a{at};") for at in range(10)]
    assert [shader.name for shader in evenly_by_folder(shaders, 2)] == ["0/0", "0/6", "1/1", "1/7"]
    assert len(evenly_by_folder(shaders, None)) == 10


def test_choosing() -> None:
    shaders = [Shader(f"{number}", "fragment", f"int a{number % 7};") for number in range(10)]
    assert [shader.name for shader in distinct(shaders)] == list("0123456")
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


@needs_judge
def test_types_agree_or_not(tmp_path: Path) -> None:
    shader = Shader("x", "fragment", FRAGMENT)
    judge([shader], tmp_path)
    assert compare_types([shader], tmp_path, 1) == [""]
    # The judge is shown another text than we are.
    other = FRAGMENT.replace("vec3 n = v_normal", "vec2 n = v_normal.xy").replace("(n,", "(n, 0.0,")
    (tmp_path / shader.file).write_text(
        other.replace("uvec2 o_cell", "uvec3 o_cell").replace("uvec2(v_cell)", "uvec3(v_cell, 1)")
    )
    (difference,) = compare_types([shader], tmp_path, 1)
    assert "'o_cell' is uvec3, with us uvec2" in difference
    assert "'vec2': 2" in difference


# --- images ---------------------------------------------------------------------------------------


def test_the_plain_vertex_shader_is_valid_and_feeds_every_input() -> None:
    module, facts = read(Source("test.frag", FRAGMENT))
    text = plain_vertex(module, facts, uses_fixed_function=False)
    read(Source("test.vert", text), "vertex")
    assert text.count(" = ") == 1 + 2 + 2 * 4  # gl_Position, two inputs, two blocks of four.
    assert output_formats(module, facts) == "fuffffff"


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
    assert "differ" in other.why or version == "110"
    assert broken.same is False
    assert "refuses our print" in broken.why


def test_a_child_that_dies_costs_one_picture(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    child = tmp_path / "child"
    child.write_text("#!/bin/sh\nread job && echo '{\"same\": true}'\nkill -SEGV $$\n")
    child.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(child))
    shader = Shader("x", "fragment", FRAGMENT)
    found = draw_all([(shader, FRAGMENT)] * 4, 1)
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


def _row(text: str, verdict: Verdict, **rest: object) -> Row:
    shader = Shader("x", "fragment", text)
    return Row(shader, verdict, outcome_of(shader), **rest)  # type: ignore[arg-type]


def test_figures_and_failures() -> None:
    good = "#version 330\nout vec4 o;\nvoid main() { o = vec4(1.0); }\n"
    bad = good.replace("vec4(1.0)", "c")
    taken, again = Verdict(True), {"reread": Verdict(True)}
    rows = [
        _row(good, taken, **again, picture=Picture(True, True)),
        _row(good, taken, **again, picture=Picture(False, True, "pixels differ")),
        _row(good, taken, **again, typing="assigned {}"),
        _row(good, taken, reread=Verdict(False, 3, "no")),
        _row(bad, taken),
        _row(bad, Verdict(False, 3, "'c' : undeclared")),
        _row(bad, Verdict(False, 2, "elsewhere")),
        _row(good, Verdict(False, 1, "no")),
    ]
    counts = figures(rows)
    assert counts == {
        "shaders": 8,
        "valid": 5,
        "accepted": 4,
        "typed": 3,
        "taken again": 4,
        "taken again by glslang": 3,
        "stable": 4,
        "all of it": 1,
        "drawn": 2,
        "same image": 1,
        "varied": 2,
        "not drawn": 0,
        "invalid": 3,
        "rejected": 2,
        "rejected with a line": 2,
        "same line": 1,
    }
    assert [len(group) for group in failures(rows).values()] == [1] * 6
    assert "80.00 %" in table({"mine": counts})

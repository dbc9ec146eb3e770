"""Files without ``#version``: a precision makes one GLSL ES 1.00, even one that only WebGL sees,
unless words of desktops are in it; anything else is GLSL 1.10."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.analysed import written
from shadercache.compiler import Analysis, analyse, emit_original
from shadercache.diagnostics import InputError
from shadercache.front.parse import parse
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

FOLDER = Path(__file__).parent / "webgl"
WEBGL = ("by_macro", "chosen_precision", "o07_webgl_without_version", "varyings")
WEBGL += ("version_in_comment", "guarded", "guarded_derivatives", "guarded_lod")
IN_PARTS = ("behind_extension", "guarded_by_two", "guarded_words", "vertex_tells", "pair_1_10")
"""Fragment shaders of WebGL with varyings, without a vertex shader or with one of desktops."""

DESKTOP = ("guarded_1_10", "guarded_colour_1_10", "names_1_10")
PAIRS = ("varyings", "vertex_tells")


def source(name: str) -> Source:
    return Source(name, (FOLDER / name).read_text(encoding="utf-8"))


def analysed(name: str) -> Analysis:
    vertex = source(f"{name}.vert") if name in PAIRS else None
    return analyse(source(f"{name}.frag"), vertex)


@pytest.mark.parametrize("name", WEBGL + IN_PARTS)
def test_what_has_a_precision_is_webgl(name: str) -> None:
    module = parse(source(f"{name}.frag"))
    assert (module.version, module.profile) == (100, "es")


@pytest.mark.parametrize("name", DESKTOP)
def test_what_has_none_is_not(name: str) -> None:
    module = parse(source(f"{name}.frag"))
    assert (module.version, module.profile) == (110, None)


@pytest.mark.parametrize("name", WEBGL)
def test_it_is_rewritten_as_one_of_es(name: str) -> None:
    analysis = analysed(name)
    assert any(node.offered for node in analysis.nodes)
    files = emit_original(analysis).files
    assert all(text.startswith("#version 300 es\n") for text in files.values())
    assert (written(analysis) or "").startswith("#version 100\n")


def test_a_file_of_1_10_is_rewritten_as_before() -> None:
    analysis = analysed("guarded_1_10")
    files = emit_original(analysis).files
    assert all(text.startswith("#version 330") for text in files.values())
    assert written(analysis) == analysis.fragment.text


@pytest.mark.parametrize("name", PAIRS)
def test_both_stages_are_what_one_says(name: str) -> None:
    versions = {stage.module.profile for stage in analysed(name).raised}
    assert versions == {"es"}


def test_a_desktop_stage_makes_its_program_one() -> None:
    fragment, vertex = source("pair_1_10.frag"), source("pair_1_10.vert")
    analysis = analyse(fragment, vertex)
    assert {tree.module.profile for tree in analysis.raised} == {"core"}
    named = Source("named.vert", f"#version 120\n{vertex.text}")
    assert {tree.module.profile for tree in analyse(fragment, named).raised} == {"core"}


def test_without_its_macro_it_is_not_webgl() -> None:
    module = parse(source("guarded.frag"), ReadOptions(undefined=("GL_ES",)))
    assert (module.version, module.profile) == (110, None)


def test_a_version_is_believed() -> None:
    text = source("o07_webgl_without_version.frag").text
    with pytest.raises(InputError, match=r"'precision' has no meaning in GLSL 1\.20"):
        parse(Source("x.frag", f"#version 120\n{text}"))
    module = parse(Source("x.frag", f"#version 330\n{text.replace('gl_FragColor', 'o')}"))
    assert module.version == 330


def test_the_other_stage_may_say_so_alone() -> None:
    module = parse(source("vertex_tells.frag"), ReadOptions(webgl=True))
    assert (module.version, module.profile) == (100, "es")


def test_shadertoy_keeps_its_version() -> None:
    text = "precision highp float;\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0, 1); }\n"
    assert parse(Source("x.frag", text), ReadOptions(dialect="auto")).version >= 300


def test_webgl_2_without_a_version_is_told_of_1_00() -> None:
    with pytest.raises(InputError) as caught:
        analyse(source("webgl_2_without_version.frag"))
    text = str(caught.value)
    assert "GLSL ES 3.00" in text and "#version 130" not in text

"""The position of the last frame is computed, however the shader writes ``gl_Position``."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from vertex_stages import (
    REPORTS,
    analysed,
    check_laws,
    hit_rate,
    made_scene,
    names,
    scene_of,
    without_position,
)

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.emit.assemble import Shader
from shadercache.emit.vertex import VertexEmitter
from shadercache.front.parse import parse
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.scene.description import load_scene
from shadercache.source import Source
from shadercache.valid.validate import validate
from tests.cases import cases
from tests.configured import rewritten

FOLDER = REPORTS / "vertex_position"
PAYLOAD = "costly(v_p)"
NAMES = names(FOLDER)

UNDRAWN = ("separate", "es_block")
"""Not drawn: Mesa takes no redeclared ``gl_Position``, and desktop OpenGL no GLSL ES 3.20."""

ALIKE = ("o01_pervertex_redeclared", "instance", "compatibility", "compatibility_block")
ALIKE += ("invariant_alone", "nested", "swizzles", "comma")
"""These write the same position, so they have the same hits."""

PLAIN = "invariant_alone"
LEGAL = ("members", "arguments", "control", "nested", "compatibility_block")


def payload(analysis: Analysis) -> Candidate:
    return next(node for node in analysis.nodes if node.text == PAYLOAD)


@pytest.mark.parametrize("name", NAMES)
def test_every_program_computes_the_last_position(name: str) -> None:
    analysis = analysed(FOLDER, name)
    emission = rewritten(analysis, payload(analysis))
    assert not list(without_position(emission))
    looks = emission.files["2-pass.hit.vert"]
    assert re.search(r"\w+_vertex_previous\(\);", looks)
    for file, text in emission.files.items():
        if file.endswith(".vert"):
            validate(parse(Source(file, text)), Source(file, text), "vertex")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made_scene(FOLDER, tmp_path_factory.mktemp("vertex") / "scene")


@pytest.fixture(scope="module")
def plain_rate(gpu: Gpu, folder: Path) -> float:
    analysis = analysed(FOLDER, PLAIN)
    return hit_rate(gpu, scene_of(folder, PLAIN, analysis), analysis, PAYLOAD)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", [name for name in NAMES if name not in UNDRAWN])
def test_hits_in_a_turning_scene(name: str, gpu: Gpu, folder: Path, plain_rate: float) -> None:
    analysis = analysed(FOLDER, name)
    found = hit_rate(gpu, scene_of(folder, name, analysis), analysis, PAYLOAD)
    assert found > 0.85
    if name in ALIKE:
        assert found == pytest.approx(plain_rate, abs=0.002)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", LEGAL)
def test_laws_2_to_4(name: str, gpu: Gpu, folder: Path) -> None:
    analysis = analysed(FOLDER, name)
    check_laws(gpu, scene_of(folder, name, analysis), analysis, payload(analysis))


def test_no_case_is_without_the_last_position() -> None:
    """One value of each shader of the corpus and of the cases: the vertex shaders are the same."""
    shaders = [analyse_scene(load_scene(data_path("corpus", n)))[1] for n in ("dragon", "trashcan")]
    for name in cases.NAMES:
        try:
            shaders.append(cases.analysed(name))
        except InputError:
            continue
    told = 0
    for analysis in shaders:
        node = next((node for node in analysis.nodes if node.offered), None)
        if node is not None:
            assert not list(without_position(rewritten(analysis, node)))
            told += 1
    assert told > 40


SILENT = {
    "nothing is written": "void main() { v_p = a_position; v_n = a_normal; }",
    "a local of that shape": "void main() { vec4 p = u_mvp[0]; v_p = p.xyz; v_n = a_normal; }",
    "a function that nobody calls": """void place() { gl_Position = u_mvp[0]; }
        void main() { v_p = a_position; v_n = a_normal; }""",
}


@pytest.mark.parametrize("body", SILENT.values(), ids=SILENT.keys())
def test_a_shader_that_never_writes_the_position_is_told_so(body: str) -> None:
    head = (FOLDER / "invariant_alone.vert").read_text("utf-8").partition("invariant")[0]
    fragment = Source("x.frag", (FOLDER / "o01_pervertex_redeclared.frag").read_text("utf-8"))
    with pytest.raises(InputError) as caught:
        analyse(fragment, Source("x.vert", head + body))
    assert [item.code for item in caught.value.diagnostics] == ["SC460"]


def test_a_position_from_an_initialiser_that_does_something_is_refused() -> None:
    head, _, _ = (FOLDER / "invariant_alone.vert").read_text("utf-8").partition("invariant")
    body = """vec4 clip;
        float put() { clip = u_mvp * vec4(a_position, 1.0); return 1.0; }
        float unused = put();
        void main() { v_p = a_position; v_n = a_normal; gl_Position = clip; }"""
    fragment = Source("x.frag", (FOLDER / "o01_pervertex_redeclared.frag").read_text("utf-8"))
    with pytest.raises(InputError, match="SC424"):
        analyse(fragment, Source("x.vert", head + body))


def test_the_emitter_cannot_make_a_program_without_it() -> None:
    module = parse(Source("x.vert", "#version 330\nvoid main() {}\n"))
    analysis = analysed(FOLDER, "nested")
    emitter = VertexEmitter(module, module, "sc_", analysis.program.memo)
    with pytest.raises(AssertionError, match="without the position"):
        emitter.for_fragment(Shader(module, ("sc_current", "sc_previous"), (), ()))

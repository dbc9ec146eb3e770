"""Types and functions that engines take from extensions: read, typed, offered and rewritten."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from shadercache.analysis.refusals import Code
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.source import Source
from shadercache.valid.read import read
from tests.configured import PROOF, configured, rewritten
from tests.glslang import objections

FOLDER = Path(__file__).with_name("engine_types")
PATHS = sorted(FOLDER.glob("*.frag"))
NAMED = pytest.mark.parametrize("path", PATHS, ids=lambda path: path.stem)
EXPLICIT = "#extension GL_EXT_shader_explicit_arithmetic_types : require\n"


@cache
def analysed(path: Path) -> Analysis:
    """What the compiler makes of a sample with its vertex shader."""
    fragment, vertex = (
        Source(file.name, file.read_text(encoding="utf-8"))
        for file in (path, path.with_suffix(".vert"))
    )
    return analyse(fragment, vertex)


def of(name: str) -> Analysis:
    """The analysis of a sample."""
    return analysed(FOLDER / f"{name}.frag")


@NAMED
def test_variants_compile_for_a_value_of_each_type(path: Path, tmp_path: Path) -> None:
    analysis = analysed(path)
    legal = {str(node.type): node for node in analysis.nodes if node.legal}
    assert legal
    for node in legal.values():
        for options in (None, PROOF, configured(adaptive="0.05")):
            files = rewritten(analysis, node, options, unprofitable=True).files
            assert not objections(files.items(), tmp_path), node.text


def test_numbers_of_16_and_8_bits_lie_in_channels() -> None:
    kinds = {str(node.type) for node in of("half_lighting").nodes if node.legal}
    assert kinds >= {"float16_t", "f16vec3", "f16vec4"}
    cells = of("packed_cells")
    legal = {str(node.type): node for node in cells.nodes if node.legal}
    assert legal.keys() >= {"u8vec4", "i16vec3", "uint16_t"}
    emission = rewritten(cells, legal["u8vec4"], unprofitable=True)
    text = "".join(emission.files.values())
    assert "u8vec4(" in text and "uvec3(" in text


def test_half_floats_lie_in_floats_by_their_values() -> None:
    analysis = of("half_lighting")
    node = next(node for node in analysis.nodes if node.legal and str(node.type) == "f16vec3")
    emission = rewritten(analysis, node, algorithms=["1-pass"], unprofitable=True)
    assert emission.manifest.cache.format == "rgba16f"
    text = "".join(emission.files.values())
    assert "vec3(sc_payload)" in text and "f16vec3(" in text


def test_barycentric_coordinates_bind_values_to_the_screen() -> None:
    nodes = of("wireframe").nodes
    bound = [node for node in nodes if "gl_BaryCoordEXT" in node.inputs]
    assert bound and all(node.refusal for node in bound)
    assert {Code.SCREEN} <= {node.refusal.code for node in bound if node.refusal}
    # What one corner of the triangle holds is like a flat varying.
    assert any(node.legal and node.text.startswith("exp(sin(v_tint[0]") for node in nodes)


def test_what_tells_whether_texels_are_there_is_no_value() -> None:
    nodes = of("virtual_texture").nodes
    calls = [node for node in nodes if node.text.startswith("sparseTexture")]
    assert calls and {node.refusal.code for node in calls if node.refusal} == {Code.SIDE_EFFECT}


GOOD = (
    "float16_t h = 1.0hf; float f = h; double d = h; h += int16_t(1);",
    "int16_t s = 3s; uint16_t u = 4us; int i = s + 1; s <<= 1; float q[3]; q[s] = 1.0;",
    "int8_t b = int8_t(3); uint8_t c = uint8_t(b); int16_t s = b; u8vec4 v = u8vec4(c);",
    "int16_t w = pack16(i8vec2(1)); uint x = packFloat2x16(f16vec2(1.0hf));",
    "float32_t f = 1.0; f32vec3 v = vec3(f); f64mat2 m = dmat2(1.0lf); int32_t i = 1; u32vec2 p;",
    "f16mat3x2 m = f16mat3x2(1.0hf); f16vec2 v = m * f16vec3(1.0hf); f16mat2x3 t = transpose(m);",
    "f16vec3 n = reflect(normalize(f16vec3(1.0hf)), cross(f16vec3(0.0hf), f16vec3(1.0hf)));",
    "const int16_t big = 30000s * 2s; const int8_t low = int8_t(200);",
    "uint64_t l = 1ul; int64_t k = 3u; l = pack64(u16vec4(1us));",
)
BAD = {
    "float16_t h = 1.0;": "SC210",
    "int16_t s = 3;": "SC210",
    "int8_t b = 3s;": "SC210",
    "float16_t h = float16_t(1.0) + 1;": "SC205",
    "f16vec2 v = f16vec2(1.0hf) * f16vec3(1.0hf);": "SC205",
    "int16_t s = 70000s;": "SC227",
    "float f = sin(3s);": "SC208",
    "bool b = ~1.0hf > 0.0hf;": "SC205",
}


@pytest.mark.parametrize("line", GOOD)
def test_what_is_right(line: str, tmp_path: Path) -> None:
    text = f"#version 450\n{EXPLICIT}void main() {{ {line} }}\n"
    read(Source("x.frag", text))
    assert not objections([("x.frag", text)], tmp_path)


@pytest.mark.parametrize("line", BAD)
def test_what_is_wrong(line: str, tmp_path: Path) -> None:
    text = f"#version 450\n{EXPLICIT}void main() {{ {line} }}\n"
    with pytest.raises(InputError) as caught:
        read(Source("x.frag", text))
    assert caught.value.diagnostics[0].code == BAD[line]

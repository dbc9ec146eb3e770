"""What only an extension has that is off or unsupported is told with the extension's name."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.diagnostics import InputError
from shadercache.source import Source
from shadercache.valid.read import read

FOLDER = Path(__file__).parent / "extensions"
TYPES = "GL_EXT_shader_explicit_arithmetic_types"


def told(text: str, stage: str = "fragment") -> tuple[str, str]:
    """Code and message of the first mistake of a shader."""
    with pytest.raises(InputError) as caught:
        read(Source("x", text), stage)
    first = caught.value.diagnostics[0]
    return first.code, first.message


NAMED = pytest.mark.parametrize(
    ("name", "word", "extension"),
    [
        ("float16", "float16_t", f"{TYPES}_float16"),
        ("int16", "int16_t", f"{TYPES}_int16"),
        ("sparse", "sparseTextureARB", "GL_ARB_sparse_texture2"),
    ],
)


@NAMED
def test_without_its_extension_a_file_is_refused(name: str, word: str, extension: str) -> None:
    lines = (FOLDER / f"{name}.frag").read_text(encoding="utf-8").splitlines(keepends=True)
    text = "".join(line for line in lines if not line.startswith("#extension"))
    wanted = f"'{word}' is of the extension {extension}, which is not turned on"
    assert told(text) == ("SC111", wanted)


@NAMED
def test_with_its_extension_it_is_read(name: str, word: str, extension: str) -> None:
    text = (FOLDER / f"{name}.frag").read_text(encoding="utf-8")
    assert word in text and extension in text
    read(Source(f"{name}.frag", text))


DECLARATIONS = {
    "f16mat2x3 m;": "_float16",
    "uniform f16mat2x3 m;": "_float16",
    "const f16vec4 c = f16vec4(1.0);": "_float16",
    "in flat uint16_t n;": "_int16",
    "struct S { i16vec2 at; };": "_int16",
    "float f(in i8vec3 p) { return 1.0; }": "_int8",
    "u8vec2 f() { return u8vec2(0); }": "_int8",
    "uint32_t a[2];": "_int32",
    "f64mat3 m;": "_float64",
    "f32vec2 m;": "_float32",
    "float x = 1.0hf;": "_float16",
    "int x = 3s;": "_int16",
}


@pytest.mark.parametrize("line", DECLARATIONS)
def test_types_of_other_sizes(line: str) -> None:
    code, message = told(f"#version 450\n{line}\nvoid main() {{}}\n")
    assert code == "SC111" and f"{TYPES}{DECLARATIONS[line]}, which is not turned on" in message


STATEMENTS = {
    "float x = subgroupAdd(v.x);": "GL_KHR_shader_subgroup_arithmetic",
    "uint x = gl_SubgroupInvocationID;": "GL_KHR_shader_subgroup_basic",
    "float x = min3(v.x, v.y, v.z);": "GL_AMD_shader_trinary_minmax",
    "float x = readFirstInvocationARB(v.x);": "GL_ARB_shader_ballot",
    "uvec2 x = clock2x32ARB();": "GL_ARB_shader_clock",
    "rayQueryEXT q;": "GL_EXT_ray_query",
}


@pytest.mark.parametrize("line", STATEMENTS)
def test_what_stands_in_functions(line: str) -> None:
    head = "#version 450\nin vec3 v;\nuniform sampler2D s;\n"
    code, message = told(f"{head}void main() {{ {line} }}\n")
    assert code == "SC111" and f"{STATEMENTS[line]}, which is not supported" in message


OFF = {
    "float x = float(float16_t(1.0));": f"{TYPES}_float16",
    "for (int16_t i; ;) {}": f"{TYPES}_int16",
    "vec4 t = textureClampARB(s, v.xy, 1.0);": "GL_ARB_sparse_texture_clamp",
    "vec4 t; int c = sparseTextureClampARB(s, v.xy, 1.0, t);": "GL_ARB_sparse_texture_clamp",
    "bool b = sparseTexelsResidentARB(1);": "GL_ARB_sparse_texture2",
    "vec3 b = gl_BaryCoordEXT;": "GL_EXT_fragment_shader_barycentric",
    "vec4 t = texture(ss[nonuniformEXT(1)], v.xy);": "GL_EXT_nonuniform_qualifier",
}


@pytest.mark.parametrize("line", OFF)
def test_what_is_not_turned_on(line: str) -> None:
    head = "#version 450\nin vec3 v;\nuniform sampler2D s, ss[4];\n"
    code, message = told(f"{head}void main() {{ {line} }}\n")
    assert code == "SC111" and f"{OFF[line]}, which is not turned on" in message


def test_a_type_that_is_turned_on_is_no_name() -> None:
    extension = f"#extension {TYPES} : enable\n"
    code, message = told(f"#version 450\n{extension}void main() {{ float float16_t = 1.0; }}\n")
    assert (code, message) == ("SC106", "'float16_t' is a keyword and cannot be a name")


def test_names_of_ones_own_are_no_extension() -> None:
    text = (FOLDER / "unused.frag").read_text(encoding="utf-8")
    read(Source("unused.frag", text))


def test_what_an_extension_would_turn_on_is_told() -> None:
    code, message = told("#version 450\nvoid main() { int64_t x; }\n")
    assert code == "SC111" and "GL_ARB_gpu_shader_int64, which is not turned on" in message
    head = "#version 450\n#extension GL_ARB_gpu_shader_int64 : enable\n"
    read(Source("x", f"{head}void main() {{ int64_t x; }}\n"))


@pytest.mark.parametrize(
    ("stage", "line"),
    [
        ("vertex", "out vec4 gl_Position;"),
        ("vertex", "out float gl_PointSize;"),
        ("vertex", "in int gl_VertexID;"),
        ("vertex", "in int gl_InstanceID;"),
    ],
)
@pytest.mark.parametrize("version", [140, 330, 450])
def test_a_built_in_variable_is_not_declared_again(version: int, stage: str, line: str) -> None:
    with pytest.raises(InputError) as caught:
        read(Source("x", f"#version {version}\n{line}\nvoid main() {{}}\n"), stage)
    (found,) = caught.value.diagnostics
    name = line.rstrip(";").split()[-1]
    assert found.message == f"'{name}' is a built-in variable, which is not declared again"
    assert found.hint is not None and found.hint.startswith("leave it out")
    block = version >= 150 and name in ("gl_Position", "gl_PointSize")
    assert ("out gl_PerVertex" in found.hint) == block


@pytest.mark.parametrize("word", ["buffer_reference", "buffer_reference_align = 16"])
def test_words_of_layouts(word: str) -> None:
    text = f"#version 450\nlayout({word}, std430) buffer R {{ vec4 x; }};\nvoid main() {{}}\n"
    name = word.partition(" ")[0]
    wanted = f"'{name}' is of the extension GL_EXT_buffer_reference, which is not supported"
    assert told(text) == ("SC111", wanted)

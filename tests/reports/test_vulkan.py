"""Vulkan GLSL: ``--dialect vulkan`` reads it, and every node of it has a verdict."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.analysis.refusals import Code
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.read_options import ReadOptions
from shadercache.linking.made_object import open_shader
from shadercache.linking.scene_shaders import analyse_scene
from shadercache.paths import data_path
from shadercache.scene.description import load_scene
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.valid.read import read
from tests.glslang import needs_glslang, vulkan_errors

FOLDER = Path(__file__).with_name("vulkan")
PATHS = sorted(FOLDER.iterdir())
DRAGON = Path(data_path("corpus", "dragon", "scene.toml"))
VULKAN = ReadOptions(dialect="vulkan")


def source_of(path: Path) -> Source:
    return Source(path.name, path.read_text(encoding="utf-8"))


def stage_of(path: Path) -> Stage:
    return "vertex" if path.suffix == ".vert" else "fragment"


def of(name: str) -> Analysis:
    """The analysis of a sample with its vertex shader."""
    paths = [FOLDER / f"{name}{suffix}" for suffix in (".frag", ".vert")]
    fragment, vertex = map(source_of, paths)
    return analyse(fragment, vertex, VULKAN)


@needs_glslang
@pytest.mark.parametrize("path", PATHS, ids=lambda path: path.name)
def test_samples_are_right_and_print_again(path: Path, tmp_path: Path) -> None:
    module, _ = read(source_of(path), stage_of(path), VULKAN)
    printed = print_module(module)
    assert "GL_KHR_vulkan_glsl" not in printed
    file = tmp_path / path.name
    file.write_text(printed, encoding="utf-8")
    assert not vulkan_errors(path) and not vulkan_errors(file)
    again, _ = read(Source("x", printed), stage_of(path), VULKAN)
    assert print_module(again) == printed


@pytest.mark.parametrize("path", PATHS, ids=lambda path: path.name)
def test_without_the_dialect_they_are_told_to_be_vulkans(path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read(source_of(path), stage_of(path))
    (told,) = caught.value.diagnostics
    assert (told.code, told.message) == ("SC112", "this is Vulkan GLSL; --dialect vulkan reads it")


def test_nodes_of_a_forward_pass() -> None:
    nodes = of("pbr").nodes
    kinds = {node.text: node.refusal.code if node.refusal else None for node in nodes}
    combined = [text for text in kinds if text.startswith(("sampler2D", "usampler2D("))]
    assert combined and {kinds[text] for text in combined} == {Code.OPAQUE}
    # An engine chooses the value of a specialisation constant: it is not known, and constant.
    assert kinds["sin(EXPOSURE)"] is Code.CONSTANT
    assert kinds["draw.time"] is Code.UNIFORM
    veins = next(node for node in nodes if node.text.startswith("exp(sin(at.x"))
    assert veins.legal
    textures = next(node for node in nodes if node.text.startswith("textureLod(usampler2D"))
    assert {"u_ids", "u_linear"} <= textures.inputs


def test_what_a_subpass_left_is_of_the_screen() -> None:
    nodes = of("deferred").nodes
    loads = [node for node in nodes if node.text.startswith("subpassLoad(")]
    assert len(loads) == 3
    assert {node.refusal.code for node in loads if node.refusal} == {Code.SCREEN}
    assert next(node for node in nodes if node.text.startswith("exp(")).offered


def test_they_are_not_drawn() -> None:
    scene = load_scene(DRAGON)
    for draw in (
        lambda: analyse_scene(scene, VULKAN),
        lambda: open_shader(FOLDER / "deferred.frag", None, VULKAN, None, FOLDER),
    ):
        with pytest.raises(InputError) as caught:
            draw()
        (told,) = caught.value.diagnostics
        assert told.code == "SC450" and "Vulkan GLSL" in told.message


HEAD = "#version 450\nlayout(location = 0) out vec4 o;\n"
BAD = {
    "uniform float x;": "'x' is a uniform outside of a block, which Vulkan lacks",
    "uniform sampler2D s;": "'s' has no layout(set = ..., binding = ...)",
    "uniform B { vec4 x; };": "'B' has no layout(set = ..., binding = ...)",
    "in vec3 v;": "'v' has no location",
    "in V { vec3 v; } w;": "the block 'V' has no location",
    "layout(binding = 0) uniform atomic_uint c;": "Vulkan has no atomic counters",
    "layout(binding = 0) uniform sampler2DRect r;": "Vulkan has no rectangle textures",
    "layout(binding = 0, shared) uniform B { vec4 x; };": "Vulkan has no layout 'shared'",
    "layout(binding = 0, std430) uniform B { vec4 x; };": "'std430' is for buffers and push",
    "layout(push_constant, binding = 0) uniform B { vec4 x; };": "have neither a set nor a binding",
    "layout(push_constant) buffer B { vec4 x; };": "does not apply to 'buffer' blocks",
    "layout(constant_id = 0) const vec2 c = vec2(1.0);": "'constant_id' is for scalar constants",
    "layout(constant_id = 0) const int a = 1, b = 1;": "share the constant_id 0",
    "layout(buffer_reference, std430) buffer R { vec4 x; };": "which is not supported",
    "layout(constant_id = 0) const int a;": "the constant 'a' has no value",
    "layout(binding = 0) uniform subpassInput s;": "has no layout(input_attachment_index = 0)",
    "layout(input_attachment_index = 0, binding = 0) uniform texture2D t;": "is for subpass inputs",
}


@pytest.mark.parametrize("line", BAD)
def test_declarations_that_vulkan_lacks(line: str, tmp_path: Path) -> None:
    text = f"{HEAD}{line}\nvoid main() {{ o = vec4(1.0); }}\n"
    with pytest.raises(InputError) as caught:
        read(Source("x", text), "fragment", VULKAN)
    assert any(BAD[line] in told.message for told in caught.value.diagnostics)


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("o = texture(t, vec2(0.0));", "SC206"),
        ("o = texture(sampler2D(s, t), vec2(0.0));", "SC219"),
        ("o = texture(sampler3D(t, s), vec3(0.0));", "SC219"),
        ("o = f(sampler2D(t, s));", "SC219"),
        ("float a[N]; a[4] = 1.0;", "SC214"),
        ("o = vec4(gl_NumSamples);", "SC201"),
        ("rayQueryEXT q;", "SC111"),
    ],
)
def test_expressions_that_are_wrong(line: str, code: str) -> None:
    text = (
        f"{HEAD}layout(constant_id = 0) const int N = 4;\n"
        "layout(binding = 0) uniform texture2D t;\nlayout(binding = 1) uniform sampler s;\n"
        "vec4 f(sampler2D c) { return texture(c, vec2(0.0)); }\n"
        f"void main() {{ {line} }}\n"
    )
    with pytest.raises(InputError) as caught:
        read(Source("x", text), "fragment", VULKAN)
    assert code in [told.code for told in caught.value.diagnostics]


@pytest.mark.parametrize(
    "head", ["", "#version 130\n", "#version 300 es\n", "#version 450 compatibility\n"]
)
def test_versions_that_vulkan_lacks(head: str) -> None:
    with pytest.raises(InputError) as caught:
        read(Source("x", f"{head}void main() {{}}\n"), "fragment", VULKAN)
    assert caught.value.diagnostics[0].code == "SC125"


def test_numbers_of_vertices_have_other_names() -> None:
    text = "#version 450\nvoid main() { gl_Position = vec4(NAME); }\n"
    read(Source("x", text.replace("NAME", "gl_VertexIndex + gl_InstanceIndex")), "vertex", VULKAN)
    read(Source("x", text.replace("NAME", "gl_VertexID + gl_InstanceID")), "vertex")
    with pytest.raises(InputError):
        read(Source("x", text.replace("NAME", "gl_VertexID")), "vertex", VULKAN)


def test_the_line_of_the_extension_changes_nothing() -> None:
    text = (
        "#version 450\n#extension GL_KHR_vulkan_glsl : enable\nuniform float x;\nvoid main() {}\n"
    )
    module, _ = read(Source("x", text))
    assert "GL_KHR_vulkan_glsl" not in print_module(module)
    with pytest.raises(InputError):
        read(Source("x", text), "fragment", VULKAN)


def test_plain_glsl_may_use_the_words_as_names() -> None:
    text = "#version 450\nuniform sampler2D texture2D; float sampler = 1.0;\nvoid main() {}\n"
    read(Source("x", text))

"""Dialects: what the host adds, and that the user's places stay the user's."""

from __future__ import annotations

import pytest

from shadercache.ast.nodes import FunctionDef, Name
from shadercache.ast.walk import walk
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.dialects import surrounded
from shadercache.front.parse import parse
from shadercache.front.read_options import Dialect, ReadOptions
from shadercache.source import Source
from shadercache.valid.validate import validate

TOY = """\
// A toy.
float wave(float t) { return sin(t * 6.28); }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    fragColor = texture(iChannel0, uv) * wave(iTime + iDate.w) + iMouse;
}
"""


def read(text: str, dialect: Dialect = "auto") -> str:
    """What is printed of a shader that is parsed and checked."""
    source = Source("toy.glsl", text)
    module = parse(source, ReadOptions(dialect=dialect))
    validate(module, source)
    return print_module(module)


@pytest.mark.parametrize("dialect", ["shadertoy", "auto"])
def test_the_host_declares_and_calls(dialect: Dialect) -> None:
    printed = read(TOY, dialect)
    assert printed.startswith("#version 330\n")
    assert "uniform vec3 iResolution;" in printed
    assert printed.endswith("void main() {\n    mainImage(shadertoyColor, gl_FragCoord.xy);\n}\n")
    assert read(printed, "glsl") == printed


def test_every_name_of_the_host_can_be_used() -> None:
    body = (
        "c = vec4(iResolution, iTime) + iTimeDelta + iFrameRate + float(iFrame) + iMouse + iDate"
        " + iChannelTime[3] + iChannelResolution[3].x + iSampleRate + texture(iChannel0, p)"
        " + texture(iChannel1, p) + texture(iChannel2, p) + texture(iChannel3, p);"
    )
    read(f"void mainImage(out vec4 c, in vec2 p) {{ {body} }}", "shadertoy")


@pytest.mark.parametrize(
    "declared", ("uniform float iTime;", "uniform highp float iTime;", "uniform float a, iTime;")
)
def test_what_the_user_declares_the_host_does_not(declared: str) -> None:
    printed = read(f"{declared}\nvoid mainImage(out vec4 c, in vec2 p) {{ c = vec4(iTime); }}")
    assert printed.count(" iTime;") == 1 and "iResolution" in printed


def test_spans_are_those_of_the_users_file() -> None:
    source = Source("toy.glsl", TOY)
    module = parse(source, ReadOptions(dialect="shadertoy"))
    for node in walk(module):
        if isinstance(node, Name):
            text = TOY[node.span.start : node.span.end]
            assert text in (node.name, "")
            assert text or node.span.start in (0, len(TOY))
    user = [d for d in module.decls if isinstance(d, FunctionDef) and d.span.start != d.span.end]
    assert [TOY[d.span.start : d.span.start + 9] for d in user] == ["float wav", "void main"]


def test_a_mistake_is_told_at_the_users_line() -> None:
    with pytest.raises(InputError) as caught:
        read(TOY.replace("iTime", "iTme"))
    (only,) = caught.value.diagnostics
    assert only.render().startswith("toy.glsl:6:47: error: ")


def test_without_the_dialect_the_names_are_unknown() -> None:
    with pytest.raises(InputError):
        read(TOY, "glsl")


@pytest.mark.parametrize(
    "text",
    [
        "#version 330\nout vec4 o;\nvoid mainImage(out vec4 c, in vec2 p) { c = p.xyxy; }\n"
        "void main() { mainImage(o, gl_FragCoord.xy); }\n",
        "#version 330\nvoid main() {} // void mainImage(out vec4 c, in vec2 p)\n",
        "#version 330\n/* void mainImage() */ void main() {}\n",
    ],
)
def test_auto_leaves_a_file_with_main_alone(text: str) -> None:
    assert read(text, "auto") == read(text, "glsl")


def test_a_main_in_a_comment_does_not_count() -> None:
    assert "shadertoyColor" in read("// void main() {}\n" + TOY, "auto")


def test_a_uniform_of_the_user_replaces_the_hosts() -> None:
    text = "uniform samplerCube iChannel0;\n" + TOY.replace("iChannel0, uv", "iChannel0, uv.xyx")
    printed = read(text)
    assert printed.count("iChannel0;") == 1
    assert "uniform samplerCube iChannel0;" in printed


def test_a_file_with_main_is_not_shadertoys() -> None:
    with pytest.raises(InputError) as caught:
        read("// x\nvoid main() {}\n" + TOY, "shadertoy")
    (only,) = caught.value.diagnostics
    assert only.render().startswith("toy.glsl:2:6: error: a file of Shadertoy has 'mainImage'")
    assert only.code == "SC125"


@pytest.mark.parametrize("version", ["100", "120", "300 es"])
def test_a_version_that_the_host_cannot_be_read_in(version: str) -> None:
    with pytest.raises(InputError) as caught:
        read(f"#version {version}\n" + TOY, "auto")
    (only,) = caught.value.diagnostics
    assert (only.code, only.hint) == ("SC125", "leave the #version out")


def test_without_the_dialect_it_is_hinted_at() -> None:
    with pytest.raises(InputError) as caught:
        read(TOY, "glsl")
    first = caught.value.diagnostics[0]
    assert first.hint == "files of Shadertoy are read with --dialect shadertoy"


def test_a_version_of_the_user_stays() -> None:
    assert read("#version 420\n" + TOY).startswith("#version 420\n")


def test_a_version_in_a_comment_is_none() -> None:
    toy = "/*\n#version 100 */\nvoid mainImage(out vec4 c, in vec2 p) { c = p.xyxy; }\n"
    text = surrounded(Source("toy.glsl", toy), "shadertoy")
    assert text.startswith("#version 330\n") and text.count("#version 100 */") == 1
    own = surrounded(Source("toy.glsl", f"#version 400\n{toy}"), "shadertoy")
    assert own.startswith("#version 400\n") and "#version 330" not in own

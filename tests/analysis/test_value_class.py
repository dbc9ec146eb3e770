"""Surface, view and screen: what values depend on, and which of them ``--approximate`` offers."""

from __future__ import annotations

import pytest
from shaders import INTERFACE, find

from shadercache.analysed import value_classes
from shadercache.analysis.value_class import is_of_view
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

HEAD = """
#extension GL_ARB_sample_shading : enable
noperspective in vec2 v_linear;
in vec4 v_clip;
in vec3 v_eye;
in vec3 v_world;
in float v_far;
uniform vec3 u_eye;
uniform vec3 u_lightView;
float wave(vec3 p) { return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7) * cos(p.x); }
struct Frame { vec3 x; vec3 y; };
Frame frame(vec3 p) { return Frame(dFdx(p), dFdy(p)); }
void slope(vec3 p, out float to) { to = fwidth(p.x); }
"""
VERTEX = """#version 330
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_proj;
uniform mat4 u_view;
uniform mat4 u_model;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
noperspective out vec2 v_linear;
out vec4 v_clip;
out vec3 v_eye;
out vec3 v_world;
out float v_far;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_position.xy;
    v_linear = v_uv;
    vec4 world = u_model * vec4(a_position, 1.0);
    v_world = world.xyz;
    v_eye = (u_view * world).xyz;
    gl_Position = u_proj * u_view * world;
    v_clip = gl_Position;
    v_far = gl_Position.w;
}
"""
OFFERED = (
    ("", "wave(dFdx(v_position))"),
    ("", "wave(vec3(fwidth(v_uv), 1.0))"),
    ("vec3 g = cross(dFdx(v_position), dFdy(v_position));", "wave(normalize(g))"),
    ("Frame f = frame(v_position);", "wave(f.x)"),
    ("vec3 a[2] = vec3[](dFdx(v_position), v_normal);", "wave(a[0])"),
    ("float to; slope(v_position, to);", "wave(vec3(to))"),
    ("", "wave(gl_FragCoord.xyz)"),
    ("", "wave(vec3(gl_FragCoord.w))"),
    ("vec3 n = gl_FrontFacing ? v_normal : -v_normal;", "wave(n)"),
    ("", "wave(vec3(gl_PrimitiveID))"),
    ("", "wave(vec3(v_linear, 1.0))"),
    ("vec2 screen = v_clip.xy / v_clip.w;", "wave(vec3(screen, 1.0))"),
    ("", "wave(v_clip.xyz)"),
    ("", "textureGrad(u_map, v_uv, dFdx(v_uv), dFdy(v_uv)).x * wave(v_position)"),
)
REFUSED = (
    ("", "wave(vec3(gl_PointCoord, 1.0))", "SC313"),
    ("", "wave(vec3(gl_SampleID))", "SC313"),
    ("", "wave(dFdx(v_position) + vec3(gl_PointCoord, 1.0))", "SC313"),
    ("float a = wave(v_position);", "fwidth(a) * wave(v_normal)", None),
    ("float a = wave(v_position); v = fwidth(a);", "wave(v_position)", "SC315"),
    ("float s = dFdx(u_time) + u_time;", "sin(s) * cos(s) * sin(s * 2.0) * cos(s * 3.0)", "SC303"),
)


def made(before: str, text: str, *, approximate: bool = True) -> Analysis:
    body = f"float v = 0.0; {before} o_color = vec4({text}) + v;"
    source = f"{INTERFACE}{HEAD}void main() {{\n{body}\n}}\n"
    reading = ReadOptions(approximate=approximate)
    return analyse(Source("test.frag", source), Source("test.vert", VERTEX), reading)


@pytest.mark.parametrize(("before", "text"), OFFERED, ids=[text for _, text in OFFERED])
def test_offered_on_request_alone(before: str, text: str) -> None:
    plain, asked = made(before, text, approximate=False), made(before, text)
    node = find(plain, text)
    assert node.refusal is not None and node.refusal.code.code in ("SC312", "SC313")
    assert node.refusal.approximable and node.on_screen and not node.approximate
    with pytest.raises(InputError) as caught:
        plain.require_all([node])
    assert "--approximate" in (caught.value.diagnostics[0].hint or "")
    assert find(asked, text).offered and find(asked, text).approximate
    for analysis in (plain, asked):
        assert value_classes(analysis, None)(find(analysis, text)) == "screen"


@pytest.mark.parametrize(("before", "text", "code"), REFUSED, ids=[text for _, text, _ in REFUSED])
def test_what_stays_refused(before: str, text: str, code: str | None) -> None:
    refusal = find(made(before, text), text).refusal
    assert (refusal and refusal.code.code) == code
    assert refusal is None or not refusal.approximable


@pytest.mark.parametrize("mapping", ["surface", "screen"])
def test_by_the_pixel_only_derivatives_are_of_the_screen(mapping: str) -> None:
    text = f"{INTERFACE}{HEAD}void main() {{ o_color = vec4(wave(gl_FragCoord.xyz))"
    text += " + vec4(wave(dFdx(gl_FragCoord.xyz))); }"
    source, reading = Source("test.frag", text), ReadOptions(approximate=True)
    analysis = analyse(source, Source("test.vert", VERTEX), reading, mapping)  # type: ignore[arg-type]
    assert find(analysis, "wave(gl_FragCoord.xyz)").approximate == (mapping == "surface")
    assert find(analysis, "wave(dFdx(gl_FragCoord.xyz))").approximate


CLASSES = {
    "wave(v_position)": "surface",
    "wave(v_world)": "surface",
    "wave(v_position * u_time)": "surface",
    "wave(v_position + u_lightView)": "surface",
    "wave(v_eye)": "view",
    "wave(v_position - u_eye)": "view",
    "wave(vec3(v_far))": "view",
    "wave(v_eye + dFdx(v_position))": "screen",
}


@pytest.mark.parametrize("text", CLASSES)
def test_classes(text: str) -> None:
    analysis = made("", text)
    assert value_classes(analysis, None)(find(analysis, text)) == CLASSES[text]


def test_a_scene_knows_better_than_names() -> None:
    analysis = made("", "wave(v_position - u_eye) + wave(v_position * u_tint)")
    told = value_classes(analysis, {"u_tint": "view", "u_eye": "light"})
    assert told(find(analysis, "wave(v_position - u_eye)")) == "surface"
    assert told(find(analysis, "wave(v_position * u_tint)")) == "view"


def test_names_of_the_view() -> None:
    of_view = ("u_eye", "cameraPosition", "modelViewMatrix", "u_mvp", "uViewPos", "normalMatrix")
    others = ("u_model", "u_lightView", "viewport", "u_viewPort", "u_normals", "u_review", "u_time")
    assert [name for name in of_view + others if is_of_view(name)] == list(of_view)

"""What varyings are by their names and types, and the vertex shaders that give them."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.diagnostics import UsageError
from shadercache.front.read_options import ReadOptions
from shadercache.lang.types import Type, builtin_type
from shadercache.linking.made_parts.made_vertex import made_vertex
from shadercache.linking.made_parts.varying_meanings import habits_of, meaning_of
from shadercache.source import Source
from shadercache.valid.read import read

PLAIN = habits_of([], sees=False)


def kind(name: str) -> Type:
    found = builtin_type(name)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("names", "spelt", "function"),
    [
        ("uv vUv v_uv TexCoords vTexCoord fragTexCoord st v_texcoord0", "vec2", "uv"),
        ("uv2 v_texCoord1 lightmapUv", "vec2", "uv1"),
        ("normal vNormal v_normal Normal fragNormal outNormal vWorldNormal normalW", "vec3",
         "world_normal"),
        ("vViewNormal normalView eyeNormal", "vec3", "view_normal"),
        ("vObjectNormal localNormal", "vec3", "object_normal"),
        ("vTangent v_tangent", "vec4", "world_tangent"),
        ("vBitangent Binormal", "vec3", "world_bitangent"),
        ("TBN vTbn tangentToWorld", "mat3", "world_frame"),
        ("FragPos vWorldPos worldPosition v_worldPos fragPosition positionWS", "vec3",
         "world_position"),
        ("WorldPos", "vec4", "world_position"),
        ("vPos position v_position vLocalPosition pos", "vec3", "object_position"),
        ("viewPos mvPosition eyePosition positionVS", "vec3", "view_position"),
        ("viewDir vToEye eyeDirection cameraVec vView", "vec3", "world_to_eye"),
        ("vViewPosition", "vec3", "view_to_eye"),
        ("vColor vertexColor colour tint", "vec4", "color"),
        ("depth vFogDepth", "float", "depth"),
        ("clipSpace screenPos", "vec4", "clip"),
        ("FragPosLightSpace shadowCoord lightDir reflected thing prevClip instanceColor",
         "vec4", None),
        ("uv normal", "float", None),
        ("normal position", "ivec3", None),
        ("model", "mat4", None),
    ],
)  # fmt: skip
def test_by_name_and_type(names: str, spelt: str, function: str | None) -> None:
    found = {}
    for name in names.split():
        meaning = meaning_of(name, kind(spelt), PLAIN)
        found[name] = meaning and meaning.function
    assert found == dict.fromkeys(names.split(), function)


@pytest.mark.parametrize(
    ("varyings", "sees", "functions"),
    [
        # Lighting with the eye's place is done in the world.
        (("vPosition", "vNormal"), True, ("world_position", "world_normal")),
        (("vPosition", "vWorldPos"), True, ("object_position", "world_position")),
        # With a position of the view it is done there.
        (("vNormal", "vViewPosition"), False, ("view_normal", "view_to_eye")),
        (("vNormal", "vViewPosition"), True, ("world_normal", "view_to_eye")),
    ],
)
def test_spaces(varyings: tuple[str, ...], sees: bool, functions: tuple[str, ...]) -> None:
    habits = habits_of(varyings, sees)
    meanings = [meaning_of(name, kind("vec3"), habits) for name in varyings]
    assert tuple(meaning and meaning.function for meaning in meanings) == functions


def test_the_language_is_the_fragment_shaders() -> None:
    made = Path(__file__).parent / "made"
    for name, head, word in (
        ("alone.frag", "#version 410 core\n", "out vec3 FragPos;"),
        ("alone_es.frag", "#version 300 es\n", "out mediump vec3 vNormal;"),
        ("alone_120.frag", "#version 120\n", "varying vec3 position, normal;"),
        ("alone_100.frag", "attribute", "varying vec2 v_texcoord;"),
    ):
        source = Source(name, (made / name).read_text())
        text = made_vertex(source, ReadOptions()).text
        assert text.startswith(head) and word in text
        assert "unread" not in text


def test_places_are_handed_on() -> None:
    source = Source("a.frag", (Path(__file__).parent / "made" / "alone.frag").read_text())
    made = made_vertex(source, ReadOptions())
    assert "layout(location = 3) out vec2 uv;" in made.text
    # The fragment shader has a uniform of that name, and another of its own.
    assert "in vec3 m_a_position;" in made.text and "m_u_eye - m_made_world_position()" in made.text
    assert "vertexColor is taken for the colour of the vertex" in made.notes
    module, _ = read(Source("a.vert", made.text), "vertex")
    assert module.version == 410


def test_what_is_not_known_is_told_where_it_is() -> None:
    text = """#version 330
in vec3 normal;
in vec3 thing;
in Rest { vec2 uv; float sway; vec4 unread; } rest;
out vec4 color;
void main() { color = vec4(normal + thing, rest.sway) + rest.uv.xyxy; }
"""
    with pytest.raises(UsageError) as caught:
        made_vertex(Source("a.frag", text), ReadOptions())
    first, second = (one.render() for one in caught.value.diagnostics)
    assert "a.frag:3:9: error: there is no vertex shader" in first
    assert "what thing (vec3) is [SC005]" in first and "with --vert" in first
    assert "a.frag:4:26" in second and "what rest.sway (float) is" in second


@pytest.mark.parametrize("name", ["gl_Color", "gl_TexCoord[0]"])
def test_what_the_fixed_pipeline_hands_on_is_not_made(name: str) -> None:
    text = f"#version 120\nvoid main() {{ gl_FragColor = {name}; }}\n"
    with pytest.raises(UsageError, match=f"{name.partition('[')[0]}.*SC005"):
        made_vertex(Source("a.frag", text), ReadOptions())

"""What each mapping offers, and what is said of functions that the user's mapping cannot call."""

from __future__ import annotations

import re

import pytest

from shadercache.analysed import unchanged_for
from shadercache.analysis.candidates import OF_PIXEL, Candidate
from shadercache.analysis.mapping import MappingKind
from shadercache.caching.configuration import Mode
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from tests.configured import configured, rewritten

HEAD = """#version 330
uniform vec2 u_size;
uniform float u_time, u_gain;
uniform sampler2D u_map;
out vec4 o_color;
float wave(vec2 p) { return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.x * 4.7 + cos(p.x)); }
"""
VERTEX = """#version 330
in vec3 a_position;
uniform mat4 u_matrix;
uniform float u_stretch;
out vec3 v_position;
out vec3 v_other;
void main() {
    v_position = u_stretch * a_position;
    v_other = a_position;
    gl_Position = u_matrix * vec4(a_position, 1.0);
}
"""
PREVIOUS = """vec4 scPreviousClip() {
    return vec4(2.0 * gl_FragCoord.xy / u_size - 1.0, 0.0, 1.0);
}
"""


def made(body: str, mapping: MappingKind | None, head: str = "", vertex: str = "") -> Analysis:
    text = f"{HEAD}{head}void main() {{ {body} }}\n"
    stage = Source("test.vert", vertex) if vertex else None
    return analyse(Source("test.frag", text), stage, mapping=mapping)


def node(analysis: Analysis, text: str) -> Candidate:
    return next(item for item in analysis.nodes if item.text == text)


def verdict(analysis: Analysis, text: str) -> str | None:
    refusal = node(analysis, text).refusal
    return refusal and refusal.code.code


def test_the_mapping_that_is_taken() -> None:
    flat = "o_color = vec4(wave(gl_FragCoord.xy));"
    assert made(flat, None).mapping == "screen"
    assert made(flat, None, vertex=VERTEX).mapping == "surface"
    assert made(flat, None, "in vec3 v_position;\n").mapping == "surface"
    assert made(flat, None, "in vec4 gl_FragCoord;\n").mapping == "screen", "no varying of its own"
    assert made(flat, "screen", vertex=VERTEX).mapping == "screen"
    toy = Source("toy.frag", "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.x); }\n")
    shadertoy = ReadOptions(dialect="shadertoy")
    assert analyse(toy, Source("toy.vert", VERTEX), shadertoy).mapping == "screen"
    assert made(flat, "surface").mapping == "surface"


@pytest.mark.parametrize("mapping", ["surface", "screen"])
def test_what_is_bound_to_the_pixel(mapping: MappingKind) -> None:
    values = {
        "gl_FragCoord": "wave(gl_FragCoord.xy)",
        "gl_FrontFacing": "wave(vec2(gl_FrontFacing))",
        "gl_PointCoord": "wave(gl_PointCoord)",
        "gl_PrimitiveID": "wave(vec2(gl_PrimitiveID))",
    }
    assert values.keys() == OF_PIXEL
    for name, text in values.items():
        found = verdict(made(f"o_color = vec4({text});", mapping), text)
        assert found == ("SC313" if mapping == "surface" else None), name


def test_what_no_mapping_offers() -> None:
    head = "#extension GL_ARB_sample_shading : enable\n"
    body = "o_color = vec4(wave(vec2(gl_SampleID)) * wave(u_size) * wave(dFdx(gl_FragCoord.xy)));"
    text = HEAD.replace("330\n", f"330\n{head}") + f"void main() {{ {body} }}\n"
    analysis = analyse(Source("test.frag", text), mapping="screen")
    assert verdict(analysis, "wave(vec2(gl_SampleID))") == "SC313"
    assert verdict(analysis, "wave(u_size)") == "SC303"
    assert verdict(analysis, "wave(dFdx(gl_FragCoord.xy))") == "SC312"


def test_the_users_mapping_takes_the_pixel_for_what_is_shown_only_without_varyings() -> None:
    text = "wave(gl_FragCoord.xy)"
    body = f"o_color = vec4({text});"
    assert verdict(made(body, "user", PREVIOUS), text) is None
    body += "o_color += wave(v_position.xy);"
    mixed = made(body, "user", f"in vec3 v_position;\n{PREVIOUS}")
    assert verdict(mixed, text) == "SC313"
    assert verdict(mixed, "wave(v_position.xy)") is None
    facing = "wave(vec2(gl_FrontFacing))"
    assert verdict(made(f"o_color = vec4({facing});", "user", PREVIOUS), facing) == "SC313"


def test_while_what_does_not_change_reuse_is_exact() -> None:
    head = "in vec3 v_position;\nin vec3 v_other;\nconst float BASE = 2.0;\nfloat scale = u_gain;\n"
    body = """
        float a = wave(gl_FragCoord.xy / u_size * BASE);
        float b = wave(v_position.xy) * textureLod(u_map, gl_FragCoord.xy, 0.0).x;
        float c = wave(gl_FragCoord.xy * scale);
        o_color = vec4(a + b + c + u_time);
    """
    flat = made(body.replace("v_position.xy", "vec2(u_time)"), "screen", head.split("\n", 2)[2])
    names = {"a": {"u_size"}, "b": {"u_time", "u_map"}, "c": {"u_gain"}}
    for text, wanted in names.items():
        assert set(unchanged_for(flat, (node(flat, text),)) or ()) == wanted
    solid = made(body, "screen", head, VERTEX)
    geometry = {"a_position", "u_matrix"}
    assert set(unchanged_for(solid, (node(solid, "a"),)) or ()) == {"u_size", *geometry}
    assert set(unchanged_for(solid, (node(solid, "b"),)) or ()) == {"u_map", "u_stretch", *geometry}
    surface = made(body, "surface", head, VERTEX)
    assert unchanged_for(surface, (node(solid, "a"),)) is None


WRONG = {
    "missing": ("", "SC420", "needs a function 'vec4 scPreviousClip()'"),
    "declared only": ("vec4 scPreviousClip();\n", "SC420", "needs a function"),
    "another type": ("vec3 scPreviousClip() { return vec3(0.0); }\n", "SC420", "declared as 'vec4"),
    "an array": ("vec4[2] scPreviousClip() { return vec4[2](vec4(0.0), vec4(1.0)); }\n", "SC420",
                 "declared as 'vec4"),
    "parameters": ("vec4 scPreviousClip(vec4 p) { return p; }\n", "SC420", "declared as 'vec4"),
    "the other one": (PREVIOUS + "float scCurrentClip() { return 1.0; }\n", "SC420",
                      "'scCurrentClip' has to be declared as 'vec4 scCurrentClip()'"),
    "reads what changes": ("vec4 scPreviousClip() { return shown; }\n", "SC421",
                           "reads what the shader changes: shown"),
    "reads the colour": ("vec4 scPreviousClip() { return o_color; }\n", "SC421", "o_color"),
    "changes": ("vec4 scPreviousClip() { kept = vec4(1.0); return vec4(1.0); }\n", "SC421",
                "changes global variables: kept"),
    "in a call": ("vec4 f() { return shown; }\nvec4 scPreviousClip() { return f(); }\n", "SC421",
                  "reads what the shader changes: shown"),
    "derivative": ("vec4 scPreviousClip() { return dFdx(gl_FragCoord); }\n", "SC421",
                   "takes a derivative"),
    "level of detail": ("vec4 scPreviousClip() { return texture(u_map, u_size); }\n", "SC421",
                        "implicit level of detail"),
    "discard": ("vec4 scPreviousClip() { if (u_time > 1.0) discard; return vec4(1.0); }\n", "SC421",
                "discards the fragment"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_functions_that_the_look_up_cannot_call(name: str) -> None:
    function, code, words = WRONG[name]
    body = "shown = gl_FragCoord; o_color = shown * wave(gl_FragCoord.xy);"
    with pytest.raises(InputError) as caught:
        made(body, "user", f"vec4 shown, kept;\n{function}")
    assert [item.code for item in caught.value.diagnostics] == [code]
    assert words in str(caught.value)
    if name == "missing":
        made(body, "screen", f"vec4 shown, kept;\n{function}")


def test_what_the_functions_may_do() -> None:
    head = "vec2 offset = u_size * 0.5;\nvec4 shown;\n" + PREVIOUS.replace(
        "- 1.0, 0.0", "- offset + textureLod(u_map, u_size, 0.0).xy, 0.0"
    )
    found = made("shown = gl_FragCoord; o_color = shown * wave(gl_FragCoord.xy);", "user", head)
    assert verdict(found, "wave(gl_FragCoord.xy)") is None


@pytest.mark.parametrize("mode", ["plain", "proof"])
def test_the_functions_survive_every_pass_that_renames(mode: Mode) -> None:
    """Overloads, names of ours, macros, a host around it, an older version."""
    toy = """
        #define PLACE (2.0 * gl_FragCoord.xy / iResolution.xy - 1.0)
        float sc_payload = 1.0;
        vec2 place(float scPrevious) { return PLACE + scPrevious; }
        vec2 place(int i) { return place(float(i)); }
        vec4 scPreviousClip() { return vec4(place(0) * sc_payload, 0.0, 1.0); }
        vec4 scCurrentClip() { return vec4(place(0.0) * sc_payload, 0.0, 1.0); }
        void mainImage(out vec4 color, in vec2 place) {
            color = vec4(sin(place.x) * cos(place.y) * sin(place.x + 3.0 * cos(place.y)));
        }
    """
    old = """#version 120
        uniform vec2 texture;
        vec4 scPreviousClip() { return vec4(2.0 * gl_FragCoord.xy / texture - 1.0, 0.0, 1.0); }
        void main() {
            vec2 p = gl_FragCoord.xy;
            gl_FragColor = vec4(sin(p.x) * cos(p.y) * sin(p.x + 3.0 * cos(p.y)));
        }
    """
    for text, dialect in ((toy, "shadertoy"), (old, "glsl")):
        reading = ReadOptions(dialect="shadertoy" if dialect == "shadertoy" else "glsl")
        analysis = analyse(Source("test.frag", text), None, reading, "user")
        offered = next(item for item in analysis.nodes if item.offered)
        files = rewritten(analysis, offered, configured(mode=mode)).files
        for file in ("1-pass.frag", "2-pass.hit.frag", "3-pass.reuse.frag", "hit-mask.frag"):
            assert "vec4 scPreviousClip() {" in files[file]
            assert re.search(r"sc1?_previous = scPreviousClip\(\);", files[file])
        for file in ("1-pass.frag", "2-pass.miss.frag", "3-pass.payload.frag"):
            assert ("= scCurrentClip();" in files[file]) == (dialect == "shadertoy")
        assert "scPreviousClip" not in files["2-pass.miss.frag"] + files["3-pass.shade.frag"]


def test_pixels_that_are_counted_in_another_way() -> None:
    for word in ("origin_upper_left", "pixel_center_integer"):
        head = f"layout({word}) in vec4 gl_FragCoord;\n"
        with pytest.raises(InputError, match="SC422"):
            made("o_color = vec4(wave(gl_FragCoord.xy));", None, head)

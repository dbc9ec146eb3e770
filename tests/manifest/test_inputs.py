"""What the engine gives: blocks told apart from uniforms, with their places, and twins."""

from __future__ import annotations

import json
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from manifests import SCHEMA, plain

from shadercache.compiler import analyse
from shadercache.manifest.codec import decode
from shadercache.manifest.interface import (
    CounterInput,
    ImageInput,
    SamplerInput,
    StorageBlockInput,
)
from shadercache.manifest.reflection import inputs_of as reflected
from shadercache.source import Source
from shadercache.valid.read import read
from tests.configured import rewritten

FRAGMENT = """#version 450
{declared}
in vec3 v_p;
layout(location = 0) out vec4 o;
float wave(vec3 p) {{ return sin(p.x * 9.0) * cos(exp(p.y) + sin(p.z * 3.0)); }}
void main() {{ o = vec4(wave(v_p)) * ({read}); }}
"""
VERTEX = """#version 450
{declared}
in vec3 a_position;
out vec3 v_p;
void main() {{ v_p = a_position; gl_Position = {matrix} * vec4(a_position, 1.0); }}
"""


def manifest_of(
    declared: str = "uniform mat4 u_m;", matrix: str = "u_m", more: str = "", read: str = "1.0"
) -> dict[str, Any]:
    """Of ``wave(v_p)``; ``declared`` in the vertex shader, ``more`` in the fragment shader."""
    analysis = analyse(
        Source("t.frag", FRAGMENT.format(declared=more, read=read)),
        Source("t.vert", VERTEX.format(declared=declared, matrix=matrix)),
    )
    node = next(node for node in analysis.nodes if node.offered and node.text == "wave(v_p)")
    manifest = plain(rewritten(analysis, node).manifest)
    Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(manifest)
    return manifest


def inputs_of(*shader: str, **more: str) -> dict[str, dict[str, Any]]:
    return {item["name"]: item for item in manifest_of(*shader, **more)["inputs"]}


def block(text: str, read: str) -> dict[str, Any]:
    return inputs_of(text, read)["B"]


@pytest.mark.parametrize(
    ("text", "read", "told"),
    [
        ("uniform B { mat4 m; };", "m", {"packing": "shared", "binding": None, "instance": None}),
        ("layout(packed) uniform B { mat4 m; } b;", "b.m", {"packing": "packed", "instance": "b"}),
        ("layout(STD140, binding = 3) uniform B { mat4 m; };", "m", {"packing": "std140"}),
        ("layout(std140, binding = 3) uniform B { mat4 m; };", "m", {"binding": 3, "dims": []}),
        ("uniform B { mat4 m; } b[2];", "b[1].m", {"dims": [2]}),
        ("uniform B { mat4 m; } b[2][3];", "b[1][2].m", {"dims": [2, 3]}),
        ("layout(row_major) uniform B { mat4 m; };", "m", {"matrices": "row_major"}),
        ("layout(std140) uniform; uniform B { mat4 m; };", "m", {"packing": "std140"}),
        (
            "layout(std140) uniform; uniform B { mat4 m; }; layout(shared) uniform;",
            "m",
            {"packing": "std140"},
        ),
        (
            "layout(std140, row_major) uniform; layout(column_major) uniform B { mat4 m; };",
            "m",
            {"packing": "std140", "matrices": "column_major"},
        ),
    ],
)
def test_a_block_and_its_twin(text: str, read: str, told: dict[str, Any]) -> None:
    inputs = inputs_of(text, read)
    found, twin = inputs["B"], inputs["sc_previous_B"]
    assert found["kind"] == twin["kind"] == "uniform block"
    assert told.items() <= found.items()
    assert twin["previous_of"] == "B"
    # A place of its own, where the other one has one.
    assert twin["binding"] == (None if found["binding"] is None else found["binding"] + 1)
    for key in ("dims", "packing", "matrices"):
        assert twin[key] == found[key]
    assert twin["takes_the_last_buffer"] == (found["packing"] != "packed")
    assert twin["instance"] == (found["instance"] and f"sc_previous_{found['instance']}")
    prefix = "" if found["instance"] else "sc_previous_"
    assert [item["name"] for item in found["members"]] == ["m"]
    assert [item["name"] for item in twin["members"]] == [f"{prefix}m"]


def test_members_with_layouts_and_structs() -> None:
    declared = "struct S { vec2 a; float b[2]; }; uniform B { layout(row_major) mat4 m; S s[3]; };"
    assert block(declared, "m")["members"] == [
        {"name": "m", "type": "mat4", "layout": "row_major"},
        {
            "name": "s",
            "type": "S[3]",
            "dims": [3],
            "read": False,
            "members": [
                {"name": "a", "type": "vec2"},
                {"name": "b", "type": "float[2]", "dims": [2]},
            ],
        },
    ]
    placed = declared.replace("row_major", "offset = 64").replace(
        "uniform", "layout(std140) uniform"
    )
    first, second = block(placed, "m")["members"]
    assert (first["layout"], first["offset"], first["matrix_stride"]) == ("offset = 64", 64, 16)
    assert (second["offset"], second["stride"]) == (128, 48)
    assert [item["offset"] for item in second["members"]] == [0, 16]
    assert block(placed, "m")["size"] == 272


PLACES = {
    "float a; vec3 b; float c; vec2 d;": ([0, 16, 28, 32], [0, 16, 28, 32], (48, 48)),
    "float a[3]; vec3 b[2]; float c;": ([0, 48, 80], [0, 16, 48], (96, 64)),
    "mat3 a; mat2x4 b[2]; float c;": ([0, 48, 112], [0, 48, 112], (128, 128)),
    "layout(row_major) mat2x3 a; float b;": ([0, 48], [0, 24], (64, 32)),
    "mat2 a; float b[2][3];": ([0, 32], [0, 16], (128, 48)),
    "float a; layout(align = 32) vec2 b; double c;": ([0, 32, 40], [0, 32, 40], (48, 48)),
    "S a; float b;": ([0, 16], [0, 16], (32, 32)),
    "layout(offset = 8) float a; float b[];": ([8, 16], [8, 12], (16, 16)),
}
"""Members, and where std140 and std430 put them, and how many bytes there are."""


@pytest.mark.parametrize("members", PLACES)
@pytest.mark.parametrize("packing", ["std140", "std430"])
def test_where_members_lie(members: str, packing: str) -> None:
    text = f"""#version 450
        struct S {{ vec2 a; float b; }};
        layout({packing}) buffer B {{ {members} }};
        void main() {{ gl_Position = vec4(a[0]); }}"""
    if "S a" in members:
        text = text.replace("a[0]", "a.b")
    elif not any(word in members for word in ("a[3]", "mat")):
        text = text.replace("a[0]", "a")
    elif "mat" in members:
        text = text.replace("a[0]", "a[0][0]")
    module, facts = read(Source("t.vert", text), "vertex")
    (entry,) = reflected([(module, facts, "vertex")])
    assert isinstance(entry, StorageBlockInput)
    std140, std430, sizes = PLACES[members]
    wanted = std140 if packing == "std140" else std430
    assert [item.offset for item in entry.members] == wanted
    assert entry.size == sizes[packing == "std430"]
    assert [item.read for item in entry.members] == [True, *[False] * (len(wanted) - 1)]


def test_others_are_placed_by_the_driver() -> None:
    found = block("uniform B { mat4 m; vec4 t; } b;", "b.m")
    assert "size" not in found
    assert found["members"] == [
        {"name": "m", "type": "mat4"},
        {"name": "t", "type": "vec4", "read": False},
    ]


DEFAULTS = {
    "float u = 2;": [2.0],
    "vec3 u = vec3(1.0, 2.0, 3.0 * 4.0);": [1.0, 2.0, 12.0],
    "mat2 u = mat2(3.0);": [3.0, 0.0, 0.0, 3.0],
    "float u[2] = float[2](1.0, -0.5);": [1.0, -0.5],
    "bool u = true;": [1.0],
    "float u = 1.0 / 0.0;": "1.0 / 0.0",
    "vec2 u = 2.0 * vec2(gl_MaxDrawBuffers);": "2.0 * vec2(gl_MaxDrawBuffers)",
    "vec3 u;": None,
}


@pytest.mark.parametrize("declared", DEFAULTS)
def test_what_the_shader_initialises_is_told(declared: str) -> None:
    at = "[0]" if "[2]" in declared else "[0][0]" if "mat" in declared else ""
    inputs = inputs_of(f"uniform mat4 u_m; uniform {declared}", f"float(u{at}) * u_m")
    if "vec" in declared:
        inputs = inputs_of(f"uniform mat4 u_m; uniform {declared}", "u.x * u_m")
    assert inputs["u"].get("default") == inputs["sc_previous_u"].get("default")
    assert inputs["u"].get("default") == DEFAULTS[declared]


SAMPLERS = {
    "sampler2D": ("2D", "float"),
    "isampler3D": ("3D", "int"),
    "usampler2DArray": ("2D", "uint", "layers"),
    "samplerCubeArrayShadow": ("cube", "float", "layers", "compares"),
    "sampler2DMS": ("2D", "float", "multisampled"),
    "sampler2DRectShadow": ("rectangle", "float", "compares"),
    "isamplerBuffer": ("buffer", "int"),
    "sampler1D": ("1D", "float"),
    "samplerExternalOES": ("2D", "float", "external"),
}


@pytest.mark.parametrize("kind", SAMPLERS)
def test_samplers_have_a_kind(kind: str) -> None:
    text = f"#version 330\nuniform {kind} u;\nout vec4 o;\nvoid main() {{ o = vec4(1.0); }}"
    if "External" in kind:
        extension = "GL_OES_EGL_image_external_essl3"
        head = f"#version 310 es\n#extension {extension} : require\nprecision mediump float;"
        text = text.replace("#version 330", head)
    elif "CubeArray" in kind:
        text = text.replace("330", "400")
    module, facts = read(Source("t.frag", text), "fragment")
    (entry,) = reflected([(module, facts, "fragment")])
    assert isinstance(entry, SamplerInput)
    words = ("layers", "compares", "multisampled", "external")
    said = {word for word in words if getattr(entry, word)}
    assert (entry.dimension, entry.component, said) == (*SAMPLERS[kind][:2], {*SAMPLERS[kind][2:]})


def test_kinds_that_a_vertex_shader_alone_may_have() -> None:
    text = """#version 450
        layout(std430, binding = 1) buffer B { vec4 all[]; } b;
        layout(rgba8, binding = 2) uniform image2D u_image;
        layout(binding = 3) uniform atomic_uint u_count;
        void main() { gl_Position = b.all[0] + imageLoad(u_image, ivec2(0)); }"""
    module, facts = read(Source("t.vert", text), "vertex")
    block, image, counter = reflected([(module, facts, "vertex")])
    assert isinstance(block, StorageBlockInput) and (block.name, block.binding) == ("B", 1)
    assert isinstance(image, ImageInput) and (image.name, image.binding) == ("u_image", 2)
    assert isinstance(counter, CounterInput)
    assert (counter.name, counter.binding) == ("u_count", 3)
    (member,) = block.members
    assert (member.name, member.type, member.dims) == ("all", "vec4[]", (0,))
    assert (member.offset, member.stride, member.read) == (0, 16, True)
    assert (block.packing, block.matrices) == ("std430", "column_major")


def test_uniforms_samplers_and_attributes() -> None:
    inputs = inputs_of(
        "struct E { mat4 m; }; layout(location = 4) uniform E u_e[2]; uniform float u_f;",
        "u_e[1].m * u_f",
        more="layout(binding = 2) uniform sampler2D u_map; layout(location = 9) uniform vec3 u_l;",
        read="textureLod(u_map, v_p.xy, 0.0).x + u_l.x",
    )
    place = {"kind": "uniform", "type": "E[2]", "dims": [2]}
    place |= {"members": [{"name": "m", "type": "mat4"}]}
    assert inputs["u_e"] == place | {"name": "u_e", "stages": ["vertex"], "location": 4}
    assert inputs["sc_previous_u_e"] == place | {
        "name": "sc_previous_u_e",
        "stages": ["vertex"],
        "location": None,
        "previous_of": "u_e",
    }
    assert inputs["u_f"]["location"] is None
    assert (inputs["u_map"]["kind"], inputs["u_map"]["binding"]) == ("sampler", 2)
    assert inputs["u_l"]["location"] == 9
    assert inputs["a_position"]["kind"] == "attribute"
    assert "previous_of" not in inputs["a_position"]


def test_a_block_of_both_stages_is_listed_once() -> None:
    text = "layout(binding = 5) uniform B { mat4 m; vec4 t; } b;"
    inputs = inputs_of(text, "b.m", more=text.replace("layout(binding = 5) ", ""), read="b.t.x")
    assert inputs["B"]["stages"] == ["vertex", "fragment"]
    assert inputs["B"]["binding"] == 5
    assert inputs["sc_previous_B"]["stages"] == ["vertex"]


@pytest.mark.parametrize(
    ("declared", "read", "name", "kind"),
    [
        ("in float tint; uniform mat4 u_m;", "u_m * tint", "tint", "attribute"),
        ("uniform tint { mat4 m; };", "m", "tint", "uniform block"),
    ],
)
def test_one_name_of_two_kinds_is_two_inputs(
    declared: str, read: str, name: str, kind: str
) -> None:
    """What stages share by name are their uniforms; other names are each stage's own."""
    manifest = manifest_of(declared, read, more=f"uniform float {name};", read=name)
    found = [(i["kind"], i["stages"]) for i in manifest["inputs"] if i["name"] == name]
    assert found == [(kind, ["vertex"]), ("uniform", ["fragment"])]
    twins = [i["kind"] for i in manifest["inputs"] if i.get("previous_of") == name]
    assert twins == [kind] * (kind != "attribute")
    assert plain(decode(manifest, "m")) == manifest


def test_every_name_of_a_pass_is_listed() -> None:
    manifest = manifest_of("uniform B { mat4 m; }; uniform mat4 u_m;", "m * u_m")
    known = {item["name"] for key in ("inputs", "uniforms") for item in manifest[key]}
    passes = [item for variant in manifest["variants"] for item in variant["passes"]]
    for item in (*passes, manifest["original"], manifest["payload"], manifest["debug"]):
        assert known.issuperset((*item["uniforms"], *item["attributes"]))


def test_what_no_program_declares_is_not_listed() -> None:
    inputs = inputs_of("uniform mat4 u_m;", "u_m", more="uniform B { vec4 t; };", read="t.x")
    assert inputs["B"]["stages"] == ["fragment"]
    assert "sc_previous_B" not in inputs


@pytest.mark.parametrize(
    ("text", "read", "told"),
    [
        ("uniform mat4 u_m;", "u_m", (False, False)),
        ("uniform B { mat4 m; };", "m", (True, True)),
        ("uniform B { mat4 m; vec4 t; }; uniform mat4 u_m;", "t.x * u_m", (True, True)),
    ],
)
def test_what_is_to_be_bound_is_told(text: str, read: str, told: tuple[bool, bool]) -> None:
    frame = " ".join(manifest_of(text, read)["frame"])
    assert ("binding point 0" in frame, "is the twin of the block" in frame) == told
    with_block = " ".join(manifest_of(more="uniform B { vec4 t; };", read="t.x")["frame"])
    assert "binding point 0" in with_block
    assert "is the twin of the block" not in with_block

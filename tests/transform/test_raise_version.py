"""Shaders of older versions in the words of GLSL 3.30 core and GLSL ES 3.00."""

from __future__ import annotations

import pytest
from verify_tree import verify_module

from shadercache.ast.walk import walk
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.lang.builtins import function_names, overloads
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.transform.versions.legacy_calls import modern_name
from shadercache.transform.versions.raise_version import Raised, StageTree, raise_versions
from shadercache.valid.validate import validate
from tests.configured import rewritten

EXTERNAL = (
    "#version 100\n#extension GL_OES_EGL_image_external : require\nprecision mediump float;\n"
)


def tree(text: str, stage: Stage = "fragment") -> StageTree:
    source = Source(f"a.{stage[:4]}", text)
    module = parse(source)
    return StageTree(module, validate(module, source, stage), source, stage)


def raised(*texts: str, stem: str = "legacy_") -> list[Raised]:
    stages: tuple[Stage, ...] = ("fragment", "vertex")
    made = raise_versions([tree(*pair) for pair in zip(texts, stages, strict=False)], stem)
    for item, stage in zip(made, stages, strict=False):
        verify_module(item.module, stage)
    return made


def text_of(text: str) -> str:
    return print_module(raised(text)[0].module)


def analysis_of(fragment: str, vertex: str) -> Analysis:
    return analyse(Source("a.frag", fragment), Source("a.vert", vertex))


@pytest.mark.parametrize(
    "text",
    (
        "#version 330\nout vec4 c; void main() { c = vec4(1.0); }",
        "#version 450 core\nout vec4 c; void main() { c = vec4(1.0); }",
        "#version 320 es\nprecision highp float; out vec4 c; void main() { c = vec4(1.0); }",
    ),
)
def test_what_can_hold_variants_stays_as_it_is(text: str) -> None:
    given = tree(text)
    (made,) = raise_versions([given], "legacy_")
    assert made.module is given.module
    assert not made.notes
    assert not made.renamed


@pytest.mark.parametrize(
    ("head", "expected"),
    (
        ("", "#version 330 core"),
        ("#version 120\n", "#version 330 core"),
        ("#version 150 compatibility\n", "#version 330 core"),
        ("#version 430 compatibility\n", "#version 430 core"),
        ("#version 330\n", "#version 330"),  # a second target cannot stand beside gl_FragColor
        ("#version 100\n", "#version 300 es"),
    ),
)
def test_versions(head: str, expected: str) -> None:
    text = text_of(f"{head}void main() {{ gl_FragColor = vec4(1.0); }}")
    assert text.startswith(f"{expected}\n")
    precision = "mediump " if "es" in expected else ""
    assert f"out {precision}vec4 legacy_FragColor;" in text


def test_every_texture_function_of_old_has_a_counterpart() -> None:
    old = {name: modern_name(name) for name in function_names() if modern_name(name)}
    assert old["shadow2DRectProjGradARB"] == "textureProjGrad"
    assert old["texture1DArrayLod"] == "textureLod"
    assert old["texelFetch2DRect"] == "texelFetch"
    assert old["textureSizeCube"] == "textureSize"
    assert len(old) > 60
    for name, new in old.items():
        assert new is not None
        known = [[param.type for param in item.params] for item in overloads(new)]
        for item in overloads(name):
            kinds = [param.type for param in item.params]
            assert kinds in known or kinds[0].name == "samplerExternalOES", f"{item}"


def test_shadows_keep_their_four_components() -> None:
    head = "#version 120\nuniform sampler2DShadow s; varying vec4 p;\n"
    text = text_of(head + "void main() { gl_FragColor = shadow2DProj(s, p); }")
    assert "legacy_FragColor = vec4(vec3(textureProj(s, p)), 1.0);" in text


def test_elements_of_frag_data_are_outputs_of_their_own() -> None:
    text = text_of("void main() { gl_FragData[0] = vec4(1.0); gl_FragData[2] = vec4(0.5); }")
    assert "layout(location = 0) out vec4 legacy_FragColor;" in text
    assert "layout(location = 2) out vec4 legacy_FragData_2;" in text
    text = text_of("uniform int i; void main() { gl_FragData[i] = vec4(1.0); }")
    assert "out vec4 legacy_FragData[8];" in text


def test_arrays_of_both_stages_are_of_one_size() -> None:
    made = raised(
        "void main() { gl_FragColor = gl_TexCoord[1]; }",
        "varying vec4 gl_TexCoord[4];\n"
        "void main() { gl_TexCoord[2] = gl_MultiTexCoord1; gl_Position = ftransform(); }",
    )
    fragment, vertex = (print_module(stage.module) for stage in made)
    assert "in vec4 legacy_TexCoord[4];" in fragment
    assert "out vec4 legacy_TexCoord[4];" in vertex
    assert "gl_Position = legacy_ModelViewProjectionMatrix * legacy_Vertex;" in vertex
    assert "legacy_Vertex" in made[1].renamed.values()


def test_a_declared_array_keeps_its_size() -> None:
    text = text_of(
        "#version 120\nvarying vec4 gl_TexCoord[2]; uniform int i;\n"
        "vec4 sum(vec4 t[2]) { return t[0] + t[1]; }\n"
        "void main() { gl_FragColor = sum(gl_TexCoord) + gl_TexCoord[i]; }"
    )
    assert "in vec4 legacy_TexCoord[2];" in text


def test_an_array_that_is_indexed_by_a_variable_has_room() -> None:
    text = text_of("uniform int i; void main() { gl_FragColor = gl_LightSource[i].diffuse; }")
    assert "uniform legacy_LightSourceParameters legacy_LightSource[8];" in text
    assert "specular" not in text, "fields that nobody reads need no value"


def test_the_colour_goes_from_stage_to_stage() -> None:
    fragment, vertex = raised(
        "void main() { gl_FragColor = gl_Color + gl_SecondaryColor; }",
        "void main() { gl_FrontColor = gl_Color; gl_FrontSecondaryColor = vec4(0.0);\n"
        "gl_BackColor = gl_Color; gl_Position = gl_Vertex; }",
    )
    assert "in vec4 legacy_FrontColor;" in print_module(fragment.module)
    text = print_module(vertex.module)
    assert "out vec4 legacy_FrontColor;" in text
    assert "legacy_FrontColor = legacy_Color;" in text
    assert set(vertex.renamed) == {"gl_Color", "gl_Vertex"}


def test_names_that_the_new_version_takes_are_renamed_everywhere() -> None:
    made = raised(
        "#version 110\nvarying vec2 smooth; uniform float round;\n"
        "struct flat { float uint; }; float inverse(float x) { return x; }\n"
        "void main() { flat f; f.uint = inverse(round) + smooth.x; gl_FragColor = vec4(f.uint); }",
        "#version 110\nvarying vec2 smooth; attribute vec2 uint;\n"
        "void main() { smooth = uint; gl_Position = vec4(uint, 0.0, 1.0); }",
    )
    fragment, vertex = (print_module(stage.module) for stage in made)
    assert "in vec2 legacy_smooth;" in fragment
    assert "out vec2 legacy_smooth;" in vertex
    assert "struct legacy_flat" in fragment
    assert "f.legacy_uint = legacy_inverse(legacy_round) + legacy_smooth.x;" in fragment
    assert made[0].renamed == {"round": "legacy_round", "gl_FragColor": "legacy_FragColor"}
    assert made[1].renamed == {"uint": "legacy_uint"}


def test_functions_and_variables_of_1_10_have_their_own_names() -> None:
    text = text_of(
        "#version 110\nfloat f; float f(float x) { return x; }\n"
        "void main() { f = f(2.0); gl_FragColor = vec4(f); }"
    )
    assert "legacy_f = f(2.0);" in text


def test_a_function_that_hides_a_built_in_one() -> None:
    text = text_of("#version 130\nfloat round(float x) { return x; } void main() { round(1.0); }")
    assert "float legacy_round(float x)" in text
    assert "legacy_round(1.0);" in text


def test_a_variable_goes_on_hiding_a_function() -> None:
    text = text_of("#version 130\nuniform float round; out vec4 c; void main() { c.x = round; }")
    assert "uniform float round;" in text


def test_a_struct_that_only_has_a_name() -> None:
    text = text_of("#version 120\nvoid main() { gl_FogParameters f = gl_Fog; }")
    assert "float density;" in text


def test_extensions_that_are_core_are_dropped() -> None:
    text = text_of(
        "#version 120\n#extension GL_ARB_texture_rectangle : require\n"
        "#extension GL_ARB_gpu_shader5 : enable\nvoid main() { gl_FragColor = vec4(1.0); }"
    )
    assert "GL_ARB_texture_rectangle" not in text
    assert "#extension GL_ARB_gpu_shader5 : enable" in text


def test_invariant_inputs_of_es() -> None:
    head = "#version 100\nprecision mediump float; invariant varying vec2 v;\n"
    text = text_of(head + "void main() { gl_FragColor = vec4(v, v); }")
    assert "in vec2 v;" in text
    assert "invariant" not in text
    head = "#version 100\ninvariant gl_FragCoord; invariant gl_FragColor;\n"
    text = text_of(head + "void main() { gl_FragColor = gl_FragCoord; }")
    assert "invariant legacy_FragColor;" in text
    assert "gl_FragCoord;" in text.partition("main")[2]
    assert "gl_FragCoord" not in text.partition("main")[0]


def test_constants_of_the_fixed_function_pipeline() -> None:
    text = text_of("#version 120\nvoid main() { gl_FragColor = vec4(float(gl_MaxLights)); }")
    assert "legacy_FragColor = vec4(float(8));" in text


def test_spans_point_into_the_users_text() -> None:
    source = "#version 120\nuniform sampler2D t; varying vec2 v;\n" + (
        "void main() { gl_FragColor = texture2D(t, v); }"
    )
    (made,) = raised(source)
    spelled = {source[node.span.start : node.span.end] for node in walk(made.module)}
    assert {"texture2D(t, v)", "gl_FragColor", "v"} <= spelled


def test_a_parameter_that_es_1_00_hides() -> None:
    text = text_of(
        "#version 100\nprecision mediump float; float f(float x) { float x = x; return x; }\n"
        "void main() { gl_FragColor = vec4(f(1.0)); }"
    )
    assert "float f(float x)" in text
    assert "float x_1 = x;" in text


def test_textures_of_cameras() -> None:
    text = text_of(
        "#version 100\n#extension GL_OES_EGL_image_external : require\nprecision mediump float;\n"
        "uniform samplerExternalOES s; void main() { gl_FragColor = texture2D(s, vec2(0.5)); }"
    )
    assert "#extension GL_OES_EGL_image_external_essl3 : require" in text
    assert "legacy_FragColor = texture(s, vec2(0.5));" in text


def test_what_cannot_be_raised_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    given = tree("void main() { gl_FragColor = vec4(1.0); }")
    found = Diagnostic("SC201", "undeclared variable 'x'", given.source)

    def complain(*_: object) -> None:
        raise InputError(found)

    monkeypatch.setattr("shadercache.transform.versions.raise_version.validate", complain)
    with pytest.raises(InputError) as caught:
        raise_versions([given], "legacy_")
    (item,) = caught.value.diagnostics
    assert item.code == "SC412"
    assert item.message == (
        "the shader cannot be raised to GLSL 3.30 core: undeclared variable 'x'"
    )


def test_the_manifest_says_what_is_renamed() -> None:
    analysis = analysis_of(
        "varying vec3 n;\nvoid main() { gl_FragColor = vec4(sin(n) * cos(n.yzx) + exp(n), 1.0); }",
        "varying vec3 n;\nvoid main() { n = gl_Normal; gl_Position = ftransform(); }",
    )
    node = next(item for item in analysis.nodes if item.offered)
    manifest = rewritten(analysis, node).manifest
    assert manifest.renamed == {
        "gl_FragColor": "legacy_FragColor",
        "gl_Normal": "legacy_Normal",
        "gl_ModelViewProjectionMatrix": "legacy_ModelViewProjectionMatrix",
        "gl_Vertex": "legacy_Vertex",
    }
    assert manifest.previous == {
        "legacy_ModelViewProjectionMatrix": "sc_previous_legacy_ModelViewProjectionMatrix"
    }
    assert [note.code for note in analysis.notes] == ["SC410", "SC411"] + ["SC410"] + ["SC411"] * 3
    assert analysis.reads_fixed_function


def test_names_of_the_user_that_begin_like_ours() -> None:
    analysis = analysis_of(
        "varying vec3 legacy_n;\nvoid main() { gl_FragColor = vec4(sin(legacy_n), 1.0); }",
        "varying vec3 legacy_n;\nvoid main() { legacy_n = gl_Normal; gl_Position = gl_Vertex; }",
    )
    assert analysis.renamed["gl_Normal"] == "legacy1_Normal"

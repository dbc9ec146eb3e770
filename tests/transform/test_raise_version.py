"""Shaders of older versions in the words of GLSL 3.30 core and GLSL ES 3.00."""

from __future__ import annotations

import pytest
from verify_tree import verify_module

from shadercache.analysed import written
from shadercache.ast.walk import walk
from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.parse import parse
from shadercache.lang.builtins import function_names, overloads
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.transform.versions.legacy_calls import modern_name
from shadercache.transform.versions.raise_version import Raised, StageTree, raise_versions
from shadercache.valid.validate import validate
from tests.configured import rewritten


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


def test_spans_point_into_the_users_text() -> None:
    source = "#version 120\nuniform sampler2D t; varying vec2 v;\n" + (
        "void main() { gl_FragColor = texture2D(t, v); }"
    )
    (made,) = raised(source)
    spelled = {source[node.span.start : node.span.end] for node in walk(made.module)}
    assert {"texture2D(t, v)", "gl_FragColor", "v"} <= spelled


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
    assert written(analysis) is None


def test_names_of_the_user_that_begin_like_ours() -> None:
    analysis = analysis_of(
        "varying vec3 legacy_n;\nvoid main() { gl_FragColor = vec4(sin(legacy_n), 1.0); }",
        "varying vec3 legacy_n;\nvoid main() { legacy_n = gl_Normal; gl_Position = gl_Vertex; }",
    )
    assert analysis.renamed["gl_Normal"] == "legacy1_Normal"

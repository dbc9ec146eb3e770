"""The built-in functions of every version, profile and stage, against glslang's own table."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lang.glslang_tables import table

from shadercache.lang.builtins import function_names, functions
from shadercache.lang.words import ES_VERSIONS, VERSIONS, type_names
from tests.glslang import needs_glslang

# glslang has them before the specification does, or has what no specification knows.
LEFT_OUT = re.compile(
    r"mix$|textureOffset$|textureGather|textureQueryL|controlBarrier|texelGradFetch|texelProj|atomic|imageAtomic"
    r"|memoryBarrier$|(begin|end)InvocationInterlock|absoluteDifference|addSaturate|average"
    r"|count(Leading|Trailing)Zeros|multiply32x16|subtractSaturate|dFd[xy]|fwidth|interpolateAt"
    r"|subgroup|textureGrad$|(texture|shadow)([123]D|Cube)(Proj)?$|debugPrintf|sparse|(all|any)Invocation|read(First)?Invocation|ballot|\w+(AMD|ARB|KHR|EXT|NV|QCOM)$"
)
# Levels and biases of shadow maps (GL_EXT_texture_shadow_lod): glslang 15 lists no extension there.
SHADOW_LEVELS = re.compile(
    r"texture float\(sampler(2DArrayShadow, vec4, float|CubeArrayShadow, vec4, float, float)\)"
    r"|textureLod(Offset)? float\(sampler(2DArray|Cube|CubeArray)Shadow, vec4, float"
)
# Section 8 has them, and glslang later or not at all.
ADDED = re.compile(
    r"(texture|shadow)\w*Lod$|inverse|determinant|memoryBarrier\w+|interpolateAt\w+"
    r"|texelFetch|textureSize|imageAtomicCompSwap|atomicCompSwap"
)
_WORD = re.compile(r"[A-Za-z_]\w*")

TABLES = [
    (version, profile, stage)
    for version in (*VERSIONS, *ES_VERSIONS)
    for profile in (
        ("es",)
        if version in ES_VERSIONS
        else (None, "compatibility")
        if version >= 150
        else (None,)
    )
    for stage in ("fragment", "vertex")
]


@needs_glslang
@pytest.mark.parametrize(("version", "profile", "stage"), TABLES)
def test_8_functions_are_those_of_glslang(
    version: int, profile: str | None, stage: str, tmp_path: Path
) -> None:
    kinds = type_names(version, profile == "es")
    head = str(version) if profile is None or version == 100 else f"{version} {profile}"
    theirs = {
        f"{name} {signature}"
        for name, signatures in table(head, stage, tmp_path).items()
        for signature in signatures
        if kinds.issuperset(_WORD.findall(signature))
    }
    ours = {
        f"{name} {signature.result}({', '.join(str(param.type) for param in signature.params)})"
        for name in function_names()
        for signature in functions(name, version, profile, stage)
    }
    missing = {line for line in theirs - ours if not LEFT_OUT.match(line.split()[0])}
    missing = {line for line in missing if not SHADOW_LEVELS.match(line)}
    assert not missing
    added = {line for line in ours - theirs if not ADDED.match(line.split()[0])}
    assert not added
    assert len(ours & theirs) > 100


EXTENDED = frozenset(
    (
        *("GL_EXT_shader_explicit_arithmetic_types", "GL_ARB_sparse_texture2"),
        "GL_ARB_sparse_texture_clamp",
    )
)
_OF_THESE = re.compile(r"sparse|\w+ClampARB|.*\b(f16|[iu]16|[iu]8|float16|u?int16|u?int8)")
# Half-float samplers, biases of gathers, subgroups and the like are of other extensions still; the
# specification of clamps knows no rectangles, and 3 components are misspelt there.
_OF_OTHERS = re.compile(
    r".*\bf16(sampler|image)|subgroup|coop|atomic|image|absoluteDifference|\w+(AMD|INTEL|NV)\b"
    r"|(add|subtract)Saturate|average|count(Leading|Trailing)|multiply32|(min|max|mid)3"
    r"|sparseTextureGather.*, int, float\)|.*Grad\w*ARB .*CubeArrayShadow"
    r"|\w*ClampARB.*Rect|hal[fh]BitsToInt16 i16vec3|sparseImage|sparseTexel\w*Grad"
)


@needs_glslang
def test_functions_of_extensions_are_those_of_glslang(tmp_path: Path) -> None:
    theirs = {
        f"{name} {signature}"
        for name, signatures in table("450", "fragment", tmp_path, extended=True).items()
        for signature in signatures
    }
    ours = {
        f"{name} {signature.result}({', '.join(str(param.type) for param in signature.params)})"
        for name in function_names()
        for signature in functions(name, 450, None, "fragment", EXTENDED)
    }
    wanted, found = (
        {line for line in lines if _OF_THESE.match(line) and not _OF_OTHERS.match(line)}
        for lines in (theirs, ours)
    )
    assert wanted == found
    assert len(wanted) > 900

"""Built-in functions and variables, against glslang."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from sema.tools import checked

from shadercache.ast.nodes import Call
from shadercache.lang.builtins import (
    Parameter,
    Signature,
    function_names,
    functions,
    variable,
    variable_names,
)
from shadercache.lang.types import Type
from shadercache.lang.words import type_names
from shadercache.sema.facts import Stage
from tests.glslang import PROBES, bad_lines, needs_glslang, probe

DERIVATIVES = {"dFdx", "dFdy", "fwidth"}
# A name of an extension, and functions that take nothing but an input variable.
NOT_CALLABLE = ("textureQueryLOD", "interpolateAt")
# Images and atomic counters need layouts; the test of the whole table has their functions.
MEMORY = type_names(420) - type_names(410)


def one(name: str, params: str, version: int = 330) -> Signature:
    """The only overload with these parameters."""
    found = [s for s in functions(name, version) if str(s).split("(", 1)[1] == params + ")"]
    assert len(found) == 1, [str(s) for s in functions(name, version)]
    return found[0]


def test_signatures() -> None:
    assert str(one("sin", "vec3")) == "vec3 sin(vec3)"
    assert str(one("mix", "vec2, vec2, bvec2")) == "vec2 mix(vec2, vec2, bvec2)"
    assert str(one("modf", "vec4, out vec4")) == "vec4 modf(vec4, out vec4)"
    assert str(one("texture", "usampler2D, vec2")) == "uvec4 texture(usampler2D, vec2)"
    assert str(one("textureOffset", "sampler2D, vec2, ivec2, float"))
    assert str(one("transpose", "mat2x3")) == "mat3x2 transpose(mat2x3)"
    assert str(one("outerProduct", "vec3, vec2")) == "mat2x3 outerProduct(vec3, vec2)"
    assert functions("nothing", 330) == ()


def test_no_overload_is_listed_twice() -> None:
    for name in function_names():
        for version in (330, 460):
            listed = [tuple(p.type for p in s.params) for s in functions(name, version)]
            assert len(listed) == len(set(listed)), name


def test_versions() -> None:
    assert not functions("fma", 330)
    assert functions("fma", 400)
    assert not functions("textureQueryLod", 140)
    assert functions("textureQueryLod", 400)
    assert not functions("packHalf2x16", 400)
    assert functions("packHalf2x16", 420)
    assert functions("texture2D", 330)
    assert not functions("texture2D", 420)
    assert functions("texture2D", 420, "compatibility")
    assert "dvec2" not in {str(s.result) for s in functions("sqrt", 330)}
    assert "dvec2" in {str(s.result) for s in functions("sqrt", 400)}
    assert functions("packHalf2x16", 300, "es")
    assert not functions("texture2D", 300, "es")


def test_flags() -> None:
    for name in function_names():
        for signature in functions(name, 460):
            assert signature.derivative == name.startswith(tuple(DERIVATIVES)), name
            assert not (signature.derivative and signature.foldable is False)
            if signature.implicit_lod:
                assert signature.texture
    assert one("texture", "sampler2D, vec2").implicit_lod
    assert one("texture", "sampler2D, vec2, float").implicit_lod
    assert one("texture2D", "sampler2D, vec2").implicit_lod
    assert one("textureProjOffset", "sampler2D, vec3, ivec2").implicit_lod
    assert one("textureQueryLod", "sampler2D, vec2", 400).implicit_lod
    for name in ("textureLod", "textureGrad", "texelFetch", "textureSize", "textureGather"):
        assert not any(s.implicit_lod for s in functions(name, 460)), name
    # Rectangle textures have one level only.
    assert not one("texture", "sampler2DRect, vec2").implicit_lod


def test_out_parameters() -> None:
    outs = {
        name
        for name in function_names()
        for signature in functions(name, 460)
        if any(p.direction != "in" for p in signature.params)
    }
    atomics = {f"atomic{name}" for name in ("Add", "Min", "Max", "And", "Or", "Xor")}
    integers = {"uaddCarry", "usubBorrow", "umulExtended", "imulExtended"}
    assert outs == {"modf", "frexp", *integers, *atomics, "atomicExchange", "atomicCompSwap"}


def test_vertex_shaders_have_no_derivatives_and_no_bias() -> None:
    assert not functions("dFdx", 330, None, "vertex")
    params = {len(s.params) for s in functions("texture", 330, None, "vertex")}
    assert params == {2}
    assert not functions("textureQueryLod", 400, None, "vertex")


def argument(index: int, parameter: Parameter) -> tuple[str, str]:
    """A declaration and an expression for one argument."""
    kind = parameter.type
    if parameter.constant:
        zeros = ", ".join([f"{kind.name}(0)"] * (kind.dims[0] or 1)) if kind.dims else "0"
        return "", f"{kind}({zeros})"
    name = f"a{index}_{kind}".replace("[", "_").replace("]", "")
    return f"{'uniform ' if kind.is_opaque else ''}{kind} {name};\n", name


def all_signatures(version: int, stage: Stage) -> list[Signature]:
    names = [name for name in function_names() if not name.startswith(NOT_CALLABLE)]
    found = [s for name in names for s in functions(name, version, None, stage)]
    return [s for s in found if not any(p.type.name in MEMORY for p in s.params) and not s.memory]


def every_call(version: int, stage: Stage) -> tuple[str, list[str]]:
    """Declarations for, and calls of, every overload of every built-in function."""
    declarations: dict[str, None] = {}
    calls = []
    for signature in all_signatures(version, stage):
        args = [argument(i, p) for i, p in enumerate(signature.params)]
        declarations.update((text, None) for text, _ in args)
        calls.append(f"{signature.name}({', '.join(name for _, name in args)})")
    return "".join(declarations), calls


def probed(kind: Type, call: str) -> str:
    """A statement that pins the type of a call, for the types that probes know."""
    known = f" sc_id({kind.name} v)" in PROBES and not kind.dims
    return probe(call, str(kind)) if known else call


@needs_glslang
@pytest.mark.parametrize(
    ("version", "stage"), [(330, "fragment"), (330, "vertex"), (400, "fragment"), (450, "fragment")]
)
def test_8_every_function_is_known_to_glslang(tmp_path: Path, version: int, stage: Stage) -> None:
    declarations, calls = every_call(version, stage)
    signatures = all_signatures(version, stage)
    head = f"#version {version}\n{PROBES}{declarations}void main() {{\n"
    lines = [f"{probed(s.result, c)};\n" for s, c in zip(signatures, calls, strict=True)]
    file = tmp_path / f"all.{stage[:4]}"
    file.write_text(head + "".join(lines) + "}\n")
    bad = bad_lines(file)
    first = head.count("\n") + 1
    refused = {str(signatures[line - first]): error for line, error in bad.items()}
    assert not refused


@pytest.mark.parametrize(
    ("version", "stage"), [(330, "fragment"), (330, "vertex"), (450, "fragment")]
)
def test_8_every_function_resolves_to_its_overload(version: int, stage: Stage) -> None:
    declarations, calls = every_call(version, stage)
    body = "".join(f"{call};\n" for call in calls)
    module, facts = checked(f"#version {version}\n{declarations}void main() {{\n{body}}}\n", stage)
    main = facts.functions[0]
    found = [facts.calls[call] for call in facts.called[main] if isinstance(call, Call)]
    assert found == all_signatures(version, stage)
    assert module.version == version


@needs_glslang
@pytest.mark.parametrize("stage", ["fragment", "vertex"])
def test_7_every_variable_is_known_to_glslang(tmp_path: Path, stage: Stage) -> None:
    lines = []
    for name in variable_names():
        found = variable(name, stage, 330)
        if found is not None:
            use = f"{name}[0]" if found.type.is_array else name
            use = f"{name}.far" if found.type.is_struct else use
            lines.append(f"{{ bool b = {use} == {use}; }}\n")
    text = f"#version 330\nvoid main() {{\n{''.join(lines)}}}\n"
    file = tmp_path / f"all.{stage[:4]}"
    file.write_text(text)
    assert not bad_lines(file)
    checked(text, stage)


def test_7_variables() -> None:
    coord = variable("gl_FragCoord", "fragment")
    assert coord is not None
    assert (str(coord.type), coord.storage) == ("vec4", "in")
    assert variable("gl_FragCoord", "vertex") is None
    position = variable("gl_Position", "vertex")
    assert position is not None
    assert position.storage == "out"
    buffers = variable("gl_MaxDrawBuffers", "fragment")
    assert buffers is not None
    assert (buffers.storage, buffers.value) == ("const", 8)
    depth = variable("gl_DepthRange", "vertex")
    assert depth is not None
    assert depth.type.struct is not None
    assert list(depth.type.struct.fields) == ["near", "far", "diff"]
    assert variable("gl_FragColor", "fragment", 420) is None
    assert variable("gl_ModelViewMatrix", "vertex") is None
    assert variable("gl_ModelViewMatrix", "vertex", 330, "compatibility") is not None
    assert variable("gl_Nothing") is None


def test_the_tables_are_read_on_demand() -> None:
    """Importing the module reads no data file."""
    code = (
        "from shadercache.lang import builtins\n"
        "assert not builtins._index.cache_info().currsize\n"
        "assert builtins.functions('mix', 330)\n"
        "assert builtins._index.cache_info().currsize\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr

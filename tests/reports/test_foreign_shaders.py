"""Shaders in other languages, and ones that a tool is to put together first: every command that
reads a shader says in one sentence what it is and what to do."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from shadercache.cli.app import main

FOLDER = Path(__file__).with_name("foreign")

SAMPLES = {
    "water.gdshader": "a shader in Godot's own language; give the GLSL that Godot makes of it",
    "sections.glsl": "a file of several sections for Godot; save the text below",
    "compute.glsl": "a file of several sections for Godot; save the text below",
    "glslify.frag": "a file that glslify is to put together; give what 'glslify FILE' prints",
    "three.frag": "a shader that three.js is to put together; give the whole text",
    "three.vert": "a shader that three.js is to put together; give the whole text",
    "three_material.frag": "a shader before which three.js puts declarations; give the whole text",
    "three_material.vert": "a shader before which three.js puts declarations; give the whole text",
    "lit.hlsl": "a shader in HLSL; translate it, say with dxc -spirv",
    "unity.shader": "a shader of Unity's ShaderLab; give the GLSL that Unity makes of it",
    "triangle.wgsl": "a shader in WGSL; translate it, say with 'naga",
    "lit.metal": "a shader in Metal's language; give the GLSL that it was made from",
    "toy.glsl": "a file of Shadertoy, which has no main; --dialect shadertoy reads it",
}

BY_SUFFIX = ("lit.hlsl", "triangle.wgsl", "lit.metal", "water.gdshader")

VERTEX = """#version 330
in vec3 a_position;
void main() { gl_Position = vec4(a_position, 1.0); }
"""
FRAGMENT = "#version 330\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n"


@dataclass(frozen=True)
class Told:
    """What a command left."""

    status: int
    out: str
    err: str

    def only(self, name: str, what: str) -> None:
        """It is one diagnostic, of this file, which says what it is."""
        assert self.status == 1
        first, *rest = self.err.splitlines()
        place, _, said = first.partition(": error: this is ")
        assert place.startswith(f"{name}:") and said.startswith(what), self.err
        assert said.endswith(" [SC112]") and len(rest) == 2, self.err
        assert "|" in rest[0] and "^" in rest[1]


Command = Callable[..., Told]


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Command:
    def call(*words: object, stdin: bytes = b"") -> Told:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin)))
        return Told(main([str(word) for word in words]), *capsys.readouterr())

    return call


@pytest.mark.parametrize("name", SAMPLES)
def test_check_and_nodes_say_what_it_is(command: Command, name: str) -> None:
    path = FOLDER / name
    told = command("check", path)
    told.only(str(path), SAMPLES[name])
    assert told.out == "1 file: 1 with 1 error\n"
    if not name.endswith(".vert"):
        told = command("nodes", path)
        told.only(str(path), SAMPLES[name])
        assert told.out == ""


@pytest.mark.parametrize("name", ["water.gdshader", "three.frag", "triangle.wgsl", "lit.hlsl"])
@pytest.mark.parametrize("verb", ["rewrite", "verify", "run", "bench", "sweep"])
def test_every_command_says_it(command: Command, tmp_path: Path, verb: str, name: str) -> None:
    node = ("--node", "x") if verb in ("rewrite", "run") else ()
    out = tmp_path / ("out.db" if verb == "sweep" else "out")
    written = () if verb == "verify" else ("-o", out)
    told = command(verb, FOLDER / name, *node, *written)
    told.only(str(FOLDER / name), SAMPLES[name])
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "name", ["three.vert", "three_material.vert", "water.gdshader", "lit.hlsl"]
)
def test_vertex_shaders(command: Command, tmp_path: Path, name: str) -> None:
    fragment = tmp_path / "own.frag"
    fragment.write_text(FRAGMENT)
    path = FOLDER / name
    command("nodes", fragment, "--vert", path).only(str(path), SAMPLES[name])
    told = command("rewrite", fragment, "--vert", path, "--node", "x", "-o", tmp_path / "out")
    told.only(str(path), SAMPLES[name])
    command("check", "--stage", "vertex", path).only(str(path), SAMPLES[name])


@pytest.mark.parametrize("name", SAMPLES)
def test_from_stdin(command: Command, name: str) -> None:
    told = command("check", "-", stdin=(FOLDER / name).read_bytes())
    told.only("<stdin>", SAMPLES[name])


@pytest.mark.parametrize("name", SAMPLES)
def test_whatever_the_file_is_called(command: Command, tmp_path: Path, name: str) -> None:
    data = (FOLDER / name).read_bytes()
    upper = Path(name.upper())
    for path, text in (
        (tmp_path / "shader", data),
        (tmp_path / upper, data),
        (tmp_path / f"mark{upper.suffix}", b"\xef\xbb\xbf" + data),
        (tmp_path / f"dos{upper.suffix.lower()}", data.replace(b"\n", b"\r\n")),
        (tmp_path / "called.frag", data),
    ):
        path.write_bytes(text)
        stage = ("--stage", "vertex") if name.endswith(".vert") else ()
        command("check", *stage, path).only(str(path), SAMPLES[name])


@pytest.mark.parametrize("name", BY_SUFFIX)
def test_a_suffix_tells_where_the_text_does_not(
    command: Command, tmp_path: Path, name: str
) -> None:
    path = tmp_path / f"plain{Path(name).suffix}"
    path.write_text("float4 tint() { return float4(1, 1, 1, 1); }\n")
    command("check", path).only(str(path), SAMPLES[name])


def test_each_of_several_files(command: Command) -> None:
    names = ("water.gdshader", "lit.hlsl")
    told = command("check", *(FOLDER / name for name in names))
    assert told.status == 1 and told.out == "2 files: 2 with 2 errors\n"
    assert told.err.count("[SC112]") == 2 and told.err.count("error:") == 2


def test_another_dialect_reads_what_is_shadertoys(command: Command) -> None:
    for dialect in ("shadertoy", "auto"):
        assert command("check", FOLDER / "toy.glsl", "--dialect", dialect).status == 0


def test_a_module_of_glslify_is_glsl_where_nothing_is_missing(command: Command) -> None:
    assert command("check", FOLDER / "glslify_module.glsl").status == 0


def test_chunks_that_are_there_are_included(command: Command, tmp_path: Path) -> None:
    (tmp_path / "common").write_text("#define PI 3.14159\n")
    path = tmp_path / "own.frag"
    path.write_text("#include <common>\nvoid main() { gl_FragColor = vec4(PI) }\n")
    told = command("check", path, "-I", tmp_path, "--no-glslang")
    assert "expected ';'" in told.err and "SC112" not in told.err
    path.write_text("#include <common>\nvoid main() { gl_FragColor = vec4(PI); }\n")
    assert command("check", path, "-I", tmp_path).status == 0


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("#include <lighting>\nvoid main() { gl_FragColor = vec4(1.0); }", "SC123"),
        ("#define float3 vec3\n#define saturate(x) clamp(x, 0.0, 1.0)\n"
         "void main() { gl_FragColor = vec4(float3(saturate(y)), 1.0); }", "SC201"),
        ("#version 330\nout vec4 c; // SV_Target\nvoid main() { c = tex2D(a, b); }", "SC201"),
        ("float3 tint;\nvoid main() { gl_FragColor = vec4(tint, 1.0); }", "SC103"),
        ("float4 color;", "SC103"),
        ("/* @fragment fn main() */ void main() { vec3 x = 1.0 }", "SC103"),
    ],
)  # fmt: skip
def test_glsl_with_a_mistake_is_told_its_mistake(
    command: Command, tmp_path: Path, text: str, code: str
) -> None:
    path = tmp_path / "own.frag"
    path.write_text(f"{text}\n")
    told = command("check", path, "--no-glslang")
    assert told.status == 1
    assert f"[{code}]" in told.err and "SC112" not in told.err


def test_text_of_16_bits_is_told(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "wide.hlsl"
    path.write_bytes(b"\xff\xfe" + FRAGMENT.encode("utf-16-le"))
    for verb in ("check", "nodes", "verify"):
        told = command(verb, path)
        assert told.status == 1 and "[SC001]" in told.err and told.err.count("error:") == 1


def test_suffixes_of_stages_in_capitals(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "SHADER.VERT"
    path.write_text(VERTEX)
    assert command("check", path).status == 0

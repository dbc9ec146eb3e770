"""Qualifiers are printed in an order that glslang and Mesa take, whatever order they came in."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations
from pathlib import Path

import pytest
from compiled import Pair, errors_of_driver, errors_of_reference, pairs_of

from shadercache.compiler import Emission, analyse, emit_original
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.gpu.context import Gpu
from shadercache.source import Source
from shadercache.valid.read import read
from tests.configured import configured, rewritten

FOLDER = Path(__file__).parent / "qualifier_order"
FILES = sorted(path.name for path in FOLDER.iterdir())
PAIRS = [Path(name).stem for name in FILES if name.endswith(".vert")]


def printed(name: str) -> str:
    return print_module(parse(Source(name, (FOLDER / name).read_text("utf-8"))))


def partner(name: str) -> Pair:
    """The printed shader with the one of the other stage: its own, or an empty one."""
    stem, _, stage = name.rpartition(".")
    vertex, fragment = f"{stem}.vert", f"{stem}.frag"
    if vertex in FILES and fragment in FILES:
        return printed(vertex), printed(fragment)
    given = (FOLDER / name).read_text("utf-8").split("\n", 1)[0]
    inputs = "out vec3 v_p; out vec3 v_n;"
    assert stage == "frag"
    return f"{given}\n{inputs}\nvoid main() {{ gl_Position = vec4(1.0); }}\n", printed(name)


@pytest.mark.parametrize("name", FILES)
def test_glslang_takes_what_is_printed(name: str, tmp_path: Path) -> None:
    assert not errors_of_reference([partner(name)], tmp_path)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", FILES)
def test_the_driver_takes_what_is_printed(name: str, gpu: Gpu) -> None:
    assert not errors_of_driver(gpu, [partner(name)])


def emissions(name: str) -> Iterator[Emission]:
    """The original, and where the shader may be cached a node of it, in both modes."""
    frag, vert = (
        Source(f, (FOLDER / f).read_text("utf-8")) for f in (f"{name}.frag", f"{name}.vert")
    )
    analysis = analyse(frag, vert)
    node = next(node for node in analysis.nodes if node.offered)
    for mode in ("plain", "proof"):
        yield emit_original(analysis, mode)
        yield rewritten(analysis, node, configured(mode=mode))


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", PAIRS)
def test_every_variant_compiles(name: str, gpu: Gpu, tmp_path: Path) -> None:
    try:
        programs = [pair for emission in emissions(name) for pair in pairs_of(emission)]
    except InputError as error:
        pytest.skip(f"is refused: {error}")
    assert not errors_of_reference(programs, tmp_path)
    assert not errors_of_driver(gpu, programs)


KINDS = {
    "block": (("readonly", "layout(std430)", "buffer", "coherent"), "Name{0} {{ vec4 at{0}[]; }};"),
    "block of all": (("restrict", "readonly", "volatile", "buffer"), "Name{0} {{ vec4 at{0}; }};"),
    "image": (("readonly", "layout(rgba8)", "uniform", "restrict"), "image2D name{0};"),
    "precise image": (("writeonly", "highp", "uniform", "coherent"), "image2D name{0};"),
    "input": (("flat", "centroid", "in", "highp"), "vec4 name{0};"),
    "located input": (("noperspective", "sample", "in", "layout(location = {0})"), "vec4 name{0};"),
    "output": (("precise", "out", "highp", "layout(location = {0})"), "vec4 name{0};"),
    "uniform": (("uniform", "mediump", "layout(location = {0})"), "vec4 name{0};"),
    "constant": (("const", "highp"), "float name{0} = 1.0;"),
    "block of uniforms": (("uniform", "layout(std140)"), "Name{0} {{ vec4 at{0}; }};"),
    "parameter": (("const", "in", "highp"), "vec4 name{0}"),
    "precise parameter": (("precise", "inout", "highp"), "vec4 name{0}"),
    "parameter of images": (("readonly", "restrict", "highp", "coherent"), "image2D name{0}"),
}
"""Qualifiers that may stand in any order in GLSL 4.50, and what they stand before."""

VERTEX = "#version 450 core\nvoid main() { gl_Position = vec4(1.0); }\n"
MOST = 6
"""Declarations in one shader: drivers count locations and units."""


def shaders(kind: str) -> Iterator[str]:
    """Shaders with every order of the kind's qualifiers."""
    words, rest = KINDS[kind]
    orders = list(permutations(words))
    for begin in range(0, len(orders), MOST):
        lines = ["#version 450 core"]
        for number, order in enumerate(orders[begin : begin + MOST]):
            text = f"{' '.join(order)} {rest}".format(number)
            lines.append(text if text.endswith(";") else f"void f{number}({text}) {{}}")
        yield "\n".join([*lines, "void main() {}", ""])


def reprinted(text: str) -> str:
    return print_module(read(Source("test.frag", text), "fragment")[0])


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("kind", KINDS)
def test_every_order_is_printed_in_one_that_compiles(kind: str, gpu: Gpu, tmp_path: Path) -> None:
    programs = [(VERTEX, reprinted(text)) for text in shaders(kind)]
    assert not errors_of_reference(programs, tmp_path)
    assert not errors_of_driver(gpu, programs)


@pytest.mark.parametrize(
    "line",
    [
        "layout(rgba8) uniform readonly image2D a;",
        "layout(rgba8) readonly restrict uniform image2D a;",
        "layout(rgba8) coherent uniform volatile highp image2D a;",
        "layout(std430) readonly restrict buffer A {",
        "restrict volatile buffer A {",
        "smooth centroid in highp vec4 a;",
        "void f(readonly restrict highp image2D a);",
        "void f(const in highp vec4 a);",
    ],
)
def test_a_right_order_stays(line: str) -> None:
    text = f"#version 450\n{line}" + (" vec4 at; };" if line.endswith("{") else "")
    assert line in reprinted(f"{text}\nvoid main() {{}}\n")

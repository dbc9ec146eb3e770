"""Law 1 on shaders of others: the text as it was and our print of it render the same bits.

Each valid fragment shader is drawn once from either text, with a plain vertex shader and the values
that a scene is made with for a shader without one (:mod:`shadercache.linking.made_scene`). It is
done in a child process: one that hangs or crashes with the driver costs one shader.
"""

from __future__ import annotations

import os
import re
import signal
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import count
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from bench.public_shaders.shaders import Shader
from shadercache.ast import nodes as n
from shadercache.ast.large import allow_deep_trees
from shadercache.compiler import Analysis
from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_node
from shadercache.gpu.context import Gpu, open_context
from shadercache.lang.types import Type
from shadercache.linking.made_scene import made_scene
from shadercache.manifest.reflection import inputs_of
from shadercache.processes import spread
from shadercache.render.depth_spec import DepthSpec
from shadercache.render.pass_runners import PassRunner
from shadercache.render.pass_spec import PassSpec
from shadercache.render.render_scene import RenderScene
from shadercache.sema.facts import Facts
from shadercache.source import Source
from shadercache.valid.read import read

SECONDS = 20  # A shader that takes longer hangs, and its process ends.
BATCH = 50  # Shaders that one child draws.

# Mesa runs the oldest shaders in a compatibility profile only; other drivers ignore all of these.
_ENVIRONMENT = {
    "MESA_GL_VERSION_OVERRIDE": "4.6COMPAT",
    "MESA_GLSL_VERSION_OVERRIDE": "460",
    "MESA_SHADER_CACHE_DISABLE": "true",
    "LP_NUM_THREADS": "1",
}


POSITION = "sc_corner"
"""The vertex attribute: the corners of a triangle over the image, which is -1 to 1."""

_IN = re.compile(r"\bin\b")
_FIXED_FUNCTION = re.compile(r"\bgl_(?:TexCoord|Color|SecondaryColor)\b")
_FIXED_OUTPUTS = (*(f"gl_TexCoord[{unit}]" for unit in range(8)), "gl_FrontColor", "gl_BackColor")


class Picture(NamedTuple):
    """What became of drawing a shader: ``same`` is ``None`` where it cannot be drawn at all.

    ``varied``: the image has more than one colour.
    """

    same: bool | None
    varied: bool = False
    why: str = ""


def draw_all(
    pairs: Sequence[tuple[Shader, str]],
    processes: int,
    draw: Callable[[tuple[Shader, str]], Picture] | None = None,
) -> list[Picture]:
    """A picture for each shader with our print of it."""

    pictures = [Picture(None, why="the driver hangs or crashes")] * len(pairs)
    # Processes are replaced now and then, since a driver keeps what it has compiled.
    for first in range(0, len(pairs), BATCH * processes):
        tasks = [(pair,) for pair in pairs[first : first + BATCH * processes]]
        for at, picture in spread(processes, draw or compare, tasks, begin=allow_deep_trees):
            if isinstance(picture, Picture):
                pictures[first + at] = picture
    return pictures


def compare(pair: tuple[Shader, str]) -> Picture:
    """Draw a shader and our print of it; whatever is raised becomes the reason."""
    shader, printed = pair
    signal.alarm(SECONDS)  # Its default action ends the process, in whatever the driver is.
    try:
        images = _draw(Source(shader.file, shader.text), Source("our print", printed))
        one = next(images)
        try:
            other = next(images)
        except InputError as error:
            return Picture(False, why=f"our print: {error.diagnostics[0].message}")
    except InputError as error:
        return Picture(None, why=error.diagnostics[0].message)
    except Exception as error:
        return Picture(None, why=f"{type(error).__name__}: {error}")
    finally:
        signal.alarm(0)
    # Any NaN is as good as another.
    wrong = (one.view("u4") != other.view("u4")) & ~(np.isnan(one) & np.isnan(other))
    pixels = int(wrong.any(axis=-1).sum())
    why = f"{pixels} pixels differ" if pixels else ""
    return Picture(not pixels, bool((one != one[0, 0]).any()), why)


def _draw(original: Source, printed: Source) -> Iterator[NDArray[np.float32]]:
    """Both images, (32, 32, 4) each."""
    module, facts = read(original)
    vertex = Source("plain.vert", plain_vertex(module, facts, original.text))
    # An analysis refuses what cannot be cached; all of it that counts here is what is declared.
    known = SimpleNamespace(
        raised=[SimpleNamespace(module=module, facts=facts)], renamed={}, mapping="screen"
    )
    scene = made_scene(Path(original.name), cast(Analysis, known), Path(vertex.name))
    named = replace(scene.common.inputs, attributes={POSITION: "position"})
    scene = replace(scene, common=replace(scene.common, inputs=named))
    inputs = inputs_of([(module, facts, "fragment")])
    with RenderScene(_gpu(), scene, (32, 32), "rgba32f") as world:
        for text in (original, printed):
            spec = PassSpec(text.name, vertex, text, depth=DepthSpec("<="), inputs=inputs)
            yield PassRunner(world, spec).image(0)


@cache
def _gpu() -> Gpu:
    os.environ.update(_ENVIRONMENT)
    return open_context()


def plain_vertex(module: n.Module, facts: Facts, text: str) -> str:
    """A vertex shader that gives each input a value of a fixed rule, in the same version.

    For ``in vec3 v_normal; flat in ivec2 v_cell;`` it declares both as outputs, and writes ::

        v_normal = vec3(<three different slopes over the image>);
        v_cell = ivec2(1, 2);

    Structs, constants and extensions that the declarations may need are taken over.
    """
    # Version 100 is of ES by its number alone.
    profile = f" {module.profile}" if module.profile and module.version != 100 else ""
    # GLSL before 1.30 and ES before 3.00 have attributes in place of inputs.
    old = module.version < (300 if module.profile == "es" else 130)
    lines = [f"#version {module.version}{profile}"]
    extensions = [line.text for line in module.directives if line.text.startswith("#extension")]
    # Some are of fragment shaders alone.
    lines += [extension.replace("require", "enable") for extension in extensions]
    if module.profile == "es":
        lines += ["precision highp float;", "precision highp int;"]
    lines.append(f"{'attribute' if old else 'in'} vec3 {POSITION};")
    statements = [f"gl_Position = vec4({POSITION}, 1.0);"]
    number = count()
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl | n.BlockDecl):
            continue
        nodes = _declared(decl)
        if decl.qualifiers.has("in", "varying"):
            if not any(node.name.startswith("gl_") for node in nodes):
                lines.append(_IN.sub("out", print_node(decl)))
                for symbol in (facts.declared[node] for node in nodes):
                    statements += _assignments(symbol.name, symbol.type, number)
        elif isinstance(decl, n.VarDecl) and decl.qualifiers.has("const"):
            lines.append(print_node(decl))
        elif isinstance(decl, n.VarDecl) and decl.type.struct is not None and decl.type.name:
            lines.append(print_node(replace(decl, qualifiers=n.NO_QUALIFIERS, declarators=())))
    if _FIXED_FUNCTION.search(text):
        for place in _FIXED_OUTPUTS:
            statements.append(f"{place} = vec4({', '.join(_slope(next(number)) for _ in 'xyzw')});")
    body = "".join(f"    {statement}\n" for statement in statements)
    return "\n".join((*lines, f"void main()\n{{\n{body}}}\n"))


def _declared(decl: n.VarDecl | n.BlockDecl) -> Sequence[n.Declarator | n.BlockDecl]:
    """What a declaration gives names to; a block without an instance does so to its members."""
    if isinstance(decl, n.VarDecl):
        return decl.declarators
    if decl.instance is not None:
        return (decl,)
    return [node for field in decl.fields for node in field.declarators]


def _assignments(place: str, kind: Type, number: Iterator[int]) -> Iterator[str]:
    if kind.is_array:
        for index in range(kind.dims[0] or 1):
            yield from _assignments(f"{place}[{index}]", kind.element, number)
    elif kind.struct is not None:
        for name, member in kind.struct.fields.items():
            yield from _assignments(f"{place}.{name}", member, number)
    elif kind.base is not None:
        real = kind.base in ("float", "double")
        numbers = [next(number) for _ in range(kind.rows * kind.cols)]
        values = [_slope(at) if real else str(1 + at % 3) for at in numbers]
        yield f"{place} = {kind.name}({', '.join(values)});"


def _slope(number: int) -> str:
    """A number between 0 and 1 that changes over the image, each time in another direction."""
    across, up = 0.05 * (1 + number % 4), 0.05 * (1 + number // 4 % 4)
    sign = "-" if number % 2 else "+"
    return f"0.5 + {across:.2f} * {POSITION}.x {sign} {up:.2f} * {POSITION}.y"

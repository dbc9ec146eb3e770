"""Laws 2 to 4 for every built-in function, and every operation on matrices: the value of one, and
what one makes of a value, through a cache."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from laws.builtin_shaders import Shader, shaders, uses

from shadercache.compiler import analyse
from shadercache.gpu.context import Gpu
from shadercache.lang.builtins import function_names, functions
from shadercache.scene.description import load_scene
from shadercache.source import Source
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.cases.cases import FOLDER as CASES

VERTEX = CASES / "shader.vert"
SHADERS = shaders()


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("shader", SHADERS, ids=lambda shader: shader.name)
def test_laws_2_to_4(shader: Shader, gpu: Gpu, cases_folder: Path, tmp_path: Path) -> None:
    path = tmp_path / shader.source.name
    path.write_text(shader.source.text, encoding="utf-8")
    scene = altered(load_scene(cases_folder), fragment=path, vertex=cases_folder / VERTEX.name)
    analysis = analyse(shader.source, Source(VERTEX.name, VERTEX.read_text(encoding="utf-8")))
    by_text = {node.text: node for node in reversed(analysis.nodes)}
    with closing(Verifier(gpu, (scene, analysis), (32, 32))) as verifier:
        verdicts = [verifier.check([by_text[text] for text in item], False) for item in shader.sets]
    assert not {item.text: item.failure or item.broken for item in verdicts if item.broken}


def test_every_function_of_numbers_is_there() -> None:
    there = {use.name for use in uses()}
    for name in function_names():
        calculated = [
            item
            for item in functions(name, 400)
            if item.result.is_float and item.params and all(p.type.is_float for p in item.params)
        ]
        plain = [s for s in calculated if not s.texture and not s.derivative]
        if plain and all(p.direction == "in" for p in plain[0].params):
            assert name in there or name.startswith(("interpolateAt", "noise")), name

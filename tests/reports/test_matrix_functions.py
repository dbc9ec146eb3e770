"""Proof mode loses no bit in functions that drivers take apart: of matrices and of vectors."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from reports.in_scene import analysed, scene_of

from shadercache.gpu.context import Gpu
from shadercache.verify.verifier import Verifier

FOLDER = Path(__file__).with_name("matrix_functions")
PATHS = [pytest.param(path, id=path.stem) for path in sorted(FOLDER.glob("*.frag"))]

NODES = 16
"""At most of each shader: those of ``main`` come first."""


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("path", PATHS)
def test_laws_2_to_4(path: Path, gpu: Gpu, cases_folder: Path) -> None:
    legal = [node for node in analysed(path).nodes if node.legal]
    chosen = sorted(legal, key=lambda node: node.path != "main")[:NODES]
    with closing(
        Verifier(gpu, (scene_of(path, cases_folder), analysed(path)), (40, 40))
    ) as verifier:
        verdicts = [verifier.check(node, plain=False) for node in chosen]
    assert not {item.text: item.failure or item.broken for item in verdicts if item.broken}

"""Proof mode leaves drivers nothing to work out: no zeros (llvmpipe's gallivm takes ``0.0 * x`` for
0, whatever x is), and no arithmetic on matrices (Mesa's temporaries for it are not precise)."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest

from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.verify.verifier import Verifier

pytestmark = pytest.mark.xdist_group("proof")

FOLDER = Path(__file__).parent
SHADERS = sorted(
    path for kind in ("known_zeros", "matrix_arithmetic") for path in (FOLDER / kind).iterdir()
)
SIZE = (32, 32)
NODES = 3
"""Of each shader, spread over it; each takes a second."""


@pytest.mark.parametrize("path", SHADERS, ids=[f"{p.parent.name}/{p.stem}" for p in SHADERS])
def test_laws_2_to_4(path: Path, gpu: Gpu) -> None:
    scene, analysis = open_scene(path, ReadOptions(), None)
    legal = [node for node in analysis.nodes if node.legal]
    nodes = legal[:: -(-len(legal) // NODES)]
    assert len(nodes) >= 2
    with closing(Verifier(gpu, (scene, analysis), SIZE)) as verifier:
        verdicts = [verifier.check(node, plain=False) for node in nodes]
    assert not {item.text: item.failure or item.broken for item in verdicts if item.broken}
